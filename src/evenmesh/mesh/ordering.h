// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
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

}  // namespace evenmesh
