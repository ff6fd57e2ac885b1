// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/mesh/cell_kind.h"
#include "evenmesh/quality/surface_cell.h"
#include "evenmesh/quality/volume_cell.h"

namespace evenmesh {

/// Whether the cell counts as inverted; is_inverted() in metric.h says when it does.
bool is_inverted(CellKind kind, const SurfaceCell& cell);
bool is_inverted(const VolumeCell& cell);

}  // namespace evenmesh
