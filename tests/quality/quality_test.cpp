// SPDX-License-Identifier: MIT
#include "evenmesh/quality/quality.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/quality/cells.h"

namespace evenmesh {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One shaken cell after the other, kinds in turn, none sharing a vertex.
Mesh mixed_mesh(std::size_t count) {
  std::mt19937 random(5);
  std::vector<Vec3> points;
  Cells cells;
  for (std::size_t i = 0; i < count; ++i) {
    const CellKind kind = cells::all_kinds()[i % kCellKinds];
    std::vector<Index> vertices;
    for (const Vec3& p : cells::shaken(kind, 0.4, random)) {
      vertices.push_back(static_cast<Index>(points.size()));
      points.push_back(p);
    }
    cells.add(kind, vertices);
  }
  return {std::move(points), std::move(cells)};
}

/// Up is z for surface cells; every third cell is wound the other way.
Orientation orientation_of(const Mesh& mesh) {
  Orientation result;
  result.type = MeshType::planar;
  result.normal = Vec3::UnitZ();
  for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
    result.signs.push_back(i % 3 == 0 ? -1 : 1);
  }
  return result;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

CellQuality quality_of_shapes(std::vector<double> values) {
  CellQuality quality;
  quality.inverted.assign(values.size(), 0);
  for (auto& list : quality.values) list.assign(values.size(), kNaN);
  quality.values[0] = std::move(values);
  return quality;
}

TEST(MeasureCells, GivesTheValueOfEachCell) {
  const Mesh mesh = mixed_mesh(300);
  const Orientation orientation = orientation_of(mesh);
  Workers workers(2);
  const CellQuality quality = measure_cells(workers, mesh, mesh.points(), orientation);
  for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
    const CellKind kind = mesh.cells().kind(i);
    std::vector<Vec3> corners;
    for (const Index v : mesh.cells().vertices(i)) corners.push_back(mesh.points()[v]);
    const Vec3 up = orientation.up(i);
    const double sign = orientation.sign(i);
    for (const Metric metric : kMetrics) {
      EXPECT_EQ(quality.of(metric)[i], measure(metric, kind, corners, up, sign));
    }
    EXPECT_EQ(quality.inverted[i] != 0, is_inverted(kind, corners, up, sign)) << i;
  }
}

TEST(MeasureCells, UsesThePointsItIsGiven) {
  const Mesh mesh = mixed_mesh(7);
  Workers workers(1);
  const std::vector<Vec3> collapsed(mesh.point_count(), Vec3::Zero());
  const CellQuality quality = measure_cells(workers, mesh, collapsed, orientation_of(mesh));
  for (const double x : quality.of(Metric::shape)) EXPECT_EQ(x, 0.0);
}

TEST(MeasureCellsAndSummarize, HaveTheSameBitsForAnyNumberOfThreads) {
  const Mesh mesh = mixed_mesh(3 * kRangeSize + 77);
  const Orientation orientation = orientation_of(mesh);
  Workers one(1);
  const CellQuality expected = measure_cells(one, mesh, mesh.points(), orientation);
  const QualitySummary summary = summarize(one, expected);
  for (const int threads : {2, 8}) {
    Workers workers(threads);
    const CellQuality quality = measure_cells(workers, mesh, mesh.points(), orientation);
    EXPECT_EQ(quality.inverted, expected.inverted);
    for (const Metric m : kMetrics) EXPECT_TRUE(same_bits(quality.of(m), expected.of(m)));
    const QualitySummary again = summarize(workers, quality);
    for (const Metric m : kMetrics) {
      EXPECT_EQ(again.of(m).mean, summary.of(m).mean);
      EXPECT_EQ(again.of(m).p5, summary.of(m).p5);
    }
  }
}

TEST(Summarize, CountsPercentilesFromTheWorstEndByNearestRank) {
  std::vector<double> values(200);
  std::iota(values.begin(), values.end(), 1.0);
  std::shuffle(values.begin(), values.end(), std::mt19937(6));
  CellQuality quality = quality_of_shapes(values);
  quality.values[static_cast<std::size_t>(Metric::max_angle)] = values;
  Workers workers(1);
  const QualitySummary summary = summarize(workers, quality);

  const Distribution& up = summary.of(Metric::shape);  // larger is better
  EXPECT_EQ(up.count, 200u);
  EXPECT_EQ(up.worst, 1.0);
  EXPECT_EQ(up.p1, 2.0);
  EXPECT_EQ(up.p5, 10.0);
  EXPECT_EQ(up.median, 100.0);
  EXPECT_EQ(up.mean, 100.5);
  EXPECT_EQ(up.best, 200.0);

  const Distribution& down = summary.of(Metric::max_angle);  // smaller is better
  EXPECT_EQ(down.worst, 200.0);
  EXPECT_EQ(down.p1, 199.0);
  EXPECT_EQ(down.p5, 191.0);
  EXPECT_EQ(down.median, 101.0);
  EXPECT_EQ(down.best, 1.0);
}

TEST(Summarize, AgreesWithSortingForEveryCount) {
  Workers workers(1);
  std::mt19937 random(7);
  for (std::size_t n = 1; n <= 130; ++n) {
    std::vector<double> values(n);
    for (double& x : values) x = static_cast<double>(random() % 40);  // with repetitions
    const Distribution d = summarize(workers, quality_of_shapes(values)).of(Metric::shape);
    std::sort(values.begin(), values.end());
    const auto ranked = [&](double share) {
      return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(n))) - 1];
    };
    EXPECT_EQ(d.worst, values.front());
    EXPECT_EQ(d.p1, n <= 100 ? values[0] : values[1]);
    EXPECT_EQ(d.p5, values[(n + 19) / 20 - 1]);
    EXPECT_EQ(d.median, ranked(0.5));
    EXPECT_EQ(d.best, values.back());
  }
}

TEST(Summarize, LeavesOutCellsTheMetricDoesNotApplyTo) {
  Workers workers(1);
  const CellQuality quality = quality_of_shapes({kNaN, 0.25, kNaN, 0.75});
  const QualitySummary summary = summarize(workers, quality);
  EXPECT_EQ(summary.cells, 4u);
  EXPECT_EQ(summary.of(Metric::shape).count, 2u);
  EXPECT_EQ(summary.of(Metric::shape).mean, 0.5);
  EXPECT_EQ(summary.of(Metric::min_angle).count, 0u);
  EXPECT_EQ(summary.of(Metric::min_angle).worst, 0.0);
  EXPECT_EQ(summary.of(Metric::min_angle).mean, 0.0);
}

TEST(Summarize, HasAnInfiniteMeanAsSoonAsOneValueIs) {
  Workers workers(1);
  const Distribution d =
      summarize(workers, quality_of_shapes({1.0, kInfinity, 2.0})).of(Metric::shape);
  EXPECT_EQ(d.mean, kInfinity);
  EXPECT_EQ(d.median, 2.0);
}

TEST(Summarize, CountsInvertedCellsAndTakesAMeshWithoutAny) {
  Workers workers(1);
  CellQuality quality = quality_of_shapes({0.0, 0.5, 0.0});
  quality.inverted = {1, 0, 1};
  EXPECT_EQ(summarize(workers, quality).inverted, 2u);
  EXPECT_EQ(summarize(workers, CellQuality{}).cells, 0u);
}

}  // namespace
}  // namespace evenmesh
