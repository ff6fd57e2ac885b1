// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "evenmesh/quality/metric.h"
#include "tests/quality/cells.h"

namespace evenmesh {
namespace {

using cells::Corners;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expect_worst(CellKind kind, const Corners& cell, const std::string& what) {
  for (const Vec3& up : {cells::kUp, Vec3(Vec3::Zero())}) {
    const auto of = [&](Metric metric) { return measure(metric, kind, cell, up); };
    EXPECT_TRUE(is_inverted(kind, cell, up)) << what;
    EXPECT_EQ(of(Metric::shape), 0.0) << what;
    EXPECT_EQ(of(Metric::scaled_jacobian), 0.0) << what;
    EXPECT_EQ(of(Metric::min_angle), 0.0) << what;
    EXPECT_EQ(of(Metric::max_angle), 180.0) << what;
    EXPECT_EQ(of(Metric::aspect_ratio), kInfinity) << what;
    EXPECT_EQ(of(Metric::edge_ratio), kInfinity) << what;
  }
}

TEST(CollapsedCell, HasTheWorstValueOfEveryMeasure) {
  for (const CellKind kind : cells::all_kinds()) {
    const Corners point(cells::ideal(kind).size(), Vec3(1, 2, 3));
    expect_worst(kind, point, std::string(traits(kind).name) + " in one point");
  }
}

TEST(CellThatIsNotFinite, CountsAsCollapsed) {
  for (const double bad : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    for (const CellKind kind : cells::all_kinds()) {
      for (std::size_t i = 0; i < cells::ideal(kind).size(); ++i) {
        Corners cell = cells::ideal(kind);
        cell[i][1] = bad;
        expect_worst(kind, cell, std::string(traits(kind).name) + " with a bad coordinate");
      }
    }
  }
}

TEST(Triangle, WithARepeatedVertexHasTheWorstValues) {
  for (const Corners& cell :
       {Corners{{0, 0, 0}, {0, 0, 0}, {1, 2, 3}}, Corners{{0, 0, 0}, {1, 2, 3}, {1, 2, 3}},
        Corners{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}}}) {
    expect_worst(CellKind::triangle, cell, "triangle with a repeated vertex");
  }
}

TEST(Triangle, OnOneLineIsFlatButHasAnEdgeRatio) {
  const Corners line{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}};
  const auto of = [&](Metric m) { return measure(m, CellKind::triangle, line, cells::kUp); };
  EXPECT_TRUE(is_inverted(CellKind::triangle, line, cells::kUp));
  EXPECT_EQ(of(Metric::shape), 0.0);
  EXPECT_EQ(of(Metric::scaled_jacobian), 0.0);
  EXPECT_EQ(of(Metric::min_angle), 0.0);
  EXPECT_EQ(of(Metric::max_angle), 180.0);
  EXPECT_EQ(of(Metric::aspect_ratio), kInfinity);
  EXPECT_EQ(of(Metric::edge_ratio), 2.0);
}

TEST(Quad, WithARepeatedVertexIsInverted) {
  const Corners quad{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
  EXPECT_TRUE(is_inverted(CellKind::quad, quad, cells::kUp));
  EXPECT_EQ(measure(Metric::shape, CellKind::quad, quad, cells::kUp), 0.0);
  EXPECT_EQ(measure(Metric::edge_ratio, CellKind::quad, quad, cells::kUp), kInfinity);
}

TEST(Tet, ThatIsFlatHasAnEdgeRatioOnly) {
  // One with a vertex inside the triangle of the others, one with crossing diagonals.
  for (const Corners& flat : {Corners{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 0}},
                              Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}) {
    const auto of = [&](Metric m) { return measure(m, CellKind::tet, flat, Vec3::Zero()); };
    EXPECT_EQ(of(Metric::shape), 0.0);
    EXPECT_EQ(of(Metric::min_angle), 0.0);
    EXPECT_EQ(of(Metric::max_angle), 180.0);
    EXPECT_EQ(of(Metric::aspect_ratio), kInfinity);
    EXPECT_LT(of(Metric::edge_ratio), kInfinity);
  }
}

TEST(VolumeCell, WithARepeatedVertexHasTheWorstAnglesAndEdgeRatio) {
  for (const CellKind kind : {CellKind::tet, CellKind::hex, CellKind::wedge, CellKind::pyramid}) {
    for (const auto [a, b] : traits(kind).edges) {
      Corners cell = cells::ideal(kind);
      cell[b] = cell[a];
      const auto of = [&](Metric m) { return measure(m, kind, cell, Vec3::Zero()); };
      EXPECT_EQ(of(Metric::min_angle), 0.0) << traits(kind).name;
      EXPECT_EQ(of(Metric::max_angle), 180.0) << traits(kind).name;
      EXPECT_EQ(of(Metric::edge_ratio), kInfinity) << traits(kind).name;
      const bool is_flat = kind == CellKind::tet || (kind == CellKind::pyramid && b == 4);
      EXPECT_EQ(of(Metric::aspect_ratio) == kInfinity, is_flat) << traits(kind).name;
    }
  }
}

TEST(Hex, WithAStraightCornerInAFaceHasTheWorstAngles) {
  Corners cell = cells::ideal(CellKind::hex);
  cell[6] = 0.5 * (cell[5] + cell[7]);
  EXPECT_EQ(measure(Metric::min_angle, CellKind::hex, cell, Vec3::Zero()), 0.0);
  EXPECT_EQ(measure(Metric::max_angle, CellKind::hex, cell, Vec3::Zero()), 180.0);
}

void expect_in_range(Metric metric, CellKind kind, double value) {
  const std::array<std::array<double, 2>, kMetricCount> range = {
      {{0, 1}, {-1, 1}, {0, 360}, {0, 360}, {1, kInfinity}, {1, kInfinity}}};
  const auto [least, most] = range[static_cast<std::size_t>(metric)];
  EXPECT_TRUE(value >= least && value <= most)  // false for NaN
      << cells::describe(metric, kind) << " is " << value;
}

TEST(Measures, AreInTheirRangeForAnyInput) {
  std::mt19937 random(4);
  const std::array<double, 12> specials = {0.0,     -0.0, 1.0,   -1.0,   1e-320,  1e-160,
                                           -1e-160, 1e-8, 1e150, -1e150, 1.7e308, -1.7e308};
  std::uniform_int_distribution<std::size_t> pick(0, specials.size() - 1);
  std::uniform_real_distribution<double> exponent(-310.0, 308.0);
  std::bernoulli_distribution special(0.7), repeat(0.15), wild(0.05);
  const auto coordinate = [&] {
    if (special(random)) return specials[pick(random)];
    return std::pow(10.0, exponent(random)) * (special(random) ? 1 : -1);
  };
  for (int round = 0; round < 3000; ++round) {
    for (const CellKind kind : cells::all_kinds()) {
      Corners cell = cells::ideal(kind);
      for (std::size_t i = 0; i < cell.size(); ++i) {
        for (int k = 0; k < 3; ++k) cell[i][k] = coordinate();
        if (i > 0 && repeat(random)) cell[i] = cell[i - 1];
        if (wild(random)) cell[i][0] = std::numeric_limits<double>::quiet_NaN();
      }
      const Vec3 up(coordinate(), coordinate(), coordinate());
      for (const Metric metric : kMetrics) {
        if (applies(metric, kind)) expect_in_range(metric, kind, measure(metric, kind, cell, up));
      }
      if (is_inverted(kind, cell, up)) continue;
      EXPECT_GE(measure(Metric::shape, kind, cell, up), 0.0);
    }
  }
}

}  // namespace
}  // namespace evenmesh
