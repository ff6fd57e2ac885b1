// SPDX-License-Identifier: MIT
#include "apps/evenmesh/target.h"

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "tests/support/shapes.h"

namespace evenmesh::app {
namespace {

TEST(Target, IsAShapeBetweenZeroAndOne) {
  EXPECT_EQ(parse_target(""), std::nullopt);
  EXPECT_EQ(parse_target("shape>=0.3"), 0.3);
  for (const char* wrong : {"shape", "shape>=", "shape>0.3", "shape>=1", "shape>=0", "shape>=-1",
                            "shape>=0.3x", "shape>= 0.3", "skew>=0.3", "shape>=nan"}) {
    EXPECT_THROW(parse_target(wrong), InvalidOption) << wrong;
  }
}

TEST(Target, NamesTheCellsBelow) {
  Mesh mesh = shapes::quad_grid(4);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  points[6].x() += 0.2;  // the only interior corner of cell 0 and one of cells 1, 4 and 5
  mesh.set_points(std::move(points));
  const auto below = cells_below(0.9, mesh, mesh.points(), find_orientation(mesh), 1);
  EXPECT_EQ(below, (std::vector<std::size_t>{0, 1, 4, 5}));
  const std::vector<char> far = vertices_far_from({0}, mesh, 1);
  for (std::size_t v = 0; v < far.size(); ++v) EXPECT_EQ(far[v] != 0, v % 5 > 2 || v / 5 > 2) << v;
}

}  // namespace
}  // namespace evenmesh::app
