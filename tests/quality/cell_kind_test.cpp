// SPDX-License-Identifier: MIT
// The table of mesh/cell_kind.h against the positions of its ideal cells.
#include "evenmesh/mesh/cell_kind.h"

#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "tests/quality/cells.h"

namespace evenmesh {
namespace {

using cells::Corners;
using VertexPair = std::pair<int, int>;

VertexPair sorted_pair(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

std::vector<CellKind> kinds_with_table() {
  std::vector<CellKind> kinds = cells::all_kinds();
  std::erase(kinds, CellKind::polygon);
  return kinds;
}

std::set<VertexPair> edges_of(CellKind kind) {
  std::set<VertexPair> result;
  for (const auto [a, b] : traits(kind).edges) result.insert(sorted_pair(a, b));
  return result;
}

TEST(CellTable, HasIdealCellsWithAllEdgesOfLengthOne) {
  for (const CellKind kind : kinds_with_table()) {
    const Corners p = cells::ideal(kind);
    ASSERT_EQ(static_cast<int>(p.size()), traits(kind).vertices);
    for (const auto [a, b] : traits(kind).edges) EXPECT_NEAR((p[a] - p[b]).norm(), 1.0, 1e-15);
    EXPECT_EQ(edges_of(kind).size(), traits(kind).edges.size()) << "an edge is listed twice";
  }
}

TEST(CellTable, HasRightHandedCornersMadeOfEdges) {
  for (const CellKind kind : kinds_with_table()) {
    const Corners p = cells::ideal(kind);
    const int dimension = traits(kind).dimension;
    for (const auto& [v, n] : traits(kind).corners) {
      for (int k = 0; k < dimension; ++k) EXPECT_TRUE(edges_of(kind).count(sorted_pair(v, n[k])));
      const Vec3 third = dimension == 2 ? cells::kUp : Vec3(p[n[2]] - p[v]);
      EXPECT_GT((p[n[0]] - p[v]).cross(p[n[1]] - p[v]).dot(third), 0.1)
          << traits(kind).name << " vertex " << int{v};
    }
  }
}

TEST(CellTable, HasOneCornerPerVertexButForTheApexOfAPyramid) {
  for (const CellKind kind : kinds_with_table()) {
    std::set<int> seen;
    for (const auto& corner : traits(kind).corners) seen.insert(corner.vertex);
    EXPECT_EQ(seen.size(), traits(kind).corners.size());
    EXPECT_EQ(static_cast<int>(seen.size()),
              traits(kind).vertices - (kind == CellKind::pyramid ? 1 : 0));
  }
}

TEST(CellTable, HasFacesThatLookOutward) {
  for (const CellKind kind : kinds_with_table()) {
    const Corners p = cells::ideal(kind);
    Vec3 centre = Vec3::Zero();
    for (const Vec3& x : p) centre += x / static_cast<double>(p.size());
    for (const auto& [count, v] : traits(kind).faces) {
      const Vec3 normal = (p[v[1]] - p[v[0]]).cross(p[v[2]] - p[v[1]]);
      EXPECT_GT(normal.dot(p[v[0]] - centre), 0.01) << traits(kind).name;
    }
  }
}

TEST(CellTable, HasFacesThatRunThroughEveryEdgeOnceInEachDirection) {
  for (const CellKind kind : kinds_with_table()) {
    if (traits(kind).dimension == 2) continue;
    std::multiset<VertexPair> directed;
    for (const auto& [count, v] : traits(kind).faces) {
      for (int k = 0; k < count; ++k) directed.insert({v[k], v[(k + 1) % count]});
    }
    EXPECT_EQ(directed.size(), 2 * traits(kind).edges.size()) << traits(kind).name;
    for (const auto [a, b] : traits(kind).edges) {
      EXPECT_EQ(directed.count({a, b}), 1u) << traits(kind).name;
      EXPECT_EQ(directed.count({b, a}), 1u) << traits(kind).name;
    }
  }
}

}  // namespace
}  // namespace evenmesh
