// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "evenmesh/solver/smooth.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::problem_of;

// The unit square with a tall, narrow bump pushed in from below; all cells are valid.
Mesh bump(Index n) {
  std::vector<Vec3> points;
  Cells cells;
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n;
      const double y = static_cast<double>(j) / n;
      const double off = (x - 0.5) / 0.05;
      points.emplace_back(x, y + (1.0 - y) * 0.75 * std::exp(-0.5 * off * off), 0.0);
      if (i == n || j == n) continue;
      const Index a = j * (n + 1) + i;
      cells.add(CellKind::triangle, std::array{a, a + 1, a + n + 2});
      cells.add(CellKind::triangle, std::array{a, a + n + 2, a + n + 1});
    }
  }
  return Mesh(std::move(points), std::move(cells));
}

TEST(MilderCost, IsTakenWhereTheMeanOfShapeWouldFall) {
  Mesh mesh = bump(30);
  const Problem problem = problem_of(mesh);
  const Report report = smooth(mesh, problem);
  EXPECT_TRUE(report.milder_cost);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  for (const Metric metric : {Metric::shape, Metric::scaled_jacobian, Metric::min_angle}) {
    EXPECT_GE(report.quality_after.of(metric).worst, report.quality_before.of(metric).worst);
  }
  const auto& before = report.quality_before.of(Metric::shape);
  const auto& after = report.quality_after.of(Metric::shape);
  EXPECT_GT(after.mean, before.mean + 0.005);
  EXPECT_GT(after.worst, 5.0 * before.worst);
  EXPECT_LT(report.cost_after, report.cost_before);
  EXPECT_DOUBLE_EQ(report.history.front().cost, report.cost_before);
}

TEST(MilderCost, IsLeftAloneWhereTheMeanRises) {
  Mesh mesh = shapes::irregular_triangles(600, 0.4, 3);
  const Problem problem = problem_of(mesh);
  EXPECT_FALSE(smooth(mesh, problem).milder_cost);
}

TEST(MilderCost, IsNotForOtherCosts) {
  Mesh mesh = bump(20);
  Problem problem = problem_of(mesh);
  problem.terms.push_back(problem.terms.front());
  EXPECT_FALSE(smooth(mesh, problem).milder_cost);
}

}  // namespace
}  // namespace evenmesh
