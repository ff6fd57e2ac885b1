// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/chains.h"

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

using Vertices = std::vector<Index>;

std::vector<Chain> cut(std::size_t vertices, const std::vector<VertexPair>& edges,
                       const Vertices& at = {}) {
  std::vector<char> ends(vertices, 0);
  for (const Index v : at) ends[v] = 1;
  return cut_into_chains(EdgeNet(vertices, edges), ends);
}

TEST(EdgeNet, KnowsTheNeighboursOfAVertex) {
  const std::vector<VertexPair> edges{{3, 1}, {1, 0}, {1, 2}};
  const EdgeNet net(5, edges);
  const auto around = net.around(1);
  EXPECT_EQ(Vertices(around.begin(), around.end()), (Vertices{0, 2, 3}));
  EXPECT_EQ(net.degree(4), 0u);
  EXPECT_TRUE(net.has(1, 3) && net.has(3, 1));
  EXPECT_FALSE(net.has(0, 2));
}

TEST(Chains, GoFromEndToEnd) {
  // A path 4 - 0 - 2 - 1 - 3.
  const std::vector<VertexPair> edges{{0, 4}, {0, 2}, {2, 1}, {1, 3}};
  const auto whole = cut(5, edges);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].vertices, (Vertices{3, 1, 2, 0, 4}));
  EXPECT_FALSE(whole[0].closed);
  const auto halves = cut(5, edges, {2});
  ASSERT_EQ(halves.size(), 2u);
  EXPECT_EQ(halves[0].vertices, (Vertices{2, 0, 4}));
  EXPECT_EQ(halves[1].vertices, (Vertices{2, 1, 3}));
}

TEST(Chains, EndWhereOtherThanTwoEdgesMeet) {
  const auto star = cut(5, {{4, 0}, {4, 1}, {4, 2}, {2, 3}});
  ASSERT_EQ(star.size(), 3u);
  EXPECT_EQ(star[0].vertices, (Vertices{0, 4}));
  EXPECT_EQ(star[1].vertices, (Vertices{1, 4}));
  EXPECT_EQ(star[2].vertices, (Vertices{3, 2, 4}));
}

TEST(Chains, CloseWhereNothingEndsThem) {
  const std::vector<VertexPair> loop{{2, 5}, {5, 3}, {3, 1}, {1, 2}};
  const auto closed = cut(6, loop);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_TRUE(closed[0].closed);
  EXPECT_EQ(closed[0].vertices, (Vertices{1, 2, 5, 3}));
  const auto back_to_end = cut(6, loop, {5});
  ASSERT_EQ(back_to_end.size(), 1u);
  EXPECT_FALSE(back_to_end[0].closed);
  EXPECT_EQ(back_to_end[0].vertices, (Vertices{5, 2, 1, 3, 5}));
}

TEST(Chains, TakeEveryEdgeOnce) {
  // Two triangles that share vertex 0, joined to 6 by a tail, and a triangle apart.
  const std::vector<VertexPair> edges{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0},
                                      {0, 5}, {5, 6}, {7, 8}, {8, 9}, {9, 7}};
  std::size_t taken = 0;
  for (const Chain& chain : cut(10, edges)) {
    taken += chain.vertices.size() - (chain.closed ? 0 : 1);
  }
  EXPECT_EQ(taken, edges.size());
}

}  // namespace
}  // namespace evenmesh
