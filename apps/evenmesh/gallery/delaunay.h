// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh::gallery {

using TriangleVertices = std::array<Index, 3>;

/// The Delaunay triangles of a convex polygon with points inside, counterclockwise. For hundreds of
/// points: every point is looked for in every triangle.
/// @param points    in the xy plane; the first `boundary` of them are the polygon,
/// counterclockwise,
///                  no three on a line, the others lie inside
/// @pre  boundary >= 3, and there is a point inside
std::vector<TriangleVertices> triangulate(Points points, std::size_t boundary);

}  // namespace evenmesh::gallery
