// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/quality/surface_cell.h"

namespace evenmesh {

struct AngleRange {
  double min, max;  // degrees
};

/// The smallest and the largest interior angle of a surface cell.
///
/// A corner that turns inwards, seen along the cell's own normal, has more than 180 degrees.
/// {0, 180} if a side has no length. Exact to rounding for needles too: no arc cosine is taken.
AngleRange angle_range(const SurfaceCell& cell);

}  // namespace evenmesh
