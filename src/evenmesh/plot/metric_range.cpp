// SPDX-License-Identifier: MIT
#include "evenmesh/plot/metric_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace evenmesh {
namespace {

// All values of cells that the metric applies to and that are not inverted.
std::vector<double> valid_values(Metric metric, std::span<const CellQuality* const> meshes) {
  std::vector<double> values;
  for (const CellQuality* quality : meshes) {
    const std::vector<double>& all = quality->of(metric);
    for (std::size_t c = 0; c < all.size(); ++c) {
      if (!std::isnan(all[c]) && quality->inverted[c] == 0) values.push_back(all[c]);
    }
  }
  return values;
}

template <std::size_t n>
double first_above(const std::array<double, n>& ends, double value) {
  // Angles of regular cells come out a few bits above 60 or 90 degrees.
  const auto end =
      std::find_if(ends.begin(), ends.end(), [&](double e) { return value <= e * (1.0 + 1e-9); });
  return end == ends.end() ? ends.back() : *end;
}

MetricRange ratio_range(std::vector<double>& values) {
  constexpr std::array<double, 9> kEnds = {2, 3, 4, 5, 6, 8, 10, 15, 20};
  if (values.empty()) return {1.0, kEnds[0], false};
  const std::size_t nearly_all = values.size() - 1 - values.size() / 50;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(nearly_all),
                   values.end());
  const double end = first_above(kEnds, values[nearly_all]);
  return {1.0, end, *std::max_element(values.begin(), values.end()) > end};
}

}  // namespace

MetricRange metric_range(Metric metric, std::span<const CellQuality* const> meshes) {
  std::vector<double> values = valid_values(metric, meshes);
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double low = values.empty() ? 0.0 : *least;
  const double high = values.empty() ? 0.0 : *greatest;
  switch (metric) {
    case Metric::shape:
      return {0.0, 1.0, false};
    case Metric::scaled_jacobian:  // negative at an inward corner of a polygon, or inverted
      return {low < 0.0 ? -1.0 : 0.0, 1.0, false};
    case Metric::min_angle:
      return {0.0, first_above(std::array{60.0, 90.0, 120.0, 180.0, 360.0}, high), false};
    case Metric::max_angle:
      return {low < 90.0 || values.empty() ? 60.0 : 90.0,
              first_above(std::array{180.0, 360.0}, high), false};
    case Metric::aspect_ratio:
    case Metric::edge_ratio:
      break;
  }
  return ratio_range(values);
}

double goodness(Metric metric, const MetricRange& range, double value) {
  if (std::isnan(value)) return 0.0;
  const double place = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
  return larger_is_better(metric) ? place : 1.0 - place;
}

std::string shown_value(Metric metric, double value) {
  if (!std::isfinite(value)) return "\u221E";
  switch (metric) {
    case Metric::shape:
    case Metric::scaled_jacobian:
      return fmt::format("{:.3f}", value);
    case Metric::min_angle:
    case Metric::max_angle:
      return fmt::format("{:.1f}\u00B0", value);
    case Metric::aspect_ratio:
    case Metric::edge_ratio:
      break;
  }
  if (value < 100.0) return fmt::format("{:.3g}", value);
  return value < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.1e}", value);
}

std::string axis_title(Metric metric) {
  switch (metric) {
    case Metric::shape:
      return "shape (1: ideal)";
    case Metric::scaled_jacobian:
      return "scaled Jacobian (1: ideal)";
    case Metric::min_angle:
      return "smallest angle (degrees)";
    case Metric::max_angle:
      return "greatest angle (degrees)";
    case Metric::aspect_ratio:
      return "aspect ratio (1: ideal)";
    case Metric::edge_ratio:
      return "longest to shortest edge (1: ideal)";
  }
  return std::string(name(metric));
}

}  // namespace evenmesh
