// SPDX-License-Identifier: MIT
#include "evenmesh/cost/cost.h"

#include "evenmesh/cost/edges.h"

namespace evenmesh {

void Cost::add_springs(const CellBlock& cells, Points /*x*/, std::vector<Spring>& springs) const {
  const std::vector<LocalEdge> edges = local_edges(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto cell = cells.cell(i);
    for (const auto [a, b] : edges) springs.push_back({cell[a], cell[b], 2.0});
  }
}

}  // namespace evenmesh
