// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/quality/surface_cell.h"
#include "evenmesh/quality/volume_cell.h"

namespace evenmesh {

/// The longest side or edge over the shortest. At least 1; infinite if one has no length. Blind to
/// orientation and to angles.
/// @see  Stimpson et al., The Verdict library reference manual, 2007
double edge_ratio(const SurfaceCell& cell);
double edge_ratio(const VolumeCell& cell);

}  // namespace evenmesh
