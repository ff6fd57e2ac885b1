// SPDX-License-Identifier: MIT
#include "evenmesh/cost/local.h"

#include "evenmesh/cost/edges.h"
#include "evenmesh/cost/spread.h"

namespace evenmesh {

double Local::evaluate(const CellBlock& cells, Points x, double weight,
                       std::span<Vec3> gradient) const {
  if (scaling_ == Scaling::scale_free) {
    return sum_over_edge_lengths(cells, x, weight, gradient, [](auto lengths, auto slopes) {
      return relative_spread(lengths, slopes);
    });
  }
  return sum_over_edge_lengths(cells, x, weight, gradient,
                               [](auto lengths, auto slopes) { return spread(lengths, slopes); });
}

void Local::add_springs(const CellBlock& cells, Points x, std::vector<Spring>& springs) const {
  if (scaling_ == Scaling::absolute) return Cost::add_springs(cells, x, springs);
  const std::vector<LocalEdge> edges = local_edges(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto cell = cells.cell(i);
    double mean = 0.0;
    for (const auto [a, b] : edges) mean += (x[cell[b]] - x[cell[a]]).norm();
    mean /= static_cast<double>(edges.size());
    if (!(mean > 0.0)) continue;
    for (const auto [a, b] : edges) springs.push_back({cell[a], cell[b], 2.0 / (mean * mean)});
  }
}

}  // namespace evenmesh
