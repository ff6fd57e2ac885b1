// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "evenmesh/quality/metric.h"
#include "tests/quality/cells.h"

namespace evenmesh {
namespace {

using cells::Corners;

TEST(IdealCell, HasShapeAndScaledJacobianOne) {
  for (const CellKind kind : cells::all_kinds()) {
    for (const Metric metric : {Metric::shape, Metric::scaled_jacobian}) {
      EXPECT_NEAR(measure(metric, kind, cells::ideal(kind), cells::kUp), 1.0, 1e-14)
          << cells::describe(metric, kind);
    }
    EXPECT_FALSE(is_inverted(kind, cells::ideal(kind), cells::kUp)) << traits(kind).name;
  }
}

TEST(IdealVolumeCell, HasTheAnglesOfTheRegularSolidAndRatiosOne) {
  const auto acos_degrees = [](double x) { return std::acos(x) * 180.0 / std::numbers::pi; };
  const std::map<CellKind, std::pair<double, double>> angles = {
      {CellKind::tet, {acos_degrees(1.0 / 3), acos_degrees(1.0 / 3)}},
      {CellKind::hex, {90.0, 90.0}},
      {CellKind::wedge, {60.0, 90.0}},
      {CellKind::pyramid, {acos_degrees(1 / std::numbers::sqrt3), acos_degrees(-1.0 / 3)}}};
  for (const auto& [kind, range] : angles) {
    const auto value = [k = kind](Metric m) {
      return measure(m, k, cells::ideal(k), Vec3::Zero());
    };
    EXPECT_NEAR(value(Metric::min_angle), range.first, 1e-12) << traits(kind).name;
    EXPECT_NEAR(value(Metric::max_angle), range.second, 1e-12) << traits(kind).name;
    EXPECT_NEAR(value(Metric::aspect_ratio), 1.0, 1e-14) << traits(kind).name;
    EXPECT_NEAR(value(Metric::edge_ratio), 1.0, 1e-14) << traits(kind).name;
  }
}

TEST(RegularPolygon, IsIdealForEveryNumberOfCorners) {
  for (int n = 3; n <= 40; ++n) {
    const Corners polygon = cells::regular_polygon(n);
    const auto value = [&](Metric m) { return measure(m, CellKind::polygon, polygon, cells::kUp); };
    EXPECT_NEAR(value(Metric::shape), 1.0, 1e-12) << n;
    EXPECT_NEAR(value(Metric::scaled_jacobian), 1.0, 1e-12) << n;
    EXPECT_NEAR(value(Metric::min_angle), 180.0 * (n - 2) / n, 1e-11) << n;
    EXPECT_NEAR(value(Metric::max_angle), 180.0 * (n - 2) / n, 1e-11) << n;
    EXPECT_NEAR(value(Metric::aspect_ratio), 1.0, 1e-12) << n;
    EXPECT_NEAR(value(Metric::edge_ratio), 1.0, 1e-12) << n;
  }
}

TEST(IdealCell, IsTheOnlyOneOfShapeOne) {
  std::mt19937 random(1);
  for (const CellKind kind : cells::all_kinds()) {
    for (int i = 0; i < 200; ++i) {
      const Corners cell = cells::shaken(kind, 0.1, random);
      EXPECT_LT(measure(Metric::shape, kind, cell, cells::kUp), 1.0 - 1e-5) << traits(kind).name;
    }
  }
}

TEST(Pyramid, HasItsBestScaledJacobianAtTheIdealHeight) {
  const auto value = [](double height) {
    Corners pyramid = cells::ideal(CellKind::pyramid);
    pyramid[4][2] = height;
    return measure(Metric::scaled_jacobian, CellKind::pyramid, pyramid, Vec3::Zero());
  };
  const double ideal = std::sqrt(0.5);
  EXPECT_LT(value(0.9 * ideal), value(0.99 * ideal));
  EXPECT_LT(value(0.99 * ideal), 1.0 - 1e-4);
  EXPECT_LT(value(1.01 * ideal), 1.0 - 1e-4);
  EXPECT_LT(value(2.0 * ideal), value(1.01 * ideal));
  EXPECT_LT(value(1e6), 1e-11);  // all edges at the apex nearly parallel
}

// The bound must come from the formula: were it only clamped, ideal cells would not be alone.
TEST(ScaledJacobian, StaysBelowOneForCellsOtherThanTheIdealTrianglesTetsAndPyramids) {
  std::mt19937 random(2);
  for (const CellKind kind : {CellKind::triangle, CellKind::tet, CellKind::pyramid}) {
    for (int i = 0; i < 2000; ++i) {
      const Corners cell = cells::shaken(kind, i % 2 == 0 ? 0.02 : 0.3, random);
      EXPECT_LT(measure(Metric::scaled_jacobian, kind, cell, cells::kUp), 1.0) << traits(kind).name;
    }
  }
}

}  // namespace
}  // namespace evenmesh
