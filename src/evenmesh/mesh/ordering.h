// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// True if most cells use vertices with numbers close to each other, as meshers that sweep or
/// bisect leave them. Kernels then find their points in the cache.
bool has_good_order(const Cells& cells);

/// The vertices in breadth-first order (Cuthill and McKee, 1969), which brings neighbours close to
/// each other: each connected piece from an outermost vertex inwards. Vertices that no cell uses
/// come last. O(corners) time.
/// @return  order[k] is the vertex to be numbered k; a permutation of [0, points)
std::vector<Index> breadth_first_order(const Cells& cells, std::size_t points);

}  // namespace evenmesh
