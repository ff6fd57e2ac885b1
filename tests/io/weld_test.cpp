// SPDX-License-Identifier: MIT
#include "evenmesh/io/weld.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

TEST(Welder, NumbersPositionsAsTheyFirstCome) {
  Welder welder;
  EXPECT_EQ(welder.add({1, 0, 0}), 0u);
  EXPECT_EQ(welder.add({0, 1, 0}), 1u);
  EXPECT_EQ(welder.add({1, 0, 0}), 0u);
  EXPECT_EQ(welder.points().size(), 2u);
}

TEST(Welder, TakesMinusZeroForZeroAndKeepsTheFirstSign) {
  Welder welder;
  EXPECT_EQ(welder.add({-0.0, 1, 0}), 0u);
  EXPECT_EQ(welder.add({0.0, 1, -0.0}), 0u);
  EXPECT_TRUE(std::signbit(welder.points()[0].x()));
}

TEST(Welder, KeepsNeighbouringDoublesApart) {
  Welder welder;
  EXPECT_EQ(welder.add({1, 0, 0}), 0u);
  EXPECT_EQ(welder.add({std::nextafter(1.0, 2.0), 0, 0}), 1u);
}

TEST(Welder, FindsEveryPointOfALargeLatticeAgain) {
  Welder welder;
  const auto lattice = [](int i) { return Vec3(i % 50, i / 50 % 50, i / 2500); };
  for (int i = 0; i < 25000; ++i) ASSERT_EQ(welder.add(lattice(i)), static_cast<Index>(i));
  for (int i = 0; i < 25000; ++i) ASSERT_EQ(welder.add(lattice(i)), static_cast<Index>(i));
}

TEST(MergeClose, JoinsChainsAndKeepsTheFirstPlace) {
  std::vector<Vec3> points{{0, 0, 0}, {5, 0, 0}, {1.8, 0, 0}, {0.9, 0, 0}};
  EXPECT_EQ(merge_close(points, 1.0), (std::vector<Index>{0, 1, 0, 0}));
  EXPECT_EQ(points, (std::vector<Vec3>{{0, 0, 0}, {5, 0, 0}}));
}

TEST(MergeClose, IncludesTheToleranceItself) {
  std::vector<Vec3> points{{0, 0, 0}, {0.5, 0, 0}};
  EXPECT_EQ(merge_close(points, 0.5).back(), 0u);
  points = {{0, 0, 0}, {0.5, 0, 0}};
  EXPECT_EQ(merge_close(points, 0.499).back(), 1u);
}

// Against all pairs, for tolerances from "hardly any" to "nearly all".
TEST(MergeClose, AgreesWithComparingAllPairs) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const double tolerance : {0.01, 0.05, 0.1, 0.2, 0.5}) {
    std::vector<Vec3> points(300);
    for (Vec3& p : points) p = {uniform(random), uniform(random), uniform(random)};
    std::vector<std::size_t> label(points.size());
    for (std::size_t i = 0; i < label.size(); ++i) label[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if ((points[i] - points[j]).norm() > tolerance || label[i] == label[j]) continue;
          label[i] = label[j] = std::min(label[i], label[j]);
          changed = true;
        }
      }
    }
    std::vector<Vec3> kept = points;
    const std::vector<Index> numbers = merge_close(kept, tolerance);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(numbers[i], numbers[label[i]]);
      ASSERT_EQ(kept[numbers[i]], points[label[i]]);
    }
  }
}

// Each point is within the tolerance of each other: pairs must not be tried one by one.
TEST(MergeClose, IsFastWhereEverythingIsClose) {
  std::vector<Vec3> points;
  for (int i = 0; i < 200000; ++i) points.emplace_back(1e-9 * i, 0, 0);
  merge_close(points, 1.0);
  EXPECT_EQ(points.size(), 1u);
}

TEST(MergeClose, SurvivesATinyToleranceFarFromTheOrigin) {
  const double largest = std::numeric_limits<double>::max();
  std::vector<Vec3> points{{largest, 0, 0}, {-largest, 0, 0}, {0, largest, 0}, {0, 0, 0}};
  merge_close(points, 5e-324);
  EXPECT_EQ(points.size(), 4u);
}

}  // namespace
}  // namespace evenmesh
