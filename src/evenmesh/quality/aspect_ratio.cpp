// SPDX-License-Identifier: MIT
#include "evenmesh/quality/aspect_ratio.h"

#include <algorithm>
#include <limits>

namespace evenmesh {
namespace {

/// A quad counts as the two triangles on either side of its diagonal from the first to the third
/// corner, as in VTK 9.1: the plain area if it is planar and convex, somewhat more if it is not.
double area(const SurfaceCell& cell) {
  if (cell.corners().size() != 4) return cell.area();
  return 0.5 * (cell.corners()[1].area + cell.corners()[3].area);
}

}  // namespace

double aspect_ratio(const SurfaceCell& cell) {
  const double size = 4.0 * cell.regular().tangent * area(cell);
  if (!(size > 0.0)) return std::numeric_limits<double>::infinity();
  return std::max(1.0, cell.longest() * cell.perimeter() / size);
}

}  // namespace evenmesh
