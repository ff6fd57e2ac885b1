// SPDX-License-Identifier: MIT
#include "evenmesh/quality/edge_ratio.h"

#include <limits>

namespace evenmesh {
namespace {

double ratio(double longest, double shortest) {
  return shortest > 0.0 ? longest / shortest : std::numeric_limits<double>::infinity();
}

}  // namespace

double edge_ratio(const SurfaceCell& cell) { return ratio(cell.longest(), cell.shortest()); }

double edge_ratio(const VolumeCell& cell) { return ratio(cell.longest(), cell.shortest()); }

}  // namespace evenmesh
