// SPDX-License-Identifier: MIT
#include "evenmesh/quality/edge_ratio.h"

#include <limits>

namespace evenmesh {

double edge_ratio(const SurfaceCell& cell) {
  if (!(cell.shortest() > 0.0)) return std::numeric_limits<double>::infinity();
  return cell.longest() / cell.shortest();
}

}  // namespace evenmesh
