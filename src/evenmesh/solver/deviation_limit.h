// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/triangulation.h"
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
  /// @param limit  mesh length unit
  DeviationLimit(const Mesh& input, MeshType type, double limit);

  double limit() const { return limit_; }

  /// The greatest distance, both ways.
  double measure(Workers& workers, Points points) const;

  /// Marks the vertices of all parts that are too far from the input, or from which the input is.
  /// A part whose vertices are all where they were is on the input and the input is on it, so
  /// marked vertices going back ends the deviation.
  /// @param[in,out] marked  one flag per vertex; set, never cleared
  /// @return  the greatest distance, as measure()
  double mark(Workers& workers, Points points, std::vector<char>& marked) const;

 private:
  std::span<const VertexTriple> parts() const;
  Deviation deviation(Workers& workers, Points points) const;

  double limit_;
  Triangulation faces_;              // surface and volume meshes
  std::vector<VertexTriple> edges_;  // planar meshes: segments, which repeat a vertex
  std::vector<Vec3> input_;          // vertices and the centres of faces
  std::optional<Bvh> input_bvh_;     // of input_; none if the mesh has no such parts
};

}  // namespace evenmesh
