// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// How each vertex may move: not at all, in a plane, or freely.
///
/// This eliminates the constraint instead of imposing it: x = x_0 + Z y with an orthonormal block
/// Z of 0, 2 or 3 columns per vertex. Solvers keep to it by projecting gradients and steps with
/// Z Z^T, so what they move stays in x_0 + range(Z).
class Motion {
 public:
  enum class Freedom : std::uint8_t { fixed, plane, free };

  Motion() = default;
  /// @param fixed  per vertex: may not move
  /// @pre  fixed has one entry per vertex of the mesh
  ///
  /// Vertices that are not fixed move in the plane of a planar mesh, freely inside a volume mesh,
  /// and in the tangent plane of the input surface on a surface mesh. The tangent plane is normal
  /// to the area-weighted mean of the normals of the incident cells, each turned to agree with the
  /// greatest of them; where that is undefined (no area around) the vertex is fixed. Vertices
  /// that belong to no cell are fixed.
  Motion(const Mesh& mesh, const Orientation& orientation, std::span<const char> fixed);

  std::size_t size() const { return freedom_.size(); }
  Freedom freedom(Index vertex) const { return freedom_[vertex]; }
  void fix(Index vertex) { freedom_[vertex] = Freedom::fixed; }
  /// Vertices that may move.
  std::size_t moving() const;

  /// Unit normal of the plane the vertex moves in; zero if it is not bound to a plane.
  const Vec3& normal(Index vertex) const {
    return freedom_[vertex] != Freedom::plane ? kNoNormal
           : normals_.size() == 1             ? normals_[0]
                                              : normals_[vertex];
  }

  /// The part of a vector that the vertex may follow, Z Z^T d.
  Vec3 project(Index vertex, const Vec3& d) const {
    if (freedom_[vertex] == Freedom::fixed) return kNoNormal;
    const Vec3& n = normal(vertex);
    return d - n.dot(d) * n;
  }

  /// The same for vertices in another order: vertex k of the result is order[k] here.
  Motion renumbered(std::span<const Index> order) const;

 private:
  static const Vec3 kNoNormal;

  std::vector<Freedom> freedom_;
  std::vector<Vec3> normals_;  // one for all (planar), one per vertex (surface), or none
};

}  // namespace evenmesh
