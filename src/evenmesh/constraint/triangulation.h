// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/closest_point.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// The faces of a mesh as triangles, which stay the same when vertices move.
///
/// Faces with four corners and more are cut into one triangle per edge, around the mean of their
/// corners: so the corners are on the surface, the surface of a quad is the same whichever corner
/// comes first, and its middle is that of the bilinear face. Where such a triangle would be turned
/// over (a concave face), the face is cut from one of its corners, if one sees all the others.
class Triangulation {
 public:
  Triangulation() = default;
  /// @param faces  cells of other dimensions than 2 are passed over
  Triangulation(Points points, const Cells& faces);

  /// Numbers beyond those of the vertices are centres.
  std::span<const VertexTriple> triangles() const { return triangles_; }
  /// The corners around a centre.
  /// @pre  number is that of a centre
  std::span<const Index> around(Index number) const { return rings_[number - vertices_]; }
  bool is_centre(Index number) const { return number >= vertices_; }

  /// Where vertices and centres are when the vertices are at some points.
  std::vector<Vec3> positions(Points points) const;

 private:
  std::size_t vertices_ = 0;
  std::vector<VertexTriple> triangles_;
  std::vector<std::vector<Index>> rings_;
};

}  // namespace evenmesh
