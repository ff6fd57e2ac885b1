// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "evenmesh/plot/metric_range.h"
#include "evenmesh/quality/quality.h"

namespace evenmesh {

/// The cells of a mesh by their value of a metric.
struct QualityBins {
  std::vector<std::size_t> counts;  // equal bins over the range, the upper end belongs to the last
  std::size_t inverted = 0;         // in no other bin
  std::size_t beyond = 0;           // better or worse than the range goes, or infinite
  std::size_t total = 0;            // cells that the metric applies to
};

/// @param bins  how many, > 0
QualityBins count_bins(const CellQuality& quality, Metric metric, const MetricRange& range,
                       int bins);

/// One mesh of a histogram.
struct HistogramMesh {
  std::string name;  // "before"; any bytes
  const CellQuality& quality;
};

struct HistogramOptions {
  std::string title = {};
  Metric metric = Metric::shape;
  int bins = 40;
  double width = 640.0;  // of the picture, pixels
  double height = 420.0;
};

/// How many cells have which quality, as a standalone SVG picture: the first mesh filled, the
/// second in outline, in shares of their cells. Inverted cells have a red bin of their own left of
/// the others. Worst and mean are marked above.
/// @pre  one mesh or two; bins > 0
std::string quality_histogram(const std::vector<HistogramMesh>& meshes,
                              const HistogramOptions& options = {});

}  // namespace evenmesh
