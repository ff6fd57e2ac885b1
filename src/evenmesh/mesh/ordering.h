// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// True if most cells use vertices with numbers close to each other, as meshers that sweep or
/// bisect leave them. Kernels then find their points in the cache.
bool has_good_order(const Cells& cells);

/// Two permutations: what is to be numbered k.
struct Ordering {
  std::vector<Index> vertices;
  std::vector<std::uint32_t> cells;
};

/// Vertices in breadth-first order (Cuthill and McKee, 1969), which brings neighbours close to each
/// other, and cells by their least vertex. Vertices that no cell uses come last. O(n log n) time:
/// a mesh in random order is first sorted along a space-filling curve (Morton, 1966), because a
/// breadth-first walk through scattered memory takes several times longer than both together.
Ordering breadth_first_order(const Mesh& mesh);

/// Calls body(vertices, cell) for cells in a given order. What it will read is asked for some cells
/// ahead: in an order that jumps through memory this takes a third of the time.
template <class Body>
void for_cells_in(std::span<const std::uint32_t> order, const Cells& cells, Body body) {
  constexpr std::size_t kAhead = 24;
  const Offset* const offsets = cells.offsets().data();
  const Index* const corners = cells.corners().data();
  const CellKind* const kinds = cells.kinds().data();
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i + 2 * kAhead < order.size()) {
      __builtin_prefetch(offsets + order[i + 2 * kAhead]);
      __builtin_prefetch(kinds + order[i + 2 * kAhead]);
    }
    if (i + kAhead < order.size()) __builtin_prefetch(corners + offsets[order[i + kAhead]]);
    body(cells.vertices(order[i]), order[i]);
  }
}

}  // namespace evenmesh
