// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/quality/angles.h"
#include "evenmesh/quality/volume_cell.h"

namespace evenmesh {

/// The smallest and the largest angle between two faces that meet in an edge.
///
/// Taken at both ends of every edge: the angle about edge a between the half-planes that hold the
/// other two edges of the corner, b and c,
///
///   atan2(|a| |det(a, b, c)|, (a x b) . (a x c))
///
/// Both ends agree where the faces are planar, and so they do at the apex of a pyramid. In
/// [0, 180]; {0, 180} if an edge has no length or a face has a straight corner. Blind to
/// orientation. Exact to rounding for slivers too: no arc cosine is taken.
AngleRange angle_range(const VolumeCell& cell);

}  // namespace evenmesh
