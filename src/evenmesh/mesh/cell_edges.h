// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// Calls visit(a, b) with the vertices of every edge of every cell, in the order of the cells. An
/// edge of several cells comes once for each.
template <typename Visit>
void for_each_cell_edge(const Cells& cells, const Visit& visit) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto vertices = cells.vertices(c);
    const int n = static_cast<int>(vertices.size());
    const int edges = edge_count(cells.kind(c), n);
    for (int j = 0; j < edges; ++j) {
      const auto [a, b] = edge(cells.kind(c), n, j);
      visit(vertices[static_cast<std::size_t>(a)], vertices[static_cast<std::size_t>(b)]);
    }
  }
}

}  // namespace evenmesh
