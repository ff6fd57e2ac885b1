// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/area.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

TEST(AreaVector, PointsUpForCounterClockwiseCorners) {
  const std::vector<Vec3> triangle{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
  EXPECT_EQ(area_vector(triangle), Vec3(0, 0, 6));
  const std::vector<Vec3> rectangle{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(area_vector(rectangle), Vec3(0, 0, 2));
}

TEST(AreaVector, CountsADentOfAPolygon) {
  // The unit square with a quarter bitten out from the right.
  const std::vector<Vec3> dented{{0, 0, 0}, {1, 0, 0}, {0.5, 0.5, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(area_vector(dented), Vec3(0, 0, 0.75));
}

TEST(AreaVector, VanishesForABowTie) {
  const std::vector<Vec3> bow_tie{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_EQ(area_vector(bow_tie), Vec3(0, 0, 0));
}

TEST(AreaVector, KeepsTheDigitsOfANeedleWhicheverCornerIsFirst) {
  // Two corners 2^-60 apart. Seen from the third, at distance 1, their sides are products that
  // cancel to nothing.
  const double tiny = 0x1p-60;
  std::vector<Vec3> needle{{0, 0, 0}, {1, 0.25, 0}, {0.25 * tiny, tiny, 0}};
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_DOUBLE_EQ(area_vector(needle)[2], 0.5 * tiny * (1 - 0.0625)) << turn;
    std::rotate(needle.begin(), needle.begin() + 1, needle.end());
  }
}

}  // namespace
}  // namespace evenmesh
