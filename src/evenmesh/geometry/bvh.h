// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/closest_point.h"
#include "evenmesh/geometry/unit_scale.h"

namespace evenmesh {

/// A tree of boxes around triangles that finds the one nearest to a point.
///
/// A segment is a triangle that repeats a vertex. Triangles without area do no harm. Of equally
/// near triangles the least is found. The same input gives the same answer everywhere.
///
/// Built in O(n log n) time, about 70 bytes per triangle of a mesh; const, safe to ask from several
/// threads. A point near the surface sees O(log n) of it.
class Bvh {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  struct Hit {
    std::uint32_t triangle = kNone;  // kNone: none is near enough
    Vec3 position = Vec3::Zero();
    double distance = std::numeric_limits<double>::infinity();

    bool found() const { return triangle != kNone; }
  };

  /// @param points     finite; copied
  /// @param triangles  vertices as numbers of points; fewer than 2^32 - 1
  Bvh(Points points, std::span<const VertexTriple> triangles);

  /// The nearest point of all triangles.
  /// @param upper_bound  what is farther is not looked for; the search is the faster for a small
  /// one
  Hit closest(const Vec3& p, double upper_bound = std::numeric_limits<double>::infinity()) const;

  /// The nearest point of the triangles whose normals make an angle with the given one of which the
  /// cosine is least_cosine or more; of those without area, none. So a point on one side of a thin
  /// wall does not find the other.
  /// @param normal  not zero; of any length
  Hit closest_facing(const Vec3& p, const Vec3& normal, double least_cosine = 0.0,
                     double upper_bound = std::numeric_limits<double>::infinity()) const;

  /// The nearest point of one triangle.
  Hit closest_on(std::uint32_t triangle, const Vec3& p) const;

  std::size_t triangles() const { return order_.size(); }

 private:
  /// Boxes are rounded outward to single precision. The children of an inner node are next to each
  /// other.
  struct Node {
    std::array<float, 3> low;
    std::array<float, 3> high;
    std::uint32_t first = 0;  // leaf: its first triangle; inner node: its first child
    std::uint32_t count = 0;  // leaf: how many triangles; inner node: 0
  };

  class Builder;
  template <class Accept>
  Hit search(const Vec3& p, double upper_bound, const Accept& accept) const;
  ClosestPoint closest_in(std::uint32_t place, const Vec3& x) const;

  UnitScale scale_;
  std::vector<Vec3> points_;             // times scale_.to_unit
  std::vector<Node> nodes_;              // nodes_[0] is the root; empty if there are no triangles
  std::vector<VertexTriple> triangles_;  // in the order of the leaves
  std::vector<std::uint32_t> order_;     // their numbers
  std::vector<std::uint32_t> places_;    // by number: where they are in order_
};

}  // namespace evenmesh
