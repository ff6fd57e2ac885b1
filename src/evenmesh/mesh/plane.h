// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// The unit normal of a plane that all vertices lie in.
///
/// Where all have the same x, y or z to the last bit, the normal is exactly that axis. Otherwise it
/// is that of the better of two planes: one through three points far apart, and the least-squares
/// plane. Of the two normals the one that points up (then forth, then right) is taken. Vertices on
/// one line lie in many planes; the most horizontal is taken.
///
/// @param vertices   which points count; repetitions do no harm
/// @param tolerance  how far from the plane a vertex may lie, relative to the diagonal of their box
/// @return           nothing if there are no vertices or they lie in no plane
std::optional<Vec3> common_plane(Points points, std::span<const Index> vertices, double tolerance);

}  // namespace evenmesh
