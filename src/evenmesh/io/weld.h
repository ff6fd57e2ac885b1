// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// Finds the vertices of a triangle soup: corners with equal coordinates are one vertex.
///
/// Equal means equal as numbers, so -0 and 0 are. Vertices are numbered as they first come, and
/// keep the coordinates (and the sign of zero) of their first corner.
/// Expected O(1) time per corner; about 40 bytes per vertex.
class Welder {
 public:
  /// The vertex of a corner; a new one if no earlier corner lies there.
  /// @pre  position is finite and there are fewer than 2^32 - 2 vertices
  Index add(const Vec3& position);

  const std::vector<Vec3>& points() const { return points_; }
  std::vector<Vec3> take_points() { return std::move(points_); }

 private:
  void grow();
  std::size_t slot_of(const Vec3& position) const;

  std::vector<Vec3> points_;
  std::vector<Index> slots_;  // open addressing; a power of two, at most half full
};

/// Makes one of vertices that are at most `tolerance` apart, also by way of others in between. The
/// vertex keeps the place of the first of them.
/// @param[in,out] points  distinct positions; what is left of them afterwards
/// @return                the new number of every old vertex
/// @pre tolerance > 0 and finite
std::vector<Index> merge_close(std::vector<Vec3>& points, double tolerance);

}  // namespace evenmesh
