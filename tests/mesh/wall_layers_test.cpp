// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/wall_layers.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

// A unit grid whose rows are as thick as a geometric series says, thinnest at the bottom (the least
// coordinate along the axis).
Mesh graded(Mesh mesh, int axis, double first, double growth) {
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  double highest = 0.0;
  for (const Vec3& p : points) highest = std::max(highest, p[axis]);
  const double rows = 6.0;
  for (Vec3& p : points) {
    const double row = std::round(p[axis] / highest * rows);
    p[axis] = growth == 1.0 ? first * row : first * (std::pow(growth, row) - 1.0) / (growth - 1.0);
  }
  mesh.set_points(std::move(points));
  return mesh;
}

std::size_t count_layers(const Mesh& mesh) {
  const std::vector<char> layer = find_wall_layers(mesh, find_orientation(mesh));
  EXPECT_EQ(layer.size(), mesh.cells().size());
  return static_cast<std::size_t>(std::count(layer.begin(), layer.end(), 1));
}

TEST(WallLayers, AreTheFlatRowsOnTheBoundary) {
  // Rows of 0.005, 0.01, 0.02, 0.04, 0.08, 0.16; width 1/6: the first four are flat enough.
  const Mesh mesh = graded(shapes::quad_grid(6), 1, 0.005, 2.0);
  const std::vector<char> layer = find_wall_layers(mesh, find_orientation(mesh));
  for (std::size_t c = 0; c < layer.size(); ++c) EXPECT_EQ(layer[c] != 0, c < 4 * 6) << c;
}

TEST(WallLayers, AreFoundInHexesAndWedges) {
  EXPECT_EQ(count_layers(graded(shapes::hex_grid(6), 2, 0.005, 2.0)), 4u * 36u);
  EXPECT_EQ(count_layers(graded(shapes::hex_grid(6), 0, 0.005, 2.0)), 4u * 36u);
  EXPECT_EQ(count_layers(graded(shapes::wedge_grid(6), 2, 0.005, 2.0)), 4u * 72u);
}

TEST(WallLayers, AreNotSlicesOfOneThickness) {
  EXPECT_EQ(count_layers(graded(shapes::quad_grid(6), 1, 0.01, 1.0)), 0u);
  EXPECT_EQ(count_layers(graded(shapes::hex_grid(6), 2, 0.01, 1.0)), 0u);
}

TEST(WallLayers, AreNotOrdinaryCells) {
  for (const auto& [name, mesh] : shapes::zoo()) EXPECT_EQ(count_layers(mesh), 0u) << name;
  // Nor a surface, however flat its cells.
  EXPECT_EQ(count_layers(graded(shapes::cube_surface(6), 2, 0.005, 2.0)), 0u);
}

TEST(WallLayers, EndBeforeABadCell) {
  Mesh mesh = graded(shapes::quad_grid(6), 1, 0.005, 2.0);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  points[2 * 7 + 3].y() = 0.0;  // of the second and third row; the cells below are turned over
  mesh.set_points(std::move(points));
  const std::vector<char> layer = find_wall_layers(mesh, find_orientation(mesh));
  for (const std::size_t column : {2u, 3u}) {
    for (std::size_t row = 0; row < 6; ++row) EXPECT_EQ(layer[row * 6 + column], 0) << row;
  }
  EXPECT_EQ(layer[0], 1);
}

}  // namespace
}  // namespace evenmesh
