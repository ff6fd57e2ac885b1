// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenmesh/report/shown_mesh.h"

namespace evenmesh {

/// All cells, those that a report should show before others first: the kImportantCells worst with
/// their neighbours, those around the vertices that moved farthest, in a volume mesh those on the
/// boundary, then the others. Boundary cells of a volume, and the others, come in an order in which
/// any first part is spread evenly over all of them.
struct Importance {
  std::vector<std::uint32_t> cells;
  std::size_t outer = 0;  // volume: so many are not inside. Else all
};

inline constexpr std::size_t kImportantCells = 500;

Importance rank_cells(const ShownMesh& shown);

}  // namespace evenmesh
