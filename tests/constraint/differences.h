// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "evenmesh/constraint/function.h"

namespace evenmesh {

/// Expects a function's gradient to be that of its value by central differences.
/// @param tolerance  relative to the largest component; the differences have about 1e-9
inline void expect_true_gradient(const Function& function, std::vector<Vec3> x,
                                 double tolerance = 1e-8) {
  const auto vertices = function.vertices();
  std::vector<Vec3> gradient(vertices.size(), Vec3(7, 7, 7));
  const double value = function.evaluate(x, gradient);
  EXPECT_EQ(value, function.evaluate(x, {}));
  double largest = 0.0;
  for (const Vec3& g : gradient) largest = std::max(largest, g.cwiseAbs().maxCoeff());
  ASSERT_GT(largest, 0.0);

  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (double& coordinate : x[vertices[i]]) {
      constexpr double kStep = 1e-5;
      const double start = coordinate;
      const auto axis = &coordinate - x[vertices[i]].data();
      coordinate = start + kStep;
      const double above = function.evaluate(x, {});
      coordinate = start - kStep;
      const double below = function.evaluate(x, {});
      coordinate = start;
      EXPECT_NEAR(gradient[i][axis], (above - below) / (2.0 * kStep), tolerance * largest)
          << "vertex " << vertices[i] << ", axis " << axis;
    }
  }
}

}  // namespace evenmesh
