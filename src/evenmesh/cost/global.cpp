// SPDX-License-Identifier: MIT
#include "evenmesh/cost/global.h"

#include <cmath>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/cost/edges.h"
#include "evenmesh/mesh/cell_edges.h"
#include "evenmesh/mesh/measure.h"

namespace evenmesh {

Global::Global(double length, Scaling scaling)
    : length_(length), weight_(scaling == Scaling::scale_free ? 1.0 / (length * length) : 1.0) {
  if (!(length > 0.0) || !std::isfinite(length)) {
    throw InvalidOption(
        fmt::format("the common edge length of the cost global must be positive, not {}", length));
  }
}

double Global::evaluate(const CellBlock& cells, Points x, double weight,
                        std::span<Vec3> gradient) const {
  return sum_over_edge_lengths(cells, x, weight, gradient, [this](auto lengths, auto slopes) {
    double sum = 0.0;
    for (std::size_t j = 0; j < lengths.size(); ++j) {
      const double excess = lengths[j] - length_;
      sum += weight_ * excess * excess;
      slopes[j] = 2.0 * weight_ * excess;
    }
    return sum;
  });
}

void Global::add_springs(const CellBlock& cells, Points /*x*/, std::vector<Spring>& springs) const {
  const std::vector<LocalEdge> edges = local_edges(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto cell = cells.cell(i);
    for (const auto [a, b] : edges) springs.push_back({cell[a], cell[b], 2.0 * weight_});
  }
}

double mean_edge_length(const Mesh& mesh) {
  double sum = 0.0;
  std::size_t count = 0;
  for_each_cell_edge(mesh.cells(), [&](Index a, Index b) {
    sum += (mesh.points()[b] - mesh.points()[a]).norm();
    ++count;
  });
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

double length_from_size(const Mesh& mesh, const Orientation& orientation) {
  const Cells& cells = mesh.cells();
  const int dimension = orientation.type == MeshType::volume ? 3 : 2;
  double size = 0.0;
  double ideal = 0.0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (traits(cells.kind(c)).dimension != dimension) continue;
    ideal += ideal_measure(cells.kind(c), static_cast<int>(cells.vertices(c).size()));
    size += oriented_size(mesh, orientation, c);
  }
  return ideal > 0.0 ? std::pow(std::abs(size) / ideal, 1.0 / dimension) : 0.0;
}

}  // namespace evenmesh
