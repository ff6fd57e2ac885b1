// SPDX-License-Identifier: MIT
#include "evenmesh/quality/aspect_ratio.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace evenmesh {
namespace {

/// A quad counts as the two triangles on either side of its diagonal from the first to the third
/// corner, as in VTK 9.1: the plain area if it is planar and convex, somewhat more if it is not.
double area(const SurfaceCell& cell) {
  if (cell.corners().size() != 4) return cell.area();
  return 0.5 * (cell.corners()[1].area + cell.corners()[3].area);
}

struct Size {
  double surface = 0.0;
  double volume = 0.0;  // signed
};

/// A quad counts with its vector area on the surface, which is exact if it is planar, and as its
/// bilinear face to the volume, which is exact always.
Size size(const VolumeCell& cell) {
  Size result;
  for (const auto& [count, v] : traits(cell.kind()).faces) {
    const Vec3& a = cell.points()[v[0]];
    const Vec3& b = cell.points()[v[1]];
    const Vec3& c = cell.points()[v[2]];
    if (count == 3) {
      const Vec3 normal = (b - a).cross(c - a);
      result.surface += normal.norm();
      result.volume += a.dot(normal);
    } else {
      const Vec3& d = cell.points()[v[3]];
      const Vec3 normal = (c - a).cross(d - b);
      result.surface += normal.norm();
      result.volume += 0.25 * (a + b + c + d).dot(normal);
    }
  }
  return {result.surface / 2.0, result.volume / 6.0};
}

/// Surface over volume of the ideal cell, whose edges are 1.
double ideal_value(CellKind kind) {
  using std::numbers::sqrt2;
  using std::numbers::sqrt3;
  switch (kind) {
    case CellKind::tet:
      return 6.0 * sqrt2 * sqrt3;
    case CellKind::wedge:
      return 2.0 + 4.0 * sqrt3;
    case CellKind::pyramid:
      return 3.0 * sqrt2 * (1.0 + sqrt3);
    default:
      return 6.0;
  }
}

}  // namespace

double aspect_ratio(const SurfaceCell& cell) {
  const double size = 4.0 * cell.regular().tangent * area(cell);
  if (!(size > 0.0)) return std::numeric_limits<double>::infinity();
  return std::max(1.0, cell.longest() * cell.perimeter() / size);
}

double aspect_ratio(const VolumeCell& cell) {
  const auto [surface, signed_volume] = size(cell);
  const double volume = ideal_value(cell.kind()) * std::abs(signed_volume);
  if (!(volume > 0.0)) return std::numeric_limits<double>::infinity();
  return std::max(1.0, cell.longest() * surface / volume);
}

}  // namespace evenmesh
