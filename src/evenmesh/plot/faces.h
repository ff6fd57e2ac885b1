// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// The polygons that can be seen of a mesh: its surface cells, or the skin of its volume cells.
struct Faces {
  Cells polygons;
  std::vector<std::uint32_t> cells;  // per polygon, the cell that it belongs to
};

/// A mesh with a volume cell shows its skin, the faces with one incident cell, and nothing else.
Faces find_faces(const Mesh& mesh);

}  // namespace evenmesh
