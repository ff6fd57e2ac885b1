// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/extent.h"

#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

TEST(UnitNormal, MatchesHandComputedValuesAtAnySize) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Index> order{0, 1, 2, 3};
  for (const double size : {1e-300, 1e-150, 1.0, 1e150, 1e300}) {
    std::vector<Vec3> points;
    for (const Vec3& p : square) points.push_back(size * p);
    EXPECT_EQ(unit_normal(points, order), Vec3(0, 0, 1)) << size;
  }
  std::vector<Vec3> huge{
      {-1e308, -1e308, 5}, {1e308, -1e308, 5}, {1e308, 1e308, 5}, {-1e308, 1e308, 5}};
  EXPECT_EQ(unit_normal(huge, order), Vec3(0, 0, 1));
}

TEST(UnitNormal, IsZeroWithoutArea) {
  const std::vector<Vec3> points{{0, 0, 0}, {0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}, {1e6, 1e6, 7}};
  for (const std::vector<Index>& v : std::vector<std::vector<Index>>{
           {0, 1, 2}, {0, 0, 3}, {1, 1, 1}, {0, 3, 0, 3}, {0, 1, 0, 2}}) {
    EXPECT_EQ(unit_normal(points, v), Vec3::Zero());
  }
}

TEST(UnitNormal, AveragesABentQuad) {
  const std::vector<Vec3> points{{0, 0, 1}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  const std::vector<Index> order{0, 1, 2, 3};
  EXPECT_NEAR((unit_normal(points, order) - Vec3(0, 0, 1)).norm(), 0.0, 1e-15);
}

TEST(Volume, OfEveryIdealCellIsTheKnownOne) {
  const std::array<std::pair<CellKind, double>, 4> known{
      {{CellKind::tet, std::sqrt(2.0) / 12.0},
       {CellKind::hex, 1.0},
       {CellKind::wedge, std::sqrt(3.0) / 4.0},
       {CellKind::pyramid, std::sqrt(2.0) / 6.0}}};
  for (const auto& [kind, expected] : known) {
    std::vector<Vec3> points;
    std::vector<Index> order;
    for (const auto& p : traits(kind).ideal) {
      order.push_back(static_cast<Index>(points.size()));
      points.emplace_back(p[0] + 3.0, p[1], p[2]);
    }
    EXPECT_NEAR(volume(kind, points, order, 1.0), expected, 1e-14) << traits(kind).name;
    EXPECT_NEAR(volume(kind, points, order, 2.0), expected / 8.0, 1e-14) << traits(kind).name;
  }
}

TEST(Volume, AddsUpOverAMeshWithWarpedFaces) {
  const Mesh mesh = shapes::hex_grid(4, 0.3);
  double sum = 0.0;
  for (std::size_t cell = 0; cell < mesh.cells().size(); ++cell) {
    sum += volume(CellKind::hex, mesh.points(), mesh.cells().vertices(cell), 1.0);
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
}

}  // namespace
}  // namespace evenmesh
