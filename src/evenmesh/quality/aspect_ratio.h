// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/quality/surface_cell.h"
#include "evenmesh/quality/volume_cell.h"

namespace evenmesh {

/// Longest side times perimeter over area, 1 for the regular polygon.
///
///   l_max (l_1 + ... + l_n) / (4 tan(pi / n) A)
///
/// At least 1; infinite if the cell has no area. Blind to orientation. The area of a quad that is
/// not planar is that of two triangles and depends a little on which corner is the first.
/// @see  Stimpson et al., The Verdict library reference manual, 2007, for n = 3 and 4
double aspect_ratio(const SurfaceCell& cell);

/// Longest edge times surface over volume, 1 for the ideal cell.
///
///   l_max (A_1 + ... + A_n) / (k V),   k the same of the ideal cell
///
/// That of polygons with one dimension more; of a tet it is the longest edge over the radius of the
/// inscribed ball. At least 1; infinite if the cell has no volume. Blind to orientation.
/// @see  Stimpson et al., The Verdict library reference manual, 2007, for the tet
double aspect_ratio(const VolumeCell& cell);

}  // namespace evenmesh
