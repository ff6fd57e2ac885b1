// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// Some vertices and so many rings of vertices around them: with each ring come the vertices of all
/// cells that have one already.
/// @param vertices  one flag per vertex of the mesh
std::vector<char> with_rings(const Cells& cells, std::vector<char> vertices, int rings);

}  // namespace evenmesh
