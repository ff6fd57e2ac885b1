// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/quality/surface_cell.h"
#include "evenmesh/quality/volume_cell.h"

namespace evenmesh {

/// The inverse mean ratio at the worst corner.
///
///   d det(T)^(2/d) / |T|^2,   T = A W^-1,   d = 2 or 3
///
/// A has the edges at the corner as columns, W those of the ideal cell; |T| is the Frobenius
/// norm. In [0, 1]: 1 for the ideal cell only, 0 if some corner is flat or turned over.
/// @see  Knupp, Algebraic mesh quality metrics, 2001; Stimpson et al., The Verdict library
///       reference manual, 2007
double shape(const SurfaceCell& cell);
double shape(const VolumeCell& cell);

}  // namespace evenmesh
