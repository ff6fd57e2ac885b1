// SPDX-License-Identifier: MIT
//
// The move of a single vertex, by hand.
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "evenmesh/classic/angle_based.h"
#include "evenmesh/classic/climb.h"
#include "evenmesh/classic/diffusion.h"
#include "evenmesh/classic/laplacian.h"
#include "evenmesh/classic/optimal_delaunay.h"
#include "evenmesh/classic/worst_shape.h"
#include "tests/classic/star_of.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_classic::Around;
using testing_classic::fan;
using testing_classic::l_shape;
using testing_classic::regular_ring;

void expect_near(const Vec3& found, const Vec3& expected, double tolerance = 1e-14) {
  EXPECT_NEAR((found - expected).norm(), 0.0, tolerance)
      << found.transpose() << " instead of " << expected.transpose();
}

// A star of edges from vertex 0 to all others.
Vec3 move_of(const Rule& rule, const std::vector<Vec3>& x) {
  std::vector<Link> links;
  for (Index v = 1; v < x.size(); ++v) links.push_back({0, v});
  return rule.move({0, links, {}}, x);
}

// ---- laplacian ----

TEST(Laplacian, GoesToTheCentreOfAHexagon) {
  const Vec3 centre(0.3, -0.2, 0.0);
  const Around around(fan(centre, regular_ring(6)), 0);
  expect_near(Laplacian().move(around.star(), around.points()), -centre);
}

TEST(Laplacian, CountsANeighbourOnceHoweverManyCellsShareTheEdge) {
  Cells cells;
  cells.add(CellKind::triangle, std::vector<Index>{0, 1, 2});
  cells.add(CellKind::triangle, std::vector<Index>{0, 2, 3});
  const Around around(Mesh({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}, std::move(cells)), 0);
  expect_near(Laplacian().move(around.star(), around.points()), Vec3(2, 2, 0));
}

TEST(Laplacian, LeavesAVertexWithoutNeighbours) {
  EXPECT_EQ(move_of(Laplacian(), {{1, 2, 3}}), Vec3(0, 0, 0));
}

// ---- forces ----

TEST(Diffusion, ForcesHaveTheirValues) {
  EXPECT_DOUBLE_EQ(force(Force::lennard_jones, 0.5), 8192.0 - 128.0);
  EXPECT_DOUBLE_EQ(force(Force::lennard_jones_printed, 0.5), 8192.0 - 16.0);
  EXPECT_DOUBLE_EQ(force(Force::lennard_jones, 2.0), 1.0 / 8192.0 - 1.0 / 128.0);
  EXPECT_DOUBLE_EQ(force(Force::pliant, 0.5), 0.9375 * std::exp(-0.0625));
  EXPECT_DOUBLE_EQ(force(Force::pliant, 2.0), -15.0 * std::exp(-16.0));
}

TEST(Diffusion, IsInEquilibriumAtTheTargetLengthExactly) {
  for (const Force kind : {Force::lennard_jones, Force::lennard_jones_printed, Force::pliant}) {
    EXPECT_EQ(force(kind, 1.0), 0.0);
    EXPECT_GT(force(kind, 0.999), 0.0);
    EXPECT_LT(force(kind, 1.001), 0.0);
    EXPECT_EQ(move_of(Diffusion(kind, 0.25), {{0, 0, 0}, {0.25, 0, 0}, {0, -0.25, 0}}),
              Vec3(0, 0, 0));
  }
}

TEST(Diffusion, MovesByAFifthOfTheForceInUnitsOfTheTargetLength) {
  // The second neighbour is where it should be, the first twice as far.
  const std::vector<Vec3> x = {{0, 0, 0}, {6, 0, 0}, {0, 3, 0}};
  expect_near(move_of(Diffusion(Force::lennard_jones, 3.0), x),
              Vec3(0.2 * 3.0 * (1.0 / 128.0 - 1.0 / 8192.0), 0, 0));
  expect_near(move_of(Diffusion(Force::pliant, 3.0), x),
              Vec3(0.2 * 3.0 * 15.0 * std::exp(-16.0), 0, 0));
}

