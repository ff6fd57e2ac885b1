// SPDX-License-Identifier: MIT
#include "evenmesh/report/grid.h"

#include <numeric>

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

std::vector<Index> all_vertices(const Mesh& mesh) {
  std::vector<Index> vertices(mesh.point_count());
  std::iota(vertices.begin(), vertices.end(), Index{0});
  return vertices;
}

Grid grid_of(const Mesh& mesh, const Fineness& fineness = {}) {
  const std::vector<Points> states{mesh.points()};
  return choose_grid(mesh.cells(), states, all_vertices(mesh), fineness);
}

TEST(Grid, IsAsFineAsTheBoxAsksFor) {
  const Grid grid = grid_of(shapes::quad_grid(2, 4.0));
  EXPECT_DOUBLE_EQ(grid.step, 4.0 / 65536.0);
  EXPECT_EQ(grid.origin, Vec3(0, 0, 0));
}

TEST(Grid, IsAsFineAsEdgesAskFor) {
  const Grid grid = grid_of(shapes::quad_grid(10, 1.0), {.steps_per_edge = 64, .steps_per_box = 2});
  EXPECT_NEAR(grid.step, 0.1 / 64.0, 1e-12);
}

TEST(Grid, IsNeverTooFineForItsNumbers) {
  const Grid grid = grid_of(shapes::quad_grid(10, 1.0), {.steps_per_edge = 1e12});
  EXPECT_DOUBLE_EQ(grid.step, 1.0 / 268435456.0);
}

TEST(Grid, PlacesPositionsWithinHalfAStep) {
  const Mesh mesh = shapes::moved(shapes::sphere_triangles(3), Vec3(1e4, -3, 0));
  const Grid grid = grid_of(mesh);
  for (const Vec3& p : mesh.points()) {
    const auto place = grid.place(p);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<int>(axis);
      const double back = grid.origin[i] + grid.step * static_cast<double>(place[axis]);
      EXPECT_LE(std::abs(back - p[i]), 0.5001 * grid.step);
    }
  }
}

TEST(Grid, HoldsAPointAndNothing) {
  EXPECT_EQ(choose_grid(Cells(), {}, {}, {}).step, 1.0);
  Cells cells;
  cells.add(CellKind::triangle, std::vector<Index>{0, 0, 0});
  const Grid grid = grid_of(Mesh({{7, 8, 9}}, cells));
  EXPECT_EQ(grid.place({7, 8, 9}), (std::array<std::int64_t, 3>{0, 0, 0}));
}

TEST(Grid, HoldsHugeAndTinyMeshes) {
  for (const double size : {1e-90, 1e90, 1e300}) {
    const Mesh mesh = shapes::scaled(shapes::quad_grid(3), size);
    const auto place = grid_of(mesh).place(mesh.points().back());
    EXPECT_EQ(place[0], 65536) << size;
  }
}

}  // namespace
}  // namespace evenmesh
