// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenmesh/report/shown_mesh.h"

namespace evenmesh {

/// All cells, those that a report should show before others first: the worst with their neighbours,
/// those around the vertices that moved farthest, in a volume mesh those on the boundary, then the
/// others. Boundary cells of a volume, and the others, come in an order in which any first part is
/// spread evenly over all of them.
struct Importance {
  std::vector<std::uint32_t> cells;
  std::size_t outer = 0;  // volume: so many are not inside. Else all
};

/// How many cells of a mesh count as the worst, and how many vertices as those moved farthest.
constexpr std::size_t important(std::size_t cells) {
  return std::min<std::size_t>(500, 10 + cells / 200);
}

Importance rank_cells(const ShownMesh& shown);

}  // namespace evenmesh
