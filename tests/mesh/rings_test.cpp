// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/rings.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

TEST(Rings, AddTheVerticesOfCellsAround) {
  const Mesh mesh = shapes::quad_grid(6);
  std::vector<char> middle(mesh.point_count(), 0);
  middle[3 * 7 + 3] = 1;
  for (const int rings : {0, 1, 2}) {
    const std::vector<char> around = with_rings(mesh.cells(), middle, rings);
    const auto side = 2 * rings + 1;
    EXPECT_EQ(std::count(around.begin(), around.end(), 1), side * side);
  }
}

}  // namespace
}  // namespace evenmesh
