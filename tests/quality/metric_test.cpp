// SPDX-License-Identifier: MIT
#include "evenmesh/quality/metric.h"

#include <limits>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Metric, HasTheNameOfReports) {
  EXPECT_EQ(name(Metric::shape), "shape");
  EXPECT_EQ(name(Metric::scaled_jacobian), "scaled_jacobian");
  EXPECT_EQ(name(Metric::min_angle), "min_angle");
  EXPECT_EQ(name(Metric::max_angle), "max_angle");
  EXPECT_EQ(name(Metric::aspect_ratio), "aspect_ratio");
  EXPECT_EQ(name(Metric::edge_ratio), "edge_ratio");
}

TEST(Metric, AppliesToCellsOfEveryKind) {
  for (const Metric metric : kMetrics) {
    for (int k = 0; k < kCellKinds; ++k) EXPECT_TRUE(applies(metric, static_cast<CellKind>(k)));
  }
}

TEST(Worse, KnowsWhichWayEachMetricPoints) {
  for (const Metric metric : {Metric::shape, Metric::scaled_jacobian, Metric::min_angle}) {
    EXPECT_TRUE(larger_is_better(metric));
    EXPECT_TRUE(worse(metric, 0.1, 0.2));
    EXPECT_FALSE(worse(metric, 0.2, 0.1));
  }
  for (const Metric metric : {Metric::max_angle, Metric::aspect_ratio, Metric::edge_ratio}) {
    EXPECT_FALSE(larger_is_better(metric));
    EXPECT_TRUE(worse(metric, kInfinity, 2.0));
    EXPECT_FALSE(worse(metric, 1.0, 2.0));
  }
}

TEST(Worse, IsNeverTrueForEqualValues) {
  for (const Metric metric : kMetrics) {
    for (const double x : {0.0, 1.0, kInfinity, kNaN}) EXPECT_FALSE(worse(metric, x, x));
    EXPECT_FALSE(worse(metric, 0.0, -0.0));
  }
}

TEST(Worse, TakesNaNForWorseThanEveryNumber) {
  for (const Metric metric : kMetrics) {
    for (const double x : {-kInfinity, 0.0, kInfinity}) {
      EXPECT_TRUE(worse(metric, kNaN, x));
      EXPECT_FALSE(worse(metric, x, kNaN));
    }
  }
}

}  // namespace
}  // namespace evenmesh
