// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// The area of a surface cell or the volume of a volume cell, negative where it is turned over as a
/// whole: against the plane's normal, or against the sense it is wound in. Surface cells in space
/// have no such side and count as they are.
double oriented_size(const Mesh& mesh, const Orientation& orientation, std::size_t cell);

/// The mean length of the edges of cells around each vertex, an edge of two cells counted twice; 0
/// where there are none.
std::vector<double> local_edge_lengths(const Mesh& mesh);

/// Area (or volume) of the ideal cell of a kind with all edges 1: a regular polygon, a regular
/// tet, a cube, ...
double ideal_measure(CellKind kind, int vertices);

/// The least signed measure over a cell's corners, twice a triangle's area (or six times a tet's
/// volume) each: positive at every corner means not inverted, but for a hex or wedge, which may be
/// so in between (whole_cell.h). Surface cells count about `up`, and a polygon, which may be
/// concave, with twice its whole area instead.
/// @param vertex(i)  position of the cell's i-th vertex
/// @param up         surface cells: a unit vector
/// @param sign       volume cells: -1 if wound the other way on purpose
template <typename VertexPosition>
double least_corner(CellKind kind, int vertices, const VertexPosition& vertex, const Vec3& up,
                    double sign);

// ---- implementation ----

template <typename VertexPosition>
double least_corner(CellKind kind, int vertices, const VertexPosition& vertex, const Vec3& up,
                    double sign) {
  if (kind == CellKind::polygon) {
    Vec3 sum = Vec3::Zero();
    for (int i = 2; i < vertices; ++i) {
      sum += (vertex(i - 1) - vertex(0)).cross(vertex(i) - vertex(0));
    }
    return sum.dot(up);
  }
  if (kind == CellKind::triangle) {
    return (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)).dot(up);
  }
  double least = std::numeric_limits<double>::infinity();
  const CellTraits& table = traits(kind);
  for (const CellTraits::Corner& corner : table.corners) {
    const Vec3& at = vertex(corner.vertex);
    const Vec3 normal =
        (vertex(corner.neighbours[0]) - at).cross(vertex(corner.neighbours[1]) - at);
    const double value = table.dimension == 2
                             ? normal.dot(up)
                             : sign * normal.dot(vertex(corner.neighbours[2]) - at);
    least = std::min(least, value);
  }
  return least;
}

}  // namespace evenmesh
