// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/quality/metric.h"

namespace evenmesh {

/// Every measure of every cell.
struct CellQuality {
  /// values[metric][cell]; NaN where the metric does not apply to the kind.
  std::array<std::vector<double>, kMetricCount> values;
  std::vector<char> inverted;  // per cell

  const std::vector<double>& of(Metric metric) const { return values[static_cast<int>(metric)]; }
};

/// How a measure is spread over the cells it applies to. "Worst" is the least value where larger
/// is better and the greatest where smaller is better; p1 and p5 count from the worst end.
struct Distribution {
  std::size_t count = 0;  // cells the metric applies to; all else is 0 when there are none
  double worst = 0.0;
  double p1 = 0.0;  // 1 % of the cells are at most this good (nearest rank)
  double p5 = 0.0;
  double median = 0.0;
  double mean = 0.0;  // infinite as soon as one value is
  double best = 0.0;
};

struct QualitySummary {
  std::array<Distribution, kMetricCount> metrics;
  std::size_t cells = 0;
  std::size_t inverted = 0;

  const Distribution& of(Metric metric) const { return metrics[static_cast<int>(metric)]; }
};

/// Measures all cells at the given positions.
/// @param points  one per vertex of the mesh; pass mesh.points() for the mesh as it is
/// @param orientation  of the input mesh, whatever the points
/// @pre  points.size() == mesh.point_count()
CellQuality measure_cells(Workers& workers, const Mesh& mesh, Points points,
                          const Orientation& orientation);

/// Same bits for any number of workers.
QualitySummary summarize(Workers& workers, const CellQuality& quality);

}  // namespace evenmesh
