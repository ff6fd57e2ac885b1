// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"

namespace evenmesh {

/// The box that holds some points: its middle and half its longest edge.
struct Extent {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();

  Vec3 middle() const { return low / 2.0 + high / 2.0; }  // the sum of both might overflow
  double half() const { return (high / 2.0 - low / 2.0).maxCoeff(); }
  double diagonal() const { return (high - low).stableNorm(); }
};

/// @return  a point at the origin if there are no vertices
Extent extent_of(Points points, std::span<const Index> vertices);

/// Twice the area of a closed polygon, along its normal, counter-clockwise positive (Newell).
///
///   sum over i: (x_i - x_0) / unit  x  (x_i+1 - x_0) / unit
///
/// @param unit  a length in which the cell is neither huge nor tiny, > 0
Vec3 doubled_area(Points points, std::span<const Index> vertices, double unit);

/// The unit normal of a surface cell of any size; zero where the area is zero up to rounding.
Vec3 unit_normal(Points points, std::span<const Index> vertices);

/// The signed volume of a volume cell in cubes of unit: positive if wound as its kind says. A quad
/// face counts as the mean of its two ways to be cut into triangles, which is exact for the
/// bilinear face.
double volume(CellKind kind, Points points, std::span<const Index> vertices, double unit);

}  // namespace evenmesh
