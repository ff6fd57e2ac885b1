// SPDX-License-Identifier: MIT
#include "evenmesh/solver/lift.h"

#include <cstring>
#include <utility>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/solver/part.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::displaced;
using testing_setup::problem_of;
using testing_setup::with_points;

struct Result {
  Mesh mesh;
  Report report;
  double worst() const { return report.quality_after.of(Metric::shape).worst; }
  double mean() const { return report.quality_after.of(Metric::shape).mean; }
};

Result smoothed(Mesh mesh, const Problem& problem, double lift_below, int threads = 1) {
  Options options;
  options.lift_below = lift_below;
  options.threads = threads;
  Report report = smooth(mesh, problem, options);
  return {std::move(mesh), std::move(report)};
}

Mesh uneven_triangles() { return shapes::irregular_triangles(600, 0.4, 3); }

// The skin, which stays, is uneven too: some cells have to be worse than others.
Mesh uneven_hexes() {
  const Mesh mesh = shapes::hex_grid(5);
  return with_points(mesh, displaced(mesh, problem_of(mesh, {}, "none").motion, 0.03, 5));
}

TEST(Lift, MakesTheWorstCellsBetterAtLittleExpense) {
  const std::pair<Mesh, double> cases[] = {{uneven_triangles(), 0.01}, {uneven_hexes(), 5e-4}};
  for (const auto& [mesh, gain] : cases) {
    const Problem problem = problem_of(mesh);
    const Result without = smoothed(mesh, problem, -1.0);
    const Result with = smoothed(mesh, problem, 0.98);
    EXPECT_EQ(without.report.lifting.cells, 0u);
    EXPECT_GT(with.report.lifting.cells, 0u);
    EXPECT_GT(with.worst(), without.worst() + gain) << mesh.cells().size();
    EXPECT_GT(with.mean(), without.mean() - 0.03);
    EXPECT_GT(with.mean(), with.report.quality_before.of(Metric::shape).mean);
  }
}

TEST(Lift, ReachesATargetWithinReachAndThenStops) {
  const Mesh mesh = uneven_triangles();
  const Problem problem = problem_of(mesh);
  const double target = smoothed(mesh, problem, -1.0).worst() + 0.01;
  const Result result = smoothed(mesh, problem, target);
  EXPECT_GE(result.worst(), target);
  // What is far from the worst cells stays where the cost alone puts it.
  EXPECT_LT(result.report.lifting.cells, mesh.cells().size() / 10);
}

TEST(Lift, LeavesGoodMeshesAlone) {
  const Mesh mesh = shapes::quad_grid(8, 1.0, 0.2);
  const Result result = smoothed(mesh, problem_of(mesh), 0.0);
  EXPECT_EQ(result.report.lifting.cells, 0u);
  EXPECT_EQ(result.report.lifting.iterations, 0);
}

TEST(Lift, KeepsFixedVerticesAndLimitsOfMoves) {
  const Mesh mesh = uneven_triangles();
  Problem problem = problem_of(mesh);
  problem.max_move.assign(mesh.point_count(), 0.004);
  const Result result = smoothed(mesh, problem, 0.98);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    EXPECT_LE((result.mesh.points()[v] - mesh.points()[v]).norm(), 0.004 * (1.0 + 1e-12));
    if (problem.motion.freedom(v) != Motion::Freedom::fixed) continue;
    EXPECT_EQ(std::memcmp(&result.mesh.points()[v], &mesh.points()[v], sizeof(Vec3)), 0) << v;
  }
}

TEST(Lift, HasTheSameBitsForAnyNumberOfThreads) {
  const Mesh mesh = uneven_hexes();
  const Problem problem = problem_of(mesh);
  const Result one = smoothed(mesh, problem, 0.98, 1);
  const Result two = smoothed(mesh, problem, 0.98, 2);
  EXPECT_EQ(
      std::memcmp(one.mesh.points().data(), two.mesh.points().data(), mesh.points().size_bytes()),
      0);
}

TEST(Lift, RejectsAShapeThatNoCellHas) { EXPECT_THROW(check({.lift_below = 1.5}), InvalidOption); }

// A vertex stopped because a cell there was bad at the start moves on once it is not: one cell
// all but flat, in a mesh that could be perfect.
TEST(Lift, LetsGoOfVerticesThatWereStopped) {
  Mesh mesh = shapes::hex_grid(6);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  shapes::Random random(7);
  for (Vec3& p : points) {
    if (p.minCoeff() == 0.0 || p.maxCoeff() == 1.0) continue;
    for (int k = 0; k < 3; ++k) p[k] += 0.045 * random.signed_unit();
  }
  points[3 * 49 + 3 * 7 + 3] = points[4 * 49 + 4 * 7 + 4] - Vec3::Constant(0.02);
  mesh.set_points(std::move(points));
  const Result result = smoothed(mesh, problem_of(mesh), 0.0);
  EXPECT_EQ(result.report.quality_after.inverted, 0u);
  EXPECT_GT(result.worst(), 0.95);
}

TEST(Part, HasTheCellsAroundWhatMovesAndFixesTheRest) {
  const Mesh mesh = shapes::quad_grid(6);
  const Problem problem = problem_of(mesh, {}, "none");
  std::vector<char> moving(mesh.point_count(), 0);
  moving[3 * 7 + 3] = 1;
  const Part part = part_around(mesh, problem, moving);
  EXPECT_EQ(part.cells, (std::vector<std::uint32_t>{14, 15, 20, 21}));
  ASSERT_EQ(part.vertices.size(), 9u);
  EXPECT_EQ(part.problem.motion.moving(), 1u);
  EXPECT_EQ(part.vertices[4], 3u * 7u + 3u);
  EXPECT_NE(part.problem.motion.freedom(4), Motion::Freedom::fixed);
  EXPECT_EQ(part.mesh.points()[4], mesh.points()[24]);
  EXPECT_EQ(part.mesh.cells().vertices(0)[2], 4u);
}

}  // namespace
}  // namespace evenmesh
