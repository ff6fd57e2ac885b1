// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/measure.h"

#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "evenmesh/geometry/area.h"

namespace evenmesh {
namespace {

std::vector<Vec3> ideal(CellKind kind) {
  std::vector<Vec3> corners;
  for (const auto& p : traits(kind).ideal) corners.emplace_back(p[0], p[1], p[2]);
  return corners;
}

std::vector<Vec3> regular_polygon(int n) {
  std::vector<Vec3> corners;
  const double radius = 0.5 / std::sin(std::numbers::pi / n);
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return corners;
}

constexpr CellKind kVolumes[] = {CellKind::tet, CellKind::hex, CellKind::wedge, CellKind::pyramid};

double least(CellKind kind, const std::vector<Vec3>& corners, double sign = 1.0) {
  return least_corner(
      kind, static_cast<int>(corners.size()),
      [&](int i) -> const Vec3& { return corners[static_cast<std::size_t>(i)]; }, Vec3(0, 0, 1),
      sign);
}

double size_of(CellKind kind, const std::vector<Vec3>& corners,
               const Orientation& orientation = {}) {
  std::vector<Index> vertices(corners.size());
  std::iota(vertices.begin(), vertices.end(), Index{0});
  Cells cells;
  cells.add(kind, vertices);
  return oriented_size(Mesh(corners, std::move(cells)), orientation, 0);
}

std::vector<Vec3> mirrored(std::vector<Vec3> corners) {
  for (Vec3& p : corners) p[0] = -p[0];
  return corners;
}

TEST(OrientedSize, OfIdealCellsIsKnown) {
  const double expected[] = {std::numbers::sqrt2 / 12.0, 1.0, std::numbers::sqrt3 / 4.0,
                             std::numbers::sqrt2 / 6.0};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(size_of(kVolumes[k], ideal(kVolumes[k])), expected[k], 1e-15);
    EXPECT_NEAR(ideal_measure(kVolumes[k], 0), expected[k], 1e-15);
    EXPECT_NEAR(size_of(kVolumes[k], mirrored(ideal(kVolumes[k]))), -expected[k], 1e-15);
  }
}

TEST(OrientedSize, HasASignInThePlaneAndForVolumesButNotInSpace) {
  const std::vector<Vec3> clockwise{{0, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  Orientation plane;
  plane.type = MeshType::planar;
  plane.normal = Vec3(0, 0, 1);
  EXPECT_DOUBLE_EQ(size_of(CellKind::triangle, clockwise, plane), -1.0);
  EXPECT_DOUBLE_EQ(size_of(CellKind::triangle, clockwise), 1.0);
  Orientation left_handed;
  left_handed.type = MeshType::volume;
  left_handed.signs = {-1};
  EXPECT_DOUBLE_EQ(size_of(CellKind::hex, mirrored(ideal(CellKind::hex)), left_handed), 1.0);
}

TEST(OrientedSize, LosesNoDigitsFarFromTheOrigin) {
  for (const CellKind kind : kVolumes) {
    std::vector<Vec3> far = ideal(kind);
    for (Vec3& p : far) p += Vec3(1e6, -1e6, 1e6);
    EXPECT_NEAR(size_of(kind, far), ideal_measure(kind, 0), 1e-9);
  }
}

TEST(IdealMeasure, IsTheAreaOfTheRegularPolygon) {
  for (int n = 3; n <= 12; ++n) {
    const double area = area_vector(regular_polygon(n))[2];
    EXPECT_NEAR(ideal_measure(CellKind::polygon, n), area, 1e-14 * n);
  }
  EXPECT_NEAR(ideal_measure(CellKind::triangle, 3), ideal_measure(CellKind::polygon, 3), 1e-15);
  EXPECT_NEAR(ideal_measure(CellKind::quad, 4), ideal_measure(CellKind::polygon, 4), 1e-15);
}

TEST(LeastCorner, IsTwiceATrianglesArea) {
  EXPECT_DOUBLE_EQ(least(CellKind::triangle, {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}), 6.0);
  EXPECT_DOUBLE_EQ(least(CellKind::triangle, {{0, 0, 0}, {0, 3, 0}, {2, 0, 0}}), -6.0);
}

TEST(LeastCorner, IsSixTimesATetsVolume) {
  const std::vector<Vec3> tet{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  EXPECT_DOUBLE_EQ(least(CellKind::tet, tet), 6.0);
  EXPECT_DOUBLE_EQ(least(CellKind::tet, tet, -1.0), -6.0);
}

TEST(LeastCorner, IsNegativeAtAReflexCornerOfAQuad) {
  EXPECT_DOUBLE_EQ(least(CellKind::quad, {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}), -8.0);
  EXPECT_GT(least(CellKind::quad, {{0, 0, 0}, {4, 0, 0}, {3, 3, 0}, {0, 4, 0}}), 0.0);
}

TEST(LeastCorner, TakesAConcavePolygonAsAWhole) {
  // An arrowhead of area 4 as a polygon of five.
  const std::vector<Vec3> arrow{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  EXPECT_DOUBLE_EQ(least(CellKind::polygon, arrow), 8.0);
}

TEST(LeastCorner, IsPositiveForIdealVolumesAndNegativeForMirroredOnes) {
  for (const CellKind kind : kVolumes) {
    EXPECT_GT(least(kind, ideal(kind)), 0.5) << traits(kind).name;
    EXPECT_LT(least(kind, mirrored(ideal(kind))), -0.5) << traits(kind).name;
    EXPECT_GT(least(kind, mirrored(ideal(kind)), -1.0), 0.5) << traits(kind).name;
  }
}

}  // namespace
}  // namespace evenmesh