TEST(Diffusion, ShortEdgesThrowNobodyFartherThanTheTargetLength) {
  for (const double distance : {0.1, 1e-3, 1e-30, 1e-150}) {
    const std::vector<Vec3> x = {{0, 0, 0}, {distance, 0, 0}, {0, 1, 0}};
    expect_near(move_of(Diffusion(Force::lennard_jones, 1.0), x), Vec3(-1, 0, 0));
  }
}

TEST(Diffusion, StaysFiniteWhereEdgesHaveNoLengthOrAreVeryLong) {
  for (const Force kind : {Force::lennard_jones, Force::lennard_jones_printed, Force::pliant}) {
    EXPECT_TRUE(std::isfinite(force(kind, 0.0)));
    EXPECT_EQ(force(kind, 1e90), kind == Force::pliant ? 0.0 : force(kind, 1e90));
    EXPECT_TRUE(std::isfinite(force(kind, 1e150)));
    EXPECT_EQ(move_of(Diffusion(kind, 1.0), {{2, 2, 2}, {2, 2, 2}}), Vec3(0, 0, 0));
    EXPECT_EQ(move_of(Diffusion(kind, 1.0), {{0, 0, 0}, {1e-300, 0, 0}}), Vec3(0, 0, 0));
    EXPECT_EQ(move_of(Diffusion(kind, 0.0), {{0, 0, 0}, {1, 0, 0}}), Vec3(0, 0, 0));
  }
}

// ---- angle_based ----

TEST(AngleBased, LeavesRegularStars) {
  for (const int n : {3, 4, 6, 7}) {
    const Around around(fan(Vec3(0, 0, 0), regular_ring(n)), 0);
    expect_near(
        AngleBased(around.mesh(), around.orientation()).move(around.star(), around.points()),
        Vec3(0, 0, 0));
  }
}

TEST(AngleBased, HalvesTheAnglesAtTheCornersOfASquare) {
  // From every corner the vertex goes onto the diagonal, at the distance that it has.
  const Around around(shapes::fig5(0.2, 0.0), 4);
  const double far = std::sqrt(0.7 * 0.7 + 0.25) / std::sqrt(2.0);
  const double near = std::sqrt(0.3 * 0.3 + 0.25) / std::sqrt(2.0);
  const Vec3 target((2.0 * far + 2.0 * (1.0 - near)) / 4.0, 0.5, 0.0);
  expect_near(AngleBased(around.mesh(), around.orientation()).move(around.star(), around.points()),
              target - Vec3(0.7, 0.5, 0.0));
}

TEST(AngleBased, DoesNotCareHowCellsAreWound) {
  const Mesh mesh = fan(Vec3(0.2, 0.1, 0), regular_ring(5));
  const Around as_is(mesh, 0);
  const Around mixed(shapes::reversed(mesh, [](std::size_t c) { return c % 2 == 0; }), 0);
  expect_near(AngleBased(as_is.mesh(), as_is.orientation()).move(as_is.star(), as_is.points()),
              AngleBased(mixed.mesh(), mixed.orientation()).move(mixed.star(), mixed.points()));
}

// ---- optimal_delaunay ----

// By the definition: each circumcentre from two equations.
Vec3 mean_of_circumcentres(const std::vector<Vec3>& ring, const Vec3& p) {
  Vec3 sum = Vec3::Zero();
  double areas = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec3 a = ring[k] - p;
    const Vec3 b = ring[(k + 1) % ring.size()] - p;
    Eigen::Matrix2d equations;
    equations << a[0], a[1], b[0], b[1];
    const Eigen::Vector2d centre =
        equations.inverse() * Eigen::Vector2d(0.5 * a.squaredNorm(), 0.5 * b.squaredNorm());
    const double area = 0.5 * equations.determinant();
    sum += area * (p + Vec3(centre[0], centre[1], 0.0));
    areas += area;
  }
  return sum / areas;
}

