// SPDX-License-Identifier: MIT
#include "evenmesh/quality/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace evenmesh {
namespace {

/// det(T) and |T|^2 at one corner of a volume cell.
struct Transformed {
  double determinant;
  double squared_norm;
};

Transformed transformed(CellKind kind, const VolumeCell::Corner& corner) {
  const auto& [a, b, c, determinant] = corner;
  switch (kind) {
    case CellKind::tet:  // |T|^2 is half the sum over the six squared edges
      return {std::numbers::sqrt2 * determinant,
              1.5 * (a.squaredNorm() + b.squaredNorm() + c.squaredNorm()) - a.dot(b) - b.dot(c) -
                  c.dot(a)};
    case CellKind::wedge:  // a and b span the triangle
      return {2.0 / std::numbers::sqrt3 * determinant,
              4.0 / 3.0 * (a.squaredNorm() + b.squaredNorm() - a.dot(b)) + c.squaredNorm()};
    case CellKind::pyramid: {  // c leads to the apex
      const Vec3 rise = c - 0.5 * (a + b);
      return {std::numbers::sqrt2 * determinant,
              a.squaredNorm() + b.squaredNorm() + 2.0 * rise.squaredNorm()};
    }
    default:
      return {determinant, a.squaredNorm() + b.squaredNorm() + c.squaredNorm()};
  }
}

}  // namespace

double shape(const SurfaceCell& cell) {
  const auto& [sine, cosine, tangent] = cell.regular();
  double least = 1.0;
  for (const SurfaceCell::Corner& corner : cell.corners()) {
    const double area = cell.sign() * corner.signed_area;
    if (!(area > 0.0)) return 0.0;
    const double norm =
        corner.next * corner.next + corner.previous * corner.previous - 2.0 * cosine * corner.dot;
    least = std::min(least, 2.0 * sine * area / norm);
  }
  return least;
}

double shape(const VolumeCell& cell) {
  double least = 1.0 / 27.0;  // of det(T)^2 / |T|^6: one cube root is enough
  for (const VolumeCell::Corner& corner : cell.corners()) {
    const auto [determinant, norm] = transformed(cell.kind(), corner);
    if (!(determinant > 0.0)) return 0.0;
    least = std::min(least, determinant * determinant / (norm * norm * norm));
  }
  return std::min(1.0, 3.0 * std::cbrt(least));
}

}  // namespace evenmesh
