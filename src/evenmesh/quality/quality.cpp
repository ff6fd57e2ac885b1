// SPDX-License-Identifier: MIT
#include "evenmesh/quality/quality.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>

#include "evenmesh/quality/angles.h"
#include "evenmesh/quality/aspect_ratio.h"
#include "evenmesh/quality/dihedral_angles.h"
#include "evenmesh/quality/edge_ratio.h"
#include "evenmesh/quality/inverted.h"
#include "evenmesh/quality/scaled_jacobian.h"
#include "evenmesh/quality/shape.h"

namespace evenmesh {
namespace {

/// Measures one cell after the other and writes to that cell's places only.
class CellMeter {
 public:
  CellMeter(const Mesh& mesh, Points points, const Orientation& orientation, CellQuality& quality)
      : cells_(mesh.cells()), points_(points), orientation_(orientation), quality_(quality) {}

  void measure(std::size_t i) {
    const CellKind kind = cells_.kind(i);
    corners_.clear();
    for (const Index v : cells_.vertices(i)) corners_.push_back(points_[v]);
    if (traits(kind).dimension == 3) {
      volume_.set(kind, corners_, orientation_.sign(i));
      write_values(i, volume_);
      quality_.inverted[i] = is_inverted(volume_);
    } else {
      surface_.set(corners_, orientation_.up(i));
      write_values(i, surface_);
      quality_.inverted[i] = is_inverted(kind, surface_);
    }
  }

 private:
  double& value(Metric metric, std::size_t i) {
    return quality_.values[static_cast<std::size_t>(metric)][i];
  }

  template <typename Cell>
  void write_values(std::size_t i, const Cell& cell) {
    const AngleRange angles = angle_range(cell);
    value(Metric::shape, i) = shape(cell);
    value(Metric::scaled_jacobian, i) = scaled_jacobian(cell);
    value(Metric::min_angle, i) = angles.min;
    value(Metric::max_angle, i) = angles.max;
    value(Metric::aspect_ratio, i) = aspect_ratio(cell);
    value(Metric::edge_ratio, i) = edge_ratio(cell);
  }

  const Cells& cells_;
  const Points points_;
  const Orientation& orientation_;
  CellQuality& quality_;
  std::vector<Vec3> corners_;
  SurfaceCell surface_;
  VolumeCell volume_;
};

/// The part of the values a metric applies to, in the order of the cells.
std::vector<double> applicable(const std::vector<double>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(result),
               [](double x) { return !std::isnan(x); });
  return result;
}

/// Index of the percentile by nearest rank among n sorted values: ceil(percent n / 100) - 1.
std::size_t rank(std::size_t percent, std::size_t n) { return (percent * n + 99) / 100 - 1; }

template <typename Before>
void find_percentiles(std::vector<double> sample, Before before, Distribution& result) {
  // From the middle outwards, so that each search has only what the one before left below it.
  auto end = sample.end();
  const auto percentile = [&](std::size_t percent) {
    const auto place = sample.begin() + static_cast<std::ptrdiff_t>(rank(percent, sample.size()));
    if (place < end) std::nth_element(sample.begin(), place, end, before);
    end = place + 1;  // the place itself may be wanted again
    return *place;
  };
  const auto [worst, best] = std::minmax_element(sample.begin(), sample.end(), before);
  result.worst = *worst;
  result.best = *best;
  result.median = percentile(50);
  result.p5 = percentile(5);
  result.p1 = percentile(1);
}

Distribution distribution_without_mean(Metric metric, const std::vector<double>& values) {
  Distribution result;
  std::vector<double> sample = applicable(values);
  result.count = sample.size();
  if (sample.empty()) return result;
  if (larger_is_better(metric)) {
    find_percentiles(std::move(sample), std::less<>(), result);
  } else {
    find_percentiles(std::move(sample), std::greater<>(), result);
  }
  return result;
}

double sum_applicable(Workers& workers, const std::vector<double>& values) {
  return sum_over_ranges(workers, values.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i) sum += std::isnan(values[i]) ? 0.0 : values[i];
    return sum;
  });
}

}  // namespace

CellQuality measure_cells(Workers& workers, const Mesh& mesh, Points points,
                          const Orientation& orientation) {
  assert(points.size() == mesh.point_count());
  const std::size_t count = mesh.cells().size();
  CellQuality quality;
  for (auto& values : quality.values) values.resize(count);
  quality.inverted.resize(count);
  for_ranges(workers, count, [&](std::size_t first, std::size_t last) {
    CellMeter meter(mesh, points, orientation, quality);
    for (std::size_t i = first; i < last; ++i) meter.measure(i);
  });
  return quality;
}

QualitySummary summarize(Workers& workers, const CellQuality& quality) {
  QualitySummary summary;
  summary.cells = quality.inverted.size();
  summary.inverted = summary.cells - static_cast<std::size_t>(std::count(
                                         quality.inverted.begin(), quality.inverted.end(), 0));
  workers.run(kMetricCount, [&](std::size_t m) {
    summary.metrics[m] = distribution_without_mean(kMetrics[m], quality.values[m]);
  });
  for (std::size_t m = 0; m < kMetricCount; ++m) {
    Distribution& distribution = summary.metrics[m];
    if (distribution.count == 0) continue;
    distribution.mean =
        sum_applicable(workers, quality.values[m]) / static_cast<double>(distribution.count);
  }
  return summary;
}

}  // namespace evenmesh
