// SPDX-License-Identifier: MIT
// Cells whose values can be worked out on paper.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "evenmesh/quality/metric.h"
#include "tests/quality/cells.h"

namespace evenmesh {
namespace {

using cells::Corners;
using std::numbers::sqrt2;
using std::numbers::sqrt3;

double degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

double value(Metric metric, CellKind kind, const Corners& corners) {
  return measure(metric, kind, corners, Vec3::Zero());
}

TEST(RightTriangle345, HasTheValuesWorkedOutByHand) {
  const Corners t{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
  const auto of = [&](Metric metric) { return value(metric, CellKind::triangle, t); };
  EXPECT_NEAR(of(Metric::shape), 4 * sqrt3 * 6 / 50, 1e-14);             // 4 sqrt(3) A / sum l^2
  EXPECT_NEAR(of(Metric::scaled_jacobian), 2 / sqrt3 * 12 / 20, 1e-14);  // 2 A / (5 x 4)
  EXPECT_NEAR(of(Metric::min_angle), 36.869897645844021, 1e-12);         // atan(3/4)
  EXPECT_NEAR(of(Metric::max_angle), 90.0, 1e-12);
  EXPECT_NEAR(of(Metric::aspect_ratio), 5 * 12 / (4 * sqrt3 * 6), 1e-14);
  EXPECT_NEAR(of(Metric::edge_ratio), 5.0 / 3, 1e-14);
}

TEST(Rectangle2To1, HasTheValuesWorkedOutByHand) {
  const Corners r{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  const auto of = [&](Metric metric) { return value(metric, CellKind::quad, r); };
  EXPECT_DOUBLE_EQ(of(Metric::shape), 2.0 * 2 / (4 + 1));
  EXPECT_DOUBLE_EQ(of(Metric::scaled_jacobian), 1.0);
  EXPECT_DOUBLE_EQ(of(Metric::min_angle), 90.0);
  EXPECT_DOUBLE_EQ(of(Metric::max_angle), 90.0);
  EXPECT_DOUBLE_EQ(of(Metric::aspect_ratio), 2.0 * 6 / (4 * 2));
  EXPECT_DOUBLE_EQ(of(Metric::edge_ratio), 2.0);
}

TEST(DentedSquare, HasAnAngleOfMoreThan180Degrees) {
  // A notch of 90 degrees from the right to the centre: 270 degrees remain inside.
  const Corners dented{{0, 0, 0}, {1, 0, 0}, {0.5, 0.5, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_NEAR(value(Metric::max_angle, CellKind::polygon, dented), 270.0, 1e-12);
  EXPECT_NEAR(value(Metric::min_angle, CellKind::polygon, dented), 45.0, 1e-12);
  EXPECT_EQ(value(Metric::shape, CellKind::polygon, dented), 0.0);
  EXPECT_LT(value(Metric::scaled_jacobian, CellKind::polygon, dented), 0.0);
}

TEST(Polygon, TakesTheSineOfTheWorstAngleOverThatOfTheRegularOne) {
  // A unit square with a roof of 90 degrees: angles 90, 90, 135, 90, 135.
  const Corners house{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 1.5, 0}, {0, 1, 0}};
  const double regular = std::sin(108.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(value(Metric::scaled_jacobian, CellKind::polygon, house), 0.5 * sqrt2 / regular,
              1e-14);
  EXPECT_NEAR(value(Metric::max_angle, CellKind::polygon, house), 135.0, 1e-12);
  // 4 tan(36 degrees) A = 4 x 0.7265... x 1.25
  EXPECT_NEAR(value(Metric::aspect_ratio, CellKind::polygon, house),
              (3 + sqrt2) / (5 * std::tan(std::numbers::pi / 5)), 1e-14);
}

TEST(CornerOfACube, HasTheValuesWorkedOutByHand) {
  const Corners tet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  // Six squared edges: 3 x 1 + 3 x 2. 6 (sqrt(2) J)^(2/3) / 9 with J = 1.
  EXPECT_NEAR(value(Metric::shape, CellKind::tet, tet), 6 * std::cbrt(2.0) / 9, 1e-14);
  // The longest triple of edges: 1 x sqrt(2) x sqrt(2).
  EXPECT_NEAR(value(Metric::scaled_jacobian, CellKind::tet, tet), sqrt2 / 2, 1e-14);
  EXPECT_NEAR(value(Metric::min_angle, CellKind::tet, tet), degrees(std::acos(1 / sqrt3)), 1e-12);
  EXPECT_NEAR(value(Metric::max_angle, CellKind::tet, tet), 90.0, 1e-12);
  // Surface (3 + sqrt(3)) / 2, volume 1/6: sqrt(2) (3 + sqrt(3)) / 2 / sqrt(6).
  EXPECT_NEAR(value(Metric::aspect_ratio, CellKind::tet, tet), (1 + sqrt3) / 2, 1e-14);
  EXPECT_NEAR(value(Metric::edge_ratio, CellKind::tet, tet), sqrt2, 1e-14);
}

TEST(Box1By2By4, HasTheValuesWorkedOutByHand) {
  Corners box = cells::ideal(CellKind::hex);
  for (Vec3& p : box) p = p.cwiseProduct(Vec3(1, 2, 4));
  EXPECT_NEAR(value(Metric::shape, CellKind::hex, box), 3.0 * 4 / 21, 1e-14);  // J = 8
  EXPECT_DOUBLE_EQ(value(Metric::scaled_jacobian, CellKind::hex, box), 1.0);
  EXPECT_DOUBLE_EQ(value(Metric::min_angle, CellKind::hex, box), 90.0);
  EXPECT_DOUBLE_EQ(value(Metric::max_angle, CellKind::hex, box), 90.0);
  EXPECT_DOUBLE_EQ(value(Metric::aspect_ratio, CellKind::hex, box), 4.0 * 28 / (6 * 8));
  EXPECT_DOUBLE_EQ(value(Metric::edge_ratio, CellKind::hex, box), 4.0);
}

TEST(CubeWithACornerPulledUp, HasTwoAnglesAtTheEdgesOfItsWarpedFace) {
  // From vertex 6 at (1, 1, 2) edges go to (1, 0, 1), (0, 1, 1) and straight down. About either of
  // the upper two the faces make acos(1 / sqrt(3)) there, and 90 degrees at the other end.
  Corners cube = cells::ideal(CellKind::hex);
  cube[6] = Vec3(1, 1, 2);
  EXPECT_NEAR(value(Metric::min_angle, CellKind::hex, cube), degrees(std::acos(1 / sqrt3)), 1e-12);
  // About the edge from vertex 5 to 4: between straight down and 45 degrees up.
  EXPECT_NEAR(value(Metric::max_angle, CellKind::hex, cube), 135.0, 1e-12);
  // The faces beside vertex 6: one of vector area |(-1, -1, 2)| / 2 and two of 3/2; the volume is
  // the integral of 1 + x y.
  EXPECT_NEAR(value(Metric::aspect_ratio, CellKind::hex, cube),
              2 * (1 + 2 * 1 + 2 * 1.5 + std::sqrt(6.0) / 2) / (6 * 1.25), 1e-14);
  EXPECT_NEAR(value(Metric::edge_ratio, CellKind::hex, cube), 2.0, 1e-14);
}

TEST(WallLayerCell, HasAnAspectRatioThatGrowsAsItGetsThinner) {
  for (const double height : {1e-1, 1e-2, 1e-4, 1e-8}) {
    Corners slab = cells::ideal(CellKind::hex);
    for (Vec3& p : slab) p[2] *= height;
    const double expected = (2 + 4 * height) / (6 * height);
    EXPECT_NEAR(value(Metric::aspect_ratio, CellKind::hex, slab), expected, 1e-14 * expected);
  }
}

TEST(TallWedge, HasTheValuesWorkedOutByHand) {
  Corners wedge = cells::ideal(CellKind::wedge);
  for (Vec3& p : wedge) p[2] *= 8.0;
  // T = diag(1, 1, 8) up to rotation: 3 x 8^(2/3) / (1 + 1 + 64)
  EXPECT_NEAR(value(Metric::shape, CellKind::wedge, wedge), 12.0 / 66, 1e-14);
  EXPECT_NEAR(value(Metric::scaled_jacobian, CellKind::wedge, wedge), 1.0, 1e-14);
  EXPECT_NEAR(value(Metric::min_angle, CellKind::wedge, wedge), 60.0, 1e-12);
  EXPECT_NEAR(value(Metric::max_angle, CellKind::wedge, wedge), 90.0, 1e-12);
  // Two triangles of sqrt(3) / 4 and three rectangles of 8; volume 2 sqrt(3).
  EXPECT_NEAR(value(Metric::aspect_ratio, CellKind::wedge, wedge),
              8 * (sqrt3 / 2 + 24) / ((2 + 4 * sqrt3) * 2 * sqrt3), 1e-14);
  EXPECT_NEAR(value(Metric::edge_ratio, CellKind::wedge, wedge), 8.0, 1e-14);
}

TEST(TallPyramid, HasTheValuesWorkedOutByHand) {
  Corners pyramid = cells::ideal(CellKind::pyramid);
  pyramid[4][2] *= 8.0;  // the height, now 8 / sqrt(2); slanting edges sqrt(32.5)
  EXPECT_NEAR(value(Metric::shape, CellKind::pyramid, pyramid), 12.0 / 66, 1e-14);
  EXPECT_NEAR(value(Metric::scaled_jacobian, CellKind::pyramid, pyramid), 8.0 / std::pow(32.5, 1.5),
              1e-14);
  // The base makes atan(16 / sqrt(2)) with a side; two sides whose outer normals are (0, -h, 1/2)
  // and (h, 0, 1/2), h^2 = 32, make acos(-1 / 129).
  EXPECT_NEAR(value(Metric::min_angle, CellKind::pyramid, pyramid), degrees(std::atan(8.0 * sqrt2)),
              1e-12);
  EXPECT_NEAR(value(Metric::max_angle, CellKind::pyramid, pyramid), degrees(std::acos(-1.0 / 129)),
              1e-12);
  // A square of 1 and four triangles of sqrt(32.25) / 2; volume 8 / (3 sqrt(2)).
  EXPECT_NEAR(value(Metric::aspect_ratio, CellKind::pyramid, pyramid),
              std::sqrt(32.5) * (1 + std::sqrt(129.0)) / (8 * (1 + sqrt3)), 1e-14);
  EXPECT_NEAR(value(Metric::edge_ratio, CellKind::pyramid, pyramid), std::sqrt(32.5), 1e-14);
}

TEST(Needle, HasItsAngleToFullPrecision) {
  // tan of the angle is 1e-12: an arc cosine would give 0.
  const Corners needle{{0, 0, 0}, {1, 0, 0}, {1, 1e-12, 0}};
  const double expected = 1e-12 * 180.0 / std::numbers::pi;
  EXPECT_NEAR(value(Metric::min_angle, CellKind::triangle, needle), expected, 1e-12 * expected);
  EXPECT_NEAR(value(Metric::shape, CellKind::triangle, needle), 4 * sqrt3 * 0.5e-12 / 2, 1e-24);
}

TEST(FlatTet, HasItsAngleToFullPrecision) {
  // The apex 1e-12 above the middle of its base, which is sqrt(3) / 6 away from the edges.
  Corners tet = cells::ideal(CellKind::tet);
  tet[3][2] = 1e-12;
  const double expected = degrees(1e-12 * 6 / sqrt3);
  EXPECT_NEAR(value(Metric::min_angle, CellKind::tet, tet), expected, 1e-12 * expected);
}

}  // namespace
}  // namespace evenmesh
