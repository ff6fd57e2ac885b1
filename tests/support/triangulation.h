// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh::shapes {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Triangles in the xy plane while they are being made: half-edge e = 3 t + i runs from corner i of
/// triangle t to the next one.
struct Triangulation {
  std::vector<Vec3> points;
  std::vector<Index> start;         // per half-edge: the vertex it leaves
  std::vector<std::uint32_t> twin;  // per half-edge: the same side seen from the other triangle

  void reserve(std::size_t vertices, std::size_t triangles);
  void link(std::uint32_t e, std::uint32_t f) {
    if (e != kNone) twin[e] = f;
    if (f != kNone) twin[f] = e;
  }
  /// Returns the half-edge from a to b; the next two numbers are those from b to c and c to a.
  std::uint32_t add_triangle(Index a, Index b, Index c);
};

/// Flips sides until none lies in the circle of a neighbour. Vertices stay.
/// @pre  all triangles are positive; they still are afterwards
void make_delaunay(Triangulation& mesh);

/// The triangles as cells of a mesh.
Cells cells_of(const Triangulation& mesh);

}  // namespace evenmesh::shapes
