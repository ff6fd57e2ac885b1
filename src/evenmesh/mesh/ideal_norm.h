// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <type_traits>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"
#include "evenmesh/mesh/determinants.h"

namespace evenmesh {

/// T = A W^-1 at a corner of a volume cell, A having its edges and W those of the ideal cell.
struct IdealNorm {
  double value;           // |T|^2, Frobenius
  double factor;          // det T over the determinant of the edges
  Vec3 by_p, by_q, by_r;  // half the derivatives of value with respect to the edges
};

/// @pre  traits(kind).dimension == 3
template <CellKind kind>
IdealNorm ideal_norm(const SpaceCorner& corner) {
  const Vec3& p = corner.p;
  const Vec3& q = corner.q;
  const Vec3& r = corner.r;
  if constexpr (kind == CellKind::tet) {
    const Vec3 a = 1.5 * p - 0.5 * (q + r);
    const Vec3 b = 1.5 * q - 0.5 * (r + p);
    const Vec3 c = 1.5 * r - 0.5 * (p + q);
    return {a.dot(p) + b.dot(q) + c.dot(r), std::numbers::sqrt2, a, b, c};
  } else if constexpr (kind == CellKind::wedge) {  // p and q span the triangle
    const Vec3 a = 4.0 / 3.0 * (p - 0.5 * q);
    const Vec3 b = 4.0 / 3.0 * (q - 0.5 * p);
    return {a.dot(p) + b.dot(q) + r.squaredNorm(), 2.0 / std::numbers::sqrt3, a, b, r};
  } else if constexpr (kind == CellKind::pyramid) {  // r leads to the apex
    const Vec3 rise = r - 0.5 * (p + q);
    return {p.squaredNorm() + q.squaredNorm() + 2.0 * rise.squaredNorm(), std::numbers::sqrt2,
            p - rise, q - rise, 2.0 * rise};
  } else {
    static_assert(kind == CellKind::hex);
    return {p.squaredNorm() + q.squaredNorm() + r.squaredNorm(), 1.0, p, q, r};
  }
}

/// Calls body with the kind of a volume cell as a std::integral_constant.
template <typename Body>
auto with_volume_kind(CellKind kind, const Body& body) {
  switch (kind) {
    case CellKind::tet:
      return body(std::integral_constant<CellKind, CellKind::tet>());
    case CellKind::wedge:
      return body(std::integral_constant<CellKind, CellKind::wedge>());
    case CellKind::pyramid:
      return body(std::integral_constant<CellKind, CellKind::pyramid>());
    default:
      return body(std::integral_constant<CellKind, CellKind::hex>());
  }
}

}  // namespace evenmesh
