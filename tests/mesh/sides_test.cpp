// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/sides.h"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using Key = std::vector<Index>;

/// The obvious way: a map from sorted vertices to cells.
std::map<Key, std::vector<std::size_t>> sides_by_map(const Cells& cells, int dimension) {
  std::map<Key, std::vector<std::size_t>> sides;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const CellKind kind = cells.kind(cell);
    const auto v = cells.vertices(cell);
    if (traits(kind).dimension != dimension) continue;
    std::vector<Key> keys;
    if (dimension == 2) {
      for (int j = 0; j < edge_count(kind, static_cast<int>(v.size())); ++j) {
        const LocalEdge e = edge(kind, static_cast<int>(v.size()), j);
        keys.push_back({v[static_cast<std::size_t>(e.a)], v[static_cast<std::size_t>(e.b)]});
      }
    }
    for (const auto& face : traits(kind).faces) {
      keys.emplace_back();
      for (std::size_t i = 0; i < face.count; ++i) keys.back().push_back(v[face.vertices[i]]);
    }
    for (Key& key : keys) {
      std::sort(key.begin(), key.end());
      key.erase(std::unique(key.begin(), key.end()), key.end());
      if (static_cast<int>(key.size()) >= dimension) sides[key].push_back(cell);
    }
  }
  return sides;
}

TEST(ForEachSide, FindsWhatAMapOfSortedVerticesFinds) {
  for (const auto& [name, original] : shapes::zoo()) {
    for (const Mesh& mesh : {original, shapes::shuffled(original, 7)}) {
      const Cells& cells = mesh.cells();
      for (const int dimension : {2, 3}) {
        auto expected = sides_by_map(cells, dimension);
        for_each_side(cells, mesh.point_count(), dimension, [&](const Side& side) {
          Key key{side.first, side.uses[0].second};
          if (dimension == 3) {
            const auto face = face_vertices(cells, side.uses[0].cell, side.uses[0].face);
            key.assign(face.span().begin(), face.span().end());
            std::sort(key.begin(), key.end());
          }
          std::vector<std::size_t> users;
          for (const SideUse& use : side.uses) users.push_back(use.cell);
          EXPECT_EQ(users, expected[key]) << name;
          expected.erase(key);
        });
        EXPECT_TRUE(expected.empty()) << name;
      }
    }
  }
}

TEST(ForEachSide, SeesNeighboursThatAreWoundAlikeGoOppositeWays) {
  for (const Mesh& mesh : {shapes::triangle_grid(3), shapes::cube_surface(2)}) {
    for_each_side(mesh.cells(), mesh.point_count(), 2, [](const Side& side) {
      if (!side.is_shared_by_two()) return;
      EXPECT_NE(side.uses[0].forward, side.uses[1].forward);
    });
  }
  for (const Mesh& mesh :
       {shapes::tet_grid(2), shapes::hex_grid(2), shapes::wedge_grid(2), shapes::pyramid_grid(2)}) {
    for_each_side(mesh.cells(), mesh.point_count(), 3, [](const Side& side) {
      if (!side.is_shared_by_two()) return;
      EXPECT_NE(side.uses[0].forward, side.uses[1].forward);
    });
  }
}

TEST(ForEachSide, PassesOverSidesWithoutExtent) {
  Cells cells;
  cells.add(CellKind::quad, {{0, 1, 1, 2}});
  cells.add(CellKind::triangle, {{3, 3, 3}});
  int sides = 0;
  for_each_side(cells, 4, 2, [&](const Side& side) {
    ++sides;
    EXPECT_EQ(side.cells, 1u);
  });
  EXPECT_EQ(sides, 3);
}

TEST(ForEachSide, CountsACellOnceThatUsesASideTwice) {
  Cells cells;
  cells.add(CellKind::quad, {{0, 1, 0, 2}});
  cells.add(CellKind::triangle, {{0, 1, 3}});
  std::map<Key, std::pair<std::size_t, std::size_t>> found;
  for_each_side(cells, 4, 2, [&](const Side& side) {
    found[{side.first, side.uses[0].second}] = {side.cells, side.uses.size()};
  });
  EXPECT_EQ(found.at({0, 1}), std::make_pair(std::size_t{2}, std::size_t{3}));
  EXPECT_EQ(found.at({0, 2}), std::make_pair(std::size_t{1}, std::size_t{2}));
}

TEST(ForEachSide, MatchesACollapsedHexWithATet) {
  // A hex whose top is an edge: two of its quads have become triangles.
  Cells cells;
  cells.add(CellKind::hex, {{0, 1, 2, 3, 4, 5, 5, 4}});
  cells.add(CellKind::tet, {{0, 4, 3, 6}});
  std::size_t faces = 0;
  std::size_t shared = 0;
  for_each_side(cells, 7, 3, [&](const Side& side) {
    ++faces;
    shared += side.is_shared_by_two();
  });
  EXPECT_EQ(faces, 5u + 4u - 1u);
  EXPECT_EQ(shared, 1u);
}

}  // namespace
}  // namespace evenmesh
