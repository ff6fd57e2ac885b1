// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/problem/constraints.h"
#include "evenmesh/problem/scene.h"

namespace evenmesh {

/// Keeps the vertices in a plane of symmetry in it, on top of what holds them already.
/// @throws InvalidOption  there are none; the message has the nearest
ConstraintSummary mirror(const Scene& scene, const Symmetry& symmetry, Arrangement& arrangement);

/// Ties the vertices of two sides to each other, and notes them as images. Pairs of which one
/// slides on something curved are fixed.
/// @throws InvalidOption  a vertex without an image; sides without a pair
ConstraintSummary repeat(const Scene& scene, const Periodic& periodic, Arrangement& arrangement);

}  // namespace evenmesh
