// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"

// The Jacobian determinants of cells with their derivatives; least_corner() in mesh/measure.h has
// the least of the same values.

namespace evenmesh {

/// How many determinants tell whether a cell is inverted: one per corner, of which triangles and
/// tets have the same everywhere; a polygon, which may be concave, has twice its area.
inline std::size_t determinants_of(CellKind kind) {
  if (kind == CellKind::triangle || kind == CellKind::tet || kind == CellKind::polygon) return 1;
  return traits(kind).corners.size();
}

/// Twice a polygon's area about a direction.
struct PolygonArea {
  std::span<const Index> vertices;
  Points x;
  Vec3 up;

  double determinant() const {
    Vec3 sum = Vec3::Zero();
    const Vec3& first = x[vertices[0]];
    for (std::size_t i = 2; i < vertices.size(); ++i) {
      sum += (x[vertices[i - 1]] - first).cross(x[vertices[i]] - first);
    }
    return sum.dot(up);
  }
  void add_gradient(double factor, std::span<Vec3> gradient) const {
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 across = x[vertices[(i + 1) % n]] - x[vertices[(i + n - 1) % n]];
      gradient[vertices[i]] += factor * across.cross(up);
    }
  }
};

/// (p x q).up at a corner of a surface cell.
struct PlaneCorner {
  std::array<Index, 3> vertices;
  Vec3 p, q, up;

  PlaneCorner(Index at, Index next, Index previous, Points x, const Vec3& up_)
      : vertices{at, next, previous}, p(x[next] - x[at]), q(x[previous] - x[at]), up(up_) {}
  double determinant() const { return p.cross(q).dot(up); }
  void add_gradient(double factor, std::span<Vec3> gradient) const {
    const Vec3 by_p = factor * q.cross(up);
    const Vec3 by_q = factor * up.cross(p);
    gradient[vertices[0]] -= by_p + by_q;
    gradient[vertices[1]] += by_p;
    gradient[vertices[2]] += by_q;
  }
};

/// (p x q).r at a corner of a volume cell.
struct SpaceCorner {
  std::array<Index, 4> vertices;
  Vec3 p, q, r;
  double sign;

  double determinant() const { return sign * p.cross(q).dot(r); }
  void add_gradient(double factor, std::span<Vec3> gradient) const {
    const Vec3 by_p = factor * sign * q.cross(r);
    const Vec3 by_q = factor * sign * r.cross(p);
    const Vec3 by_r = factor * sign * p.cross(q);
    gradient[vertices[0]] -= by_p + by_q + by_r;
    gradient[vertices[1]] += by_p;
    gradient[vertices[2]] += by_q;
    gradient[vertices[3]] += by_r;
  }
};

/// Calls body(k, corner) for the determinants k of a cell: corner.determinant() is its value,
/// corner.add_gradient(factor, gradient) adds its derivative with respect to the vertices.
/// @param up    surface cells: the direction they count about
/// @param sign  volume cells: -1 if wound the other way on purpose
template <typename Body>
void for_determinants(CellKind kind, std::span<const Index> cell, Points x, const Vec3& up,
                      double sign, const Body& body) {
  if (kind == CellKind::triangle) {
    body(0u, PlaneCorner(cell[0], cell[1], cell[2], x, up));
  } else if (kind == CellKind::quad) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      body(k, PlaneCorner(cell[k], cell[(k + 1) % 4], cell[(k + 3) % 4], x, up));
    }
  } else if (kind == CellKind::polygon) {
    body(0u, PolygonArea{cell, x, up});
  } else {
    const auto corners = traits(kind).corners;
    for (std::uint32_t k = 0; k < determinants_of(kind); ++k) {
      const auto& c = corners[k];
      const Index at = cell[c.vertex];
      const std::array<Index, 4> vertices = {at, cell[c.neighbours[0]], cell[c.neighbours[1]],
                                             cell[c.neighbours[2]]};
      body(k, SpaceCorner{vertices, x[vertices[1]] - x[at], x[vertices[2]] - x[at],
                          x[vertices[3]] - x[at], sign});
    }
  }
}

}  // namespace evenmesh
