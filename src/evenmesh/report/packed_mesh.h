// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "evenmesh/plot/metric_range.h"
#include "evenmesh/quality/metric.h"
#include "evenmesh/report/grid.h"
#include "evenmesh/report/packed_array.h"
#include "evenmesh/report/shown_mesh.h"

namespace evenmesh {

/// A metric whose values are stored in a byte each: low + (high - low) * byte / 254.
struct PackedMetric {
  Metric metric = Metric::shape;
  MetricRange range = {};
};

struct NamedArray {
  std::string name;
  PackedArray array;
};

/// A mesh as it stands in a report: web/README.md describes the arrays.
struct PackedMesh {
  bool is_flat = false;              // all vertices have the same z
  std::vector<std::uint32_t> cells;  // those that are in it, by their numbers in the mesh
  std::size_t vertices = 0;
  Grid grid;
  std::vector<PackedMetric> metrics;
  std::vector<int> iterates;  // numbers of those that are stored
  std::vector<NamedArray> arrays;
  std::vector<std::string> notes;  // what was left out, whole sentences

  /// Of all arrays.
  std::size_t bytes() const;
};

/// Packs as much of a mesh as fits. What does not is left out in this order, and notes say so:
/// iterates; metrics other than shape, the last first; then the grid is coarser; then the numbers
/// of vertices; then cells inside volumes, but for the worst and their neighbours; then others, as
/// rank_cells() has them.
/// @param budget  bytes for the arrays; they may take more only if not one cell fits
PackedMesh pack_mesh(const ShownMesh& shown, std::size_t budget);

}  // namespace evenmesh
