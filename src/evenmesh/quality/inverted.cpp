// SPDX-License-Identifier: MIT
#include "evenmesh/quality/inverted.h"

#include <algorithm>

namespace evenmesh {

bool is_inverted(CellKind kind, const SurfaceCell& cell) {
  if (kind != CellKind::quad) return !(cell.sign() > 0.0 && cell.area() > 0.0);
  return std::any_of(cell.corners().begin(), cell.corners().end(),
                     [&](const auto& corner) { return !(cell.sign() * corner.signed_area > 0.0); });
}

bool is_inverted(const VolumeCell& cell) {
  return std::any_of(cell.corners().begin(), cell.corners().end(),
                     [](const auto& corner) { return !(corner.determinant > 0.0); });
}

}  // namespace evenmesh
