// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"

namespace evenmesh {

/// Some vertices of a mesh with the cells around them, as a mesh and a problem of their own in
/// which all other vertices are fixed.
struct Part {
  Mesh mesh;                         // where vertices are in the whole mesh
  Problem problem;                   // without functions, targets and ties
  std::vector<Index> vertices;       // vertex k here is vertices[k] in the whole
  std::vector<std::uint32_t> cells;  // the same for cells

  /// Of the whole mesh's vertices those that are here.
  std::vector<Vec3> select(Points points) const;
};

/// @param moving  per vertex: may move in the part if it may in the whole
/// @pre  nothing that moves is tied to another vertex or belongs to a function with bounds
Part part_around(const Mesh& mesh, const Problem& problem, std::span<const char> moving);

}  // namespace evenmesh
