// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// A triangle as its three vertices.
using VertexTriple = std::array<Index, 3>;

/// A point of a segment or triangle and where it lies in it.
struct ClosestPoint {
  Vec3 position = Vec3::Zero();
  /// Of the corners: not negative, sum 1. A weight of 1 goes with that corner's very bits.
  Vec3 weights = Vec3::Zero();
  double squared_distance = 0.0;
};

/// The point of the segment from a to b nearest to p; a where both coincide. weights[2] is 0.
/// @pre  fourth powers of the lengths are doubles (unit_scale() sees to that)
ClosestPoint closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p);

/// The point of the triangle nearest to p. A triangle without area is the union of its edges.
/// @pre  fourth powers of the lengths are doubles (unit_scale() sees to that)
ClosestPoint closest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

}  // namespace evenmesh
