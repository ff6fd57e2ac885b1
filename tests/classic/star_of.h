// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "evenmesh/classic/stars.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh::testing_classic {

/// Triangles around vertex 0, the others in a ring about it, counterclockwise.
inline Mesh fan(const Vec3& centre, const std::vector<Vec3>& ring) {
  std::vector<Vec3> points = {centre};
  points.insert(points.end(), ring.begin(), ring.end());
  Cells cells;
  const auto n = static_cast<Index>(ring.size());
  for (Index k = 0; k < n; ++k) {
    cells.add(CellKind::triangle, std::vector<Index>{0, 1 + k, 1 + (k + 1) % n});
  }
  return Mesh(std::move(points), std::move(cells));
}

inline std::vector<Vec3> regular_ring(int n) {
  std::vector<Vec3> ring;
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / n;
    ring.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  return ring;
}

/// An L of six vertices. From the corner of the L all of it can be seen; the mean of its vertices
/// lies outside.
inline std::vector<Vec3> l_shape() {
  return {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};
}

/// What a rule needs at one vertex of a mesh of which nothing else moves.
class Around {
 public:
  Around(Mesh mesh, Index vertex)
      : mesh_(std::move(mesh)),
        orientation_(find_orientation(mesh_)),
        motion_(mesh_, orientation_, all_but(vertex)),
        stars_(mesh_, motion_),
        vertex_(vertex) {}

  const Mesh& mesh() const { return mesh_; }
  const Orientation& orientation() const { return orientation_; }
  const Motion& motion() const { return motion_; }
  Star star() const { return stars_.of(vertex_); }
  Points points() const { return mesh_.points(); }

 private:
  std::vector<char> all_but(Index vertex) const {
    std::vector<char> fixed(mesh_.point_count(), 1);
    fixed[vertex] = 0;
    return fixed;
  }

  Mesh mesh_;
  Orientation orientation_;
  Motion motion_;
  Stars stars_;
  Index vertex_;
};

}  // namespace evenmesh::testing_classic
