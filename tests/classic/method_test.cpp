// SPDX-License-Identifier: MIT
#include "evenmesh/classic/method.h"

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"

namespace evenmesh {
namespace {

TEST(MethodNames, AreReadAsTheyAreWritten) {
  const auto names = method_names();
  ASSERT_EQ(names.size(), 10u);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(method_of(std::string(names[i])), static_cast<Method>(i));
    EXPECT_EQ(name(static_cast<Method>(i)), names[i]);
  }
  EXPECT_EQ(method_of("lagrange_newton"), Method::lagrange_newton);
  EXPECT_EQ(method_of("optimal_delaunay"), Method::optimal_delaunay);
}

TEST(MethodNames, UnknownOnesGetASuggestion) {
  try {
    method_of("lenard_jones");
    FAIL() << "there is no such method";
  } catch (const InvalidOption& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("no method 'lenard_jones' (did you mean 'lennard_jones'?)"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("pliant, angle_based, optimal_delaunay"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace evenmesh
