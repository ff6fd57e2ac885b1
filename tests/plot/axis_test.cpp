// SPDX-License-Identifier: MIT
#include "evenmesh/plot/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

std::vector<std::string> labels(const Axis& axis) {
  std::vector<std::string> result;
  for (const Tick& tick : axis.ticks()) {
    if (tick.label.empty()) continue;
    result.push_back(tick.raised.empty() ? tick.label : tick.label + "^" + tick.raised);
  }
  return result;
}

using Labels = std::vector<std::string>;

TEST(Axis, HasTicksAtRoundValues) {
  EXPECT_EQ(labels(Axis::linear(0, 1, 5)), (Labels{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_EQ(labels(Axis::linear(0, 0.3, 3)), (Labels{"0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(labels(Axis::linear(0, 28, 9)), (Labels{"0", "5", "10", "15", "20", "25"}));
  EXPECT_EQ(labels(Axis::linear(-1, 1, 4)), (Labels{"\u22121", "\u22120.5", "0", "0.5", "1"}));
  EXPECT_EQ(labels(Axis::linear(0, 4e7, 4)),
            (Labels{"0", "1\u00D710^7", "2\u00D710^7", "3\u00D710^7", "4\u00D710^7"}));
}

TEST(Axis, PlacesTicksWhereTheirValuesAre) {
  const Axis axis = Axis::linear(-2, 6, 4);
  ASSERT_EQ(labels(axis), (Labels{"\u22122", "0", "2", "4", "6"}));
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_DOUBLE_EQ(axis.ticks()[i].place, 0.25 * static_cast<double>(i));
  EXPECT_DOUBLE_EQ(axis.place(0.0), 0.25);
}

TEST(Axis, OfWholeNumbersHasNoneBetweenThem) {
  EXPECT_EQ(labels(Axis::linear(0, 2, 9, true)), (Labels{"0", "1", "2"}));
  EXPECT_EQ(labels(Axis::linear(-0.5, 0.5, 3, true)), (Labels{"0"}));
}

TEST(Axis, FromZeroEndsAtATick) {
  const Axis axis = Axis::from_zero(43.0, 6);
  EXPECT_EQ(labels(axis), (Labels{"0", "10", "20", "30", "40", "50"}));
  EXPECT_DOUBLE_EQ(axis.place(50.0), 1.0);
  EXPECT_DOUBLE_EQ(Axis::from_zero(0.0, 6).place(1.0), 1.0);
}

TEST(Axis, OfDecadesLabelsPowersOfTenAndMarksWhatIsBetween) {
  const Axis axis = Axis::logarithmic(0.02, 7.0);
  EXPECT_EQ(labels(axis), (Labels{"10^\u22122", "10^\u22121", "10^0", "10^1"}));
  EXPECT_EQ(axis.ticks().size(), 4u + 3u * 8u);
  EXPECT_NEAR(axis.place(0.01), 0.0, 1e-12);
  EXPECT_NEAR(axis.place(0.1), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(axis.place(10.0), 1.0, 1e-12);
  const bool has_two = std::any_of(axis.ticks().begin(), axis.ticks().end(), [&](const Tick& t) {
    return t.label.empty() && std::abs(t.place - axis.place(0.02)) < 1e-12;
  });
  EXPECT_TRUE(has_two);
}

TEST(Axis, OfDecadesHasOneAtLeast) {
  EXPECT_EQ(labels(Axis::logarithmic(1.0, 1.0)), (Labels{"10^0", "10^1"}));
  EXPECT_EQ(labels(Axis::logarithmic(0.3, 0.4)), (Labels{"10^\u22121", "10^0"}));
}

TEST(Axis, OfManyDecadesLabelsSomeOfThem) {
  const Axis axis = Axis::logarithmic(1e-30, 1.0);
  EXPECT_LE(labels(axis).size(), 11u);
  EXPECT_EQ(axis.ticks().size(), 31u);
  EXPECT_EQ(labels(axis).back(), "10^0");
}

TEST(Axis, HasAPlaceForEveryPositiveDouble) {
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  const Axis axis = Axis::logarithmic(least, most);
  for (const double value : {least, 1.0, most}) {
    EXPECT_GE(axis.place(value), 0.0);
    EXPECT_LE(axis.place(value), 1.0);
  }
}

}  // namespace
}  // namespace evenmesh