TEST(OptimalDelaunay, GoesToTheMeanOfTheCircumcentres) {
  shapes::Random random(7);
  std::vector<Vec3> ring = regular_ring(6);
  for (Vec3& p : ring) p += Vec3(0.2 * random.signed_unit(), 0.2 * random.signed_unit(), 0.0);
  const Vec3 centre(0.15, -0.1, 0.0);
  const Around around(fan(centre, ring), 0);
  const OptimalDelaunay rule(around.mesh(), around.orientation());
  expect_near(centre + rule.move(around.star(), around.points()),
              mean_of_circumcentres(ring, centre), 1e-13);
}

TEST(OptimalDelaunay, FindsTheCentreOfASquareAtOnce) {
  // Circumcentres (.5, .04), (.5, .96), (.1714, .5), (1.2667, .5); areas .25, .25, .35, .15.
  const Around around(shapes::fig5(0.2, 0.0), 4);
  const OptimalDelaunay rule(around.mesh(), around.orientation());
  expect_near(rule.move(around.star(), around.points()), Vec3(-0.2, 0, 0));
}

TEST(OptimalDelaunay, FindsTheCentreOfAnOctahedronAtOnce) {
  std::vector<Vec3> x = {{0.2, -0.1, 0.15}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0},
                         {0, -1, 0},        {0, 0, 1}, {0, 0, -1}};
  Cells cells;
  for (Index k = 0; k < 4; ++k) {
    // The vertex is at another place of its tet each time.
    const Index a = 1 + k;
    const Index b = 1 + (k + 1) % 4;
    const std::vector<Index> up[] = {{0, a, b, 5}, {a, 0, 5, b}, {a, b, 0, 5}, {b, a, 5, 0}};
    cells.add(CellKind::tet, up[k]);
    cells.add(CellKind::tet, std::vector<Index>{0, b, a, 6});
  }
  const Around around(Mesh(x, std::move(cells)), 0);
  ASSERT_EQ(around.orientation().type, MeshType::volume);
  const OptimalDelaunay rule(around.mesh(), around.orientation());
  expect_near(rule.move(around.star(), around.points()), Vec3(-0.2, 0.1, -0.15));
}

TEST(OptimalDelaunay, IsNotSentAwayByAFlatTriangle) {
  std::vector<Vec3> ring = regular_ring(4);
  ring.insert(ring.begin() + 1, Vec3(0.5, 0.5, 0.0));  // on the side between its neighbours
  const Around around(fan(Vec3(0.5 - 1e-9, 0.5 - 1e-9, 0.0), ring), 0);
  const OptimalDelaunay rule(around.mesh(), around.orientation());
  EXPECT_LT(rule.move(around.star(), around.points()).norm(), 2.0);
}

// ---- climb ----

TEST(Climb, RaisesTheWorstShapeAround) {
  const Around around(fan(Vec3(0.3, 0.4, 0), l_shape()), 0);
  const WorstShape shapes(around.mesh(), around.orientation());
  const Vec3 move = Climb(around.mesh(), around.orientation()).move(around.star(), around.points());
  std::vector<Vec3> x(around.points().begin(), around.points().end());
  const double before = shapes.of(around.star(), x).shape;
  ASSERT_GT(before, 0.0);
  x[0] += 0.1 * move;
  EXPECT_GT(shapes.of(around.star(), x).shape, before + 1e-3);
  x[0] -= 0.2 * move;
  EXPECT_LT(shapes.of(around.star(), x).shape, before - 1e-3);
}

TEST(Climb, MovesByATenthOfTheEdges) {
  const Around around(shapes::fig5(0.2, 0.0), 4);
  const double mean = 0.5 * (std::hypot(0.7, 0.5) + std::hypot(0.3, 0.5));
  const Vec3 move = Climb(around.mesh(), around.orientation()).move(around.star(), around.points());
  EXPECT_NEAR(move.norm(), 0.1 * mean, 1e-12);
  EXPECT_LT(move[0], 0.0) << "the triangle at the right is the worst";
}

}  // namespace
}  // namespace evenmesh
