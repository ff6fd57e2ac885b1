// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// The same figure, moved to the origin and brought to a size near 1.
///
/// The first point becomes the origin and the rest is multiplied by a power of two, so that the
/// largest coordinate is in [1/2, 1). Works for every finite input: differences that overflow and
/// denormal numbers included. Points that coincide, and input that is not finite, give zeros.
std::vector<Vec3> unit_sized(std::span<const Vec3> points);

}  // namespace evenmesh
