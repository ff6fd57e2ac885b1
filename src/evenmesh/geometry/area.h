// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// The area of a polygon times its unit normal, counter-clockwise seen from the normal's tip.
///
///   1/2 sum_i (p_i - p_0) x (p_i+1 - p_0)
///
/// For a polygon that is not planar this is the area of its shadow where the shadow is largest;
/// for a quad it is half the cross product of the diagonals. A triangle's is computed at the
/// corner between its two shorter sides, which keeps a needle's sign and digits.
/// @param corners  at least 3
Vec3 area_vector(std::span<const Vec3> corners);

}  // namespace evenmesh
