// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "evenmesh/quality/quality.h"

namespace evenmesh {

/// The values of a metric that a picture shows.
struct MetricRange {
  double low = 0.0;
  double high = 1.0;
  bool open = false;  // values beyond high exist and count as high
};

/// The range a metric has by nature, [0, 1] for shape; where that is wider than what meshes have,
/// the first of a few usual ranges that holds the values: angles end at 60, 90, 120, 180 or 360
/// degrees. Ratios, which have no upper bound, end at a round number that nearly all cells are
/// below.
MetricRange metric_range(Metric metric, std::span<const CellQuality* const> meshes);

/// How good a value is within the range: 0 for its worst end, 1 for its best. NaN counts as the
/// worst, values beyond an end as that end.
double goodness(Metric metric, const MetricRange& range, double value);

/// A value in the digits that tell cells apart: "0.836", "31.4\u00B0" (degrees), "1.25".
std::string shown_value(Metric metric, double value);

/// "smallest angle (degrees)": the name of a metric with its unit, for an axis.
std::string axis_title(Metric metric);

}  // namespace evenmesh
