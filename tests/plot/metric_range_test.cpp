// SPDX-License-Identifier: MIT
#include "evenmesh/plot/metric_range.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

CellQuality with(Metric metric, std::vector<double> values) {
  CellQuality quality;
  quality.inverted.resize(values.size());
  quality.values[static_cast<std::size_t>(metric)] = std::move(values);
  return quality;
}

MetricRange range_of(Metric metric, std::vector<double> values) {
  const CellQuality quality = with(metric, std::move(values));
  const CellQuality* const all[] = {&quality};
  return metric_range(metric, all);
}

TEST(MetricRange, IsThatOfTheMetric) {
  EXPECT_EQ(range_of(Metric::shape, {0.4}).high, 1.0);
  EXPECT_EQ(range_of(Metric::scaled_jacobian, {0.4}).low, 0.0);
  EXPECT_EQ(range_of(Metric::scaled_jacobian, {-0.1}).low, -1.0);
}

TEST(MetricRange, OfAnglesEndsWhereThatOfTheRegularCellDoes) {
  EXPECT_EQ(range_of(Metric::min_angle, {20.0, 60.0 + 1e-12}).high, 60.0);
  EXPECT_EQ(range_of(Metric::min_angle, {20.0, 61.0}).high, 90.0);
  EXPECT_EQ(range_of(Metric::max_angle, {95.0, 170.0}).low, 90.0);
  EXPECT_EQ(range_of(Metric::max_angle, {60.0, 200.0}).high, 360.0);
}

TEST(MetricRange, OfRatiosHoldsNearlyAllCells) {
  std::vector<double> values(99, 2.5);
  EXPECT_EQ(range_of(Metric::aspect_ratio, values).high, 3.0);
  EXPECT_FALSE(range_of(Metric::aspect_ratio, values).open);
  values.push_back(kInfinity);
  EXPECT_EQ(range_of(Metric::aspect_ratio, values).high, 3.0);
  EXPECT_TRUE(range_of(Metric::aspect_ratio, values).open);
}

TEST(MetricRange, OfNoCellIsARange) {
  for (const Metric metric : kMetrics) {
    const MetricRange range = range_of(metric, {});
    EXPECT_LT(range.low, range.high) << name(metric);
  }
}

TEST(Goodness, IsOneAtTheBestEnd) {
  EXPECT_EQ(goodness(Metric::shape, {0.0, 1.0}, 1.0), 1.0);
  EXPECT_EQ(goodness(Metric::min_angle, {0.0, 60.0}, 15.0), 0.25);
  EXPECT_EQ(goodness(Metric::aspect_ratio, {1.0, 5.0, true}, 1.0), 1.0);
  EXPECT_EQ(goodness(Metric::aspect_ratio, {1.0, 5.0, true}, 2.0), 0.75);
  EXPECT_EQ(goodness(Metric::aspect_ratio, {1.0, 5.0, true}, kInfinity), 0.0);
  EXPECT_EQ(goodness(Metric::shape, {0.0, 1.0}, std::nan("")), 0.0);
}

TEST(ShownValue, HasTheDigitsThatTellCellsApart) {
  EXPECT_EQ(shown_value(Metric::shape, 0.83649), "0.836");
  EXPECT_EQ(shown_value(Metric::max_angle, 74.8249), "74.8\u00B0");
  EXPECT_EQ(shown_value(Metric::edge_ratio, 1.25), "1.25");
  EXPECT_EQ(shown_value(Metric::aspect_ratio, 3333.4), "3333");
  EXPECT_EQ(shown_value(Metric::aspect_ratio, kInfinity), "\u221E");
}

}  // namespace
}  // namespace evenmesh
