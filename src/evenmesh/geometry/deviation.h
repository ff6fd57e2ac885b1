// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/bvh.h"
#include "evenmesh/geometry/closest_point.h"

namespace evenmesh {

/// How far one surface (or set of segments) is from another, in the length unit of the points.
///
/// Taken at samples: the corners, the middles of the edges and the centroid of each triangle; of a
/// segment, which is a triangle that repeats a vertex, the ends and the middle. Between samples the
/// distance may be greater.
struct OneSidedDeviation {
  double greatest = 0.0;
  /// Over the triangles, of the mean of each one's samples.
  double mean = 0.0;
  /// The greatest of each triangle.
  std::vector<double> of_triangle;
};

/// Zero for a surface without triangles.
/// @param other  has triangles; else every distance is infinite
OneSidedDeviation deviation_from(Points points, std::span<const VertexTriple> triangles,
                                 const Bvh& other, Workers& workers);

/// Both ways: a surface that lies on a part of another is far from it only the other way.
struct Deviation {
  OneSidedDeviation a_from_b;
  OneSidedDeviation b_from_a;

  double greatest() const { return std::max(a_from_b.greatest, b_from_a.greatest); }
};

Deviation deviation_between(Points a_points, std::span<const VertexTriple> a_triangles,
                            Points b_points, std::span<const VertexTriple> b_triangles,
                            Workers& workers);

}  // namespace evenmesh
