// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// An edge as its two vertices.
using VertexPair = std::array<Index, 2>;

/// Marks the corners of a network of curves: the vertices at which other than two of its edges
/// meet, and those at which the two turn by more than an angle. A turn at an edge of length zero is
/// not known and counts as sharp.
///
/// @param edges        every edge of the network once, two different vertices each
/// @param angle_rad    in (0, pi)
/// @param[out] corners one flag per point; set, never cleared
void mark_corners(Points points, std::span<const VertexPair> edges, double angle_rad,
                  std::vector<char>& corners);

}  // namespace evenmesh
