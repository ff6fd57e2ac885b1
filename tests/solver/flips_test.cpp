// SPDX-License-Identifier: MIT
//
// No cell turns over that was not, and none that was gets worse.
#include "evenmesh/solver/flips.h"

#include <cmath>

#include <gtest/gtest.h>

#include "evenmesh/solver/smooth.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::copy_of;
using testing_setup::corner_of;
using testing_setup::only;
using testing_setup::problem_of;

void expect_nothing_turned_over(const Mesh& before, const Mesh& after, const Orientation& up) {
  for (std::size_t c = 0; c < before.cells().size(); ++c) {
    const double then = corner_of(before, up, c, before.points());
    const double now = corner_of(after, up, c, after.points());
    if (now > 0.0) continue;
    EXPECT_LE(then, 0.0) << "cell " << c << " has turned over";
    EXPECT_GE(now, then) << "cell " << c << " is further over";
  }
}

TEST(Flips, ATangledMeshDoesNotGetMoreTangled) {
  for (const char* cost : {"local", "global"}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Mesh mesh = shapes::irregular_triangles(2000, 0.3, seed, 0.7);
      const Mesh input = mesh;
      const Problem problem = problem_of(mesh, only(cost));
      const Report report = smooth(mesh, problem);
      ASSERT_GT(report.quality_before.inverted, 0u);
      EXPECT_LT(report.quality_after.inverted, report.quality_before.inverted);
      expect_nothing_turned_over(input, mesh, problem.orientation);
    }
  }
}

TEST(Flips, TangledQuadsAndHexesDoNotGetMoreTangled) {
  for (Mesh mesh : {shapes::quad_grid(12, 1.0, 0.8), shapes::hex_grid(5, 0.7)}) {
    const Mesh input = mesh;
    const Problem problem = problem_of(mesh);
    const Report report = smooth(mesh, problem);
    ASSERT_GT(report.quality_before.inverted, 0u);
    EXPECT_LE(report.quality_after.inverted, report.quality_before.inverted);
    expect_nothing_turned_over(input, mesh, problem.orientation);
  }
}

// A unit square with a tall narrow bump pushed in from below: edge lengths alone draw the interior
// across the bump's flanks.
Mesh bump(int n) {
  Mesh mesh = shapes::triangle_grid(n);
  std::vector<Vec3> points = copy_of(mesh.points());
  for (Vec3& p : points) {
    p[1] += (1.0 - p[1]) * 0.75 * std::exp(-std::pow(p[0] - 0.5, 2) / (2.0 * 0.05 * 0.05));
  }
  mesh.set_points(std::move(points));
  return mesh;
}

TEST(Flips, NothingFoldsAtAReentrantBoundary) {
  for (const char* cost : {"local", "global"}) {
    Mesh mesh = bump(30);
    const Mesh input = mesh;
    const Problem problem = problem_of(mesh, only(cost), "boundary");
    Options options;
    options.judge = Judge::inversion;  // inversion alone is what keeps it from folding
    const Report report = smooth(mesh, problem, options);
    ASSERT_EQ(report.quality_before.inverted, 0u);
    EXPECT_EQ(report.quality_after.inverted, 0u);
    EXPECT_GT(report.held, 0u) << "nothing had to be held: this test proves nothing";
    EXPECT_GT(report.moved, 100u);
    expect_nothing_turned_over(input, mesh, problem.orientation);
  }
}

TEST(Flips, NothingIsShortenedOrPulledBackWhereNothingIsJudged) {
  Mesh mesh = bump(30);
  Problem problem = problem_of(mesh, only("local"), "boundary");
  problem.validity.demanded = false;
  const Report report = smooth(mesh, problem, {.judge = Judge::nothing});
  EXPECT_EQ(report.quality_before.inverted, 0u);
  EXPECT_GT(report.quality_after.inverted, 0u) << "the guard was on, or this test proves nothing";
  EXPECT_EQ(report.held, 0u);
  EXPECT_EQ(report.pulled_back, 0u);
  EXPECT_EQ(report.promise, Promise::lifted);
  EXPECT_EQ(report.stop, Stop::converged);
}

// ---- Flips::find on single cells ----

class OneTriangle : public testing::Test {
 protected:
  std::vector<Index> offenders(const std::vector<Vec3>& input, const std::vector<Vec3>& x,
                               const std::vector<Vec3>& x_new) {
    Cells cells;
    cells.add(CellKind::triangle, std::vector<Index>{2, 0, 1});
    const Layout layout(cells, 3);
    Orientation orientation;
    orientation.type = MeshType::planar;
    orientation.normal = Vec3(0, 0, 1);
    return Flips(layout, input, orientation).find(workers_, x, x_new);
  }
  static std::vector<Vec3> height(double y) { return {{0, 0, 0}, {1, 0, 0}, {0.5, y, 0}}; }

  Workers workers_;
};

TEST_F(OneTriangle, OffendsWhenItTurnsOver) {
  EXPECT_EQ(offenders(height(1), height(1), height(-0.1)), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(offenders(height(1), height(1), height(0)), (std::vector<Index>{0, 1, 2}));
  EXPECT_TRUE(offenders(height(1), height(1), height(1e-9)).empty());
}

TEST_F(OneTriangle, OffendsWhenItIsWorseThanInTheInput) {
  EXPECT_TRUE(offenders(height(-1), height(-1), height(-0.5)).empty());
  EXPECT_TRUE(offenders(height(-1), height(-0.5), height(-0.9)).empty());
  EXPECT_FALSE(offenders(height(-1), height(-0.5), height(-1.1)).empty());
}

TEST_F(OneTriangle, MayBecomePositiveFromAnything) {
  EXPECT_TRUE(offenders(height(-1), height(-1), height(1)).empty());
}

TEST_F(OneTriangle, MayNotTurnBackOnceItIsPositive) {
  EXPECT_FALSE(offenders(height(-1), height(0.5), height(-0.1)).empty());
}

TEST(FlipsFind, NamesEachVertexOnceInOrder) {
  const Mesh mesh = shapes::triangle_grid(3);
  const Layout layout(mesh.cells(), mesh.point_count());
  const Orientation orientation = find_orientation(mesh);
  std::vector<Vec3> mirrored = copy_of(mesh.points());
  for (Vec3& p : mirrored) p[0] = -p[0];
  Workers workers;
  const auto found =
      Flips(layout, mesh.points(), orientation).find(workers, mesh.points(), mirrored);
  ASSERT_EQ(found.size(), mesh.point_count());
  for (std::size_t v = 0; v < found.size(); ++v) EXPECT_EQ(found[v], v);
}

}  // namespace
}  // namespace evenmesh
