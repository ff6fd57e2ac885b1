// SPDX-License-Identifier: MIT
#include "evenmesh/solver/reorder.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "evenmesh/mesh/ordering.h"
#include "evenmesh/quality/quality.h"
#include "evenmesh/solver/objective.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::copy_of;
using testing_setup::problem_of;

TEST(ReorderIfPoor, LeavesAGoodOrderAlone) {
  const Mesh mesh = shapes::irregular_triangles(20000);
  EXPECT_FALSE(reorder_if_poor(mesh, problem_of(mesh)).has_value());
}

class Shuffled : public testing::Test {
 protected:
  void check(const Mesh& mesh) {
    const Problem problem = problem_of(mesh);
    check(mesh, testing_setup::with_edge_costs(mesh, problem), 0.0);
    check(mesh, problem, 1e-12);
  }

  // @param relative  how exact gradients are to be, beside 1e-12
  void check(const Mesh& mesh, const Problem& problem, double relative) {
    const auto reordered = reorder_if_poor(mesh, problem);
    ASSERT_TRUE(reordered.has_value());
    EXPECT_TRUE(has_good_order(reordered->mesh.cells()));

    const std::vector<Vec3> points = copy_of(mesh.points());
    EXPECT_EQ(reordered->from_original(points), copy_of(reordered->mesh.points()));
    EXPECT_EQ(reordered->to_original(reordered->mesh.points()), points);

    // It is the same problem: cost, freedom and quality are what they were.
    EXPECT_EQ(reordered->problem.motion.moving(), problem.motion.moving());
    Workers workers;
    const double cost = Objective(mesh, problem).evaluate(workers, points, {});
    std::vector<Vec3> gradient(points.size());
    std::vector<Vec3> expected(points.size());
    Objective(mesh, problem).evaluate(workers, points, expected);
    EXPECT_NEAR(Objective(reordered->mesh, reordered->problem)
                    .evaluate(workers, reordered->mesh.points(), gradient),
                cost, 1e-12 * cost);
    double steepest = 0.0;
    for (const Vec3& g : expected) steepest = std::max(steepest, g.norm());
    EXPECT_LE(testing_setup::farthest(reordered->to_original(gradient), expected),
              1e-12 + relative * steepest);
    const auto quality = [&](const Mesh& m, const Problem& p) {
      return summarize(workers, measure_cells(workers, m, m.points(), p.orientation));
    };
    const QualitySummary before = quality(mesh, problem);
    const QualitySummary after = quality(reordered->mesh, reordered->problem);
    EXPECT_EQ(after.inverted, before.inverted);
    EXPECT_EQ(after.of(Metric::scaled_jacobian).worst, before.of(Metric::scaled_jacobian).worst);
    EXPECT_EQ(after.of(Metric::shape).median, before.of(Metric::shape).median);
  }
};

TEST_F(Shuffled, TrianglesAreTheSameProblemInABetterOrder) {
  check(shapes::shuffled(shapes::irregular_triangles(20000, 0.3, 1, 0.6), 1));
}

TEST_F(Shuffled, SoAreCellsWoundBothWays) {
  check(shapes::shuffled(shapes::reversed(shapes::triangle_grid(110, 1.0, 0.3),
                                          [](std::size_t c) { return c % 3 == 0; }),
                         2));
}

TEST_F(Shuffled, SoAreSurfaces) { check(shapes::shuffled(shapes::mixed_surface(110), 3)); }

TEST_F(Shuffled, SoAreVolumes) { check(shapes::shuffled(shapes::hex_grid(24, 0.2), 4)); }

}  // namespace
}  // namespace evenmesh
