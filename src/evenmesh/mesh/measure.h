// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"

namespace evenmesh {

/// Half the sum of the cross products around a polygon: its normal, as long as its area. Exact for
/// planar polygons, the mean over all triangulations otherwise.
Vec3 area_vector(std::span<const Vec3> corners);

/// Signed volume of a volume cell, its faces taken as fans around their vertex means; positive for
/// the vertex order of CellKind.
/// @pre  kind is a volume kind and corners has its vertices
double cell_volume(CellKind kind, std::span<const Vec3> corners);

/// Area (or volume) of the ideal cell of a kind with all edges 1: a regular polygon, a regular
/// tet, a cube, ...
double ideal_measure(CellKind kind, int vertices);

}  // namespace evenmesh
