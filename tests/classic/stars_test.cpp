// SPDX-License-Identifier: MIT
#include "evenmesh/classic/stars.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "tests/classic/star_of.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using Ends = std::set<Index>;

Ends ends_of(const Star& star) {
  Ends ends;
  for (const Link& link : star.links) ends.insert(link.to);
  return ends;
}

TEST(Stars, HaveEveryNeighbourAndEveryCellOnce) {
  const testing_classic::Around around(shapes::fig5(0.1, 0.0), 4);
  const Star star = around.star();
  EXPECT_EQ(star.vertex, 4u);
  ASSERT_EQ(star.links.size(), 4u);
  EXPECT_EQ(ends_of(star), (Ends{0, 1, 2, 3}));
  ASSERT_EQ(star.cells.size(), 4u);
  for (const StarCell& cell : star.cells) EXPECT_EQ(cell.at, 4u);
}

TEST(Stars, OfOneColourHaveNoCellInCommon) {
  for (const Mesh& mesh : {shapes::irregular_triangles(300), shapes::tet_grid(3),
                           shapes::mixed_surface(6), shapes::hexagons(4)}) {
    const Orientation orientation = find_orientation(mesh);
    const Motion motion(mesh, orientation, std::vector<char>(mesh.point_count(), 0));
    const Stars stars(mesh, motion);
    std::size_t vertices = 0;
    for (const auto& colour : stars.colours()) {
      EXPECT_TRUE(std::is_sorted(colour.begin(), colour.end()));
      std::set<std::uint32_t> cells;
      for (const Index v : colour) {
        ++vertices;
        for (const StarCell& cell : stars.of(v).cells) {
          EXPECT_TRUE(cells.insert(cell.cell).second) << "cell " << cell.cell << " twice";
        }
      }
    }
    EXPECT_EQ(vertices, motion.moving());
  }
}

TEST(Stars, OfTiedVerticesAreOne) {
  const Mesh mesh = shapes::quad_grid(3);  // vertices 4 and 7 on opposite sides
  const Orientation orientation = find_orientation(mesh);
  std::vector<char> fixed(16, 1);
  fixed[4] = fixed[7] = 0;
  Motion motion(mesh, orientation, fixed);
  motion.tie(7, 4, mesh.points());
  const Stars stars(mesh, motion);
  ASSERT_EQ(stars.colours().size(), 1u);
  EXPECT_EQ(stars.colours()[0], std::vector<Index>{4});
  EXPECT_EQ(ends_of(stars.of(4)), (Ends{0, 5, 8, 3, 6, 11}));
  EXPECT_EQ(stars.of(4).cells.size(), 4u);
}

TEST(Stars, OfACellThatRepeatsAVertexHaveItOnce) {
  Cells cells;
  cells.add(CellKind::triangle, std::vector<Index>{0, 1, 2});
  cells.add(CellKind::triangle, std::vector<Index>{0, 2, 2});
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}}, std::move(cells));
  const Orientation orientation = find_orientation(mesh);
  const Motion motion(mesh, orientation, std::vector<char>(4, 0));
  const Stars stars(mesh, motion);
  EXPECT_EQ(ends_of(stars.of(2)), (Ends{0, 1}));
  EXPECT_EQ(stars.of(2).cells.size(), 2u);
  EXPECT_EQ(motion.moving(), 3u) << "vertex 3 belongs to no cell";
}

}  // namespace
}  // namespace evenmesh
