// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/unit_size.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

TEST(UnitSized, MovesTheFirstPointToTheOriginAndScalesByAPowerOfTwo) {
  const std::vector<Vec3> points{{1, 1, 1}, {4, 1, 1}, {1, 1, -5}};
  const std::vector<Vec3> expected{{0, 0, 0}, {3.0 / 8, 0, 0}, {0, 0, -6.0 / 8}};
  EXPECT_EQ(unit_sized(points), expected);
}

TEST(UnitSized, SurvivesDifferencesThatOverflow) {
  const auto result = unit_sized(std::vector<Vec3>{{-kMax, 0, 0}, {kMax, 0, 0}, {0, kMax, 0}});
  EXPECT_DOUBLE_EQ(result[1][0], 1.0);
  EXPECT_DOUBLE_EQ(result[2][0], 0.5);
  EXPECT_DOUBLE_EQ(result[2][1], 0.5);
}

TEST(UnitSized, SurvivesDenormalNumbers) {
  const auto result = unit_sized(std::vector<Vec3>{{0, 0, 0}, {kDenormal, 0, 0}});
  EXPECT_EQ(result[1], Vec3(0.5, 0, 0));
}

TEST(UnitSized, GivesZerosForPointsThatCoincideOrAreNotFinite) {
  const std::vector<Vec3> zeros(2, Vec3::Zero());
  EXPECT_EQ(unit_sized(std::vector<Vec3>(2, Vec3(1, 2, 3))), zeros);
  const double bad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(unit_sized(std::vector<Vec3>{{1, 2, 3}, {4, bad, 6}}), zeros);
}

}  // namespace
}  // namespace evenmesh
