// SPDX-License-Identifier: MIT
#include "evenmesh/quality/inverted.h"

#include <algorithm>

#include "evenmesh/mesh/whole_cell.h"

namespace evenmesh {

bool is_inverted(CellKind kind, const SurfaceCell& cell) {
  if (kind != CellKind::quad) return !(cell.sign() > 0.0 && cell.area() > 0.0);
  return std::any_of(cell.corners().begin(), cell.corners().end(),
                     [&](const auto& corner) { return !(cell.sign() * corner.signed_area > 0.0); });
}

bool is_inverted(const VolumeCell& cell) {
  const bool is_at_corner =
      std::any_of(cell.corners().begin(), cell.corners().end(),
                  [](const auto& corner) { return !(corner.determinant > 0.0); });
  if (is_at_corner || cell.kind() == CellKind::tet || cell.kind() == CellKind::pyramid) {
    return is_at_corner;
  }
  return !is_positive_everywhere(cell.kind(), cell.points(), cell.sign());
}

}  // namespace evenmesh
