// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/bvh.h"
#include "evenmesh/geometry/deviation.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// How far the shape of a mesh may get from that of the input.
///
/// The shape is the surface of a surface mesh, the skin of a volume mesh, and the boundary and the
/// borders between groups of a planar one. Distances are measured both ways at corners, middles of
/// edges and middles of faces (geometry/deviation.h): a vertex that slides along the input exactly
/// still takes the edges between vertices away from it.
class DeviationLimit {
 public:
  /// @param limit  mesh length unit; may be infinite
  DeviationLimit(Workers& workers, const Mesh& input, MeshType type, double limit);

  double limit() const { return limit_; }

  /// The greatest distance, both ways.
  double measure(Workers& workers, Points points) const;

  /// Marks the vertices of all parts that are too far from the input, or from which the input is.
  /// A part whose vertices are all where they were is on the input and the input is on it, so
  /// marked vertices going back ends the deviation.
  /// @param[in,out] marked  one flag per vertex; set, never cleared
  void mark(Workers& workers, Points points, std::vector<char>& marked) const;

 private:
  std::vector<Vec3> with_centres(Points points) const;
  Deviation deviation(Workers& workers, Points points) const;

  double limit_;
  std::vector<std::vector<Index>> rings_;  // corners of the faces that have a centre
  std::vector<VertexTriple> parts_;        // triangles, or segments that repeat a vertex
  std::vector<Vec3> input_;                // points and centres
  std::size_t points_ = 0;
};

}  // namespace evenmesh
