// SPDX-License-Identifier: MIT
#include "apps/evenmesh/cost_text.h"

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/orientation.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

TEST(CostText, GivesNamesAndWeights) {
  EXPECT_TRUE(app::parse_costs("").empty());
  const std::vector<CostChoice> costs = app::parse_costs("local=0.25,barycenter,global=1e-3");
  ASSERT_EQ(costs.size(), 3u);
  EXPECT_EQ(costs[0].name, "local");
  EXPECT_EQ(costs[0].weight, 0.25);
  EXPECT_EQ(costs[1].name, "barycenter");
  EXPECT_EQ(costs[1].weight, 1.0);
  EXPECT_EQ(costs[2].name, "global");
  EXPECT_EQ(costs[2].weight, 1e-3);
}

TEST(CostText, ThatDoesNotParseIsRefused) {
  for (const char* text :
       {",", "local,", "=1", "local=", "local=1x", "local=1e101", "local=1e-101", "local=inf"}) {
    EXPECT_THROW(app::parse_costs(text), InvalidOption) << text;
  }
}

TEST(CostText, ComesBackFromAProblem) {
  const Mesh mesh = shapes::triangle_grid(2);
  Problem problem;
  problem.orientation = find_orientation(mesh);
  problem.motion = Motion(mesh, problem.orientation, std::vector<char>{1, 0, 1, 0, 0, 0, 1, 0, 1});
  EXPECT_EQ(app::cost_text(problem), "");
  add_costs(mesh, {.costs = app::parse_costs("local=0.3,barycenter")}, problem);
  EXPECT_EQ(app::cost_text(problem), "local=0.3,barycenter=1");
}

}  // namespace
}  // namespace evenmesh
