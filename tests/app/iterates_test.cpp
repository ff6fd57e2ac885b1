// SPDX-License-Identifier: MIT
#include "apps/evenmesh/iterates.h"

#include <gtest/gtest.h>

namespace evenmesh::app {
namespace {

std::vector<int> kept(std::size_t most, int iterations) {
  Iterates iterates(most);
  for (int i = 0; i <= iterations; ++i) {
    iterates.add(i, std::vector<Vec3>{{static_cast<double>(i), 0.0, 0.0}});
  }
  std::vector<int> numbers;
  for (const StoredIterate& one : iterates.kept()) {
    EXPECT_EQ(one.points.at(0).x(), one.iteration);
    numbers.push_back(one.iteration);
  }
  return numbers;
}

TEST(Iterates, AreAllKeptIfTheyAreFew) { EXPECT_EQ(kept(5, 3), (std::vector<int>{0, 1, 2, 3})); }

TEST(Iterates, AreSpreadEvenly) {
  EXPECT_EQ(kept(5, 16), (std::vector<int>{0, 4, 8, 12, 16}));
  EXPECT_EQ(kept(5, 19), (std::vector<int>{0, 4, 8, 12, 16}));
  EXPECT_EQ(kept(2, 100), (std::vector<int>{0, 64}));
}

TEST(Iterates, OfNoneAndOneAreNoMore) {
  EXPECT_EQ(kept(0, 10), std::vector<int>{});
  EXPECT_EQ(kept(1, 10), std::vector<int>{0});
}

TEST(Iterates, BehindTheEndAreForgotten) {
  Iterates iterates(10);
  for (int i = 0; i < 6; ++i) iterates.add(i, std::vector<Vec3>(1, Vec3::Zero()));
  iterates.end_at(2);
  EXPECT_EQ(iterates.kept().size(), 3u);
}

TEST(Iterates, ThatComeTwiceAreKeptOnce) {
  Iterates iterates(10);
  for (const int i : {0, 1, 1, 2}) iterates.add(i, std::vector<Vec3>(1, Vec3::Zero()));
  EXPECT_EQ(iterates.kept().size(), 3u);
}

}  // namespace
}  // namespace evenmesh::app
