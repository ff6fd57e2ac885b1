// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/quality/surface_cell.h"
#include "evenmesh/quality/volume_cell.h"

namespace evenmesh {

/// The least corner determinant over the lengths of the edges at that corner, divided by the same
/// of the ideal cell.
///
/// In [-1, 1]: 1 for the ideal cell, 0 where a corner is flat or an edge has no length, negative
/// where a corner is turned over. Unlike shape it does not see stretching: every rectangle and
/// every box has 1. docs/quality.md says how each kind does it.
/// @see  Stimpson et al., The Verdict library reference manual, 2007
double scaled_jacobian(const SurfaceCell& cell);
double scaled_jacobian(const VolumeCell& cell);

}  // namespace evenmesh
