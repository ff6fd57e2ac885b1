// SPDX-License-Identifier: MIT
#include "evenmesh/solver/flips.h"

#include <algorithm>
#include <numbers>

#include "evenmesh/mesh/determinants.h"
#include "evenmesh/mesh/ideal_norm.h"
#include "evenmesh/mesh/measure.h"
#include "evenmesh/quality/metric.h"

namespace evenmesh {
namespace {

// At most the `shape` of a triangle: equal to it where its normal is along `up`.
double shape_bound_of_triangle(Points x, std::span<const Index> t, const Vec3& up) {
  const Vec3 a = x[t[1]] - x[t[0]];
  const Vec3 b = x[t[2]] - x[t[0]];
  const double squares = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
  return 2.0 * std::numbers::sqrt3 * a.cross(b).dot(up) / squares;
}

// The same for a quad: the least over its corners.
double shape_bound_of_quad(Points x, std::span<const Index> q, const Vec3& up) {
  double least = 1.0;
  Vec3 before = x[q[0]] - x[q[3]];
  for (int i = 0; i < 4; ++i) {
    const Vec3 after = x[q[(i + 1) % 4]] - x[q[i]];
    const double squares = before.squaredNorm() + after.squaredNorm();
    least = std::min(least, 2.0 * before.cross(after).dot(up) / squares);
    before = after;
  }
  return least;
}

// Whether shape = 3 (det T)^(2/3) / |T|^2 is greater at all corners of a volume cell, without
// roots.
template <CellKind kind>
bool volume_exceeds(Points x, std::span<const Index> cell, double sign, double shape) {
  bool all = true;
  for_determinants(kind, cell, x, Vec3::Zero(), sign, [&](std::uint32_t, const auto& corner) {
    if constexpr (std::is_same_v<decltype(corner), const SpaceCorner&>) {
      const IdealNorm norm = ideal_norm<kind>(corner);
      const double determinant = norm.factor * corner.determinant();
      const double bound = shape * norm.value / 3.0;
      all = all && determinant > 0.0 && determinant * determinant > bound * bound * bound;
    }
  });
  return all;
}

}  // namespace

struct Flips::Cell {
  CellKind kind;
  std::span<const Index> vertices;
  Vec3 up;
  double sign;

  double least_corner_at(Points x) const {
    return least_corner(
        kind, static_cast<int>(vertices.size()),
        [&](int k) -> const Vec3& { return x[vertices[k]]; }, up, sign);
  }

  double shape_at(Points x) const {
    std::vector<Vec3> corners;
    for (const Index v : vertices) corners.push_back(x[v]);
    return measure(Metric::shape, kind, corners, up, sign);
  }

  // Quick; true only if shape_at() is greater than that and the cell not inverted. Always false for
  // polygons.
  bool clearly_exceeds(double shape, Points x) const {
    if (kind == CellKind::triangle) return shape_bound_of_triangle(x, vertices, up) > shape;
    if (kind == CellKind::quad) return shape_bound_of_quad(x, vertices, up) > shape;
    if (kind == CellKind::polygon) return false;
    return with_volume_kind(kind,
                            [&](auto k) { return volume_exceeds<k()>(x, vertices, sign, shape); });
  }
};

bool Flips::offends(const Cell& cell, Points x, Points x_new) const {
  if (cell.clearly_exceeds(least_shape_, x_new)) return false;
  const double after = cell.least_corner_at(x_new);
  if (after > 0.0) return least_shape_ > 0.0 && cell.shape_at(x_new) < least_shape_;
  const double before = cell.least_corner_at(x);
  return before > 0.0 || after < std::min(before, cell.least_corner_at(input_));
}

std::vector<Index> Flips::find(Workers& workers, Points x, Points x_new) const {
  std::vector<std::vector<Index>> found(layout_.chunks());
  layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
    const bool surface = traits(block.cells.kind).dimension == 2;
    for (std::size_t i = 0; i < block.cells.size(); ++i) {
      const std::uint32_t number = block.cells.numbers[i];
      const Cell cell{block.cells.kind, block.cells.cell(i), orientation_.up(number),
                      orientation_.sign(number)};
      if (surface && cell.up.isZero()) continue;
      if (!offends(cell, x, x_new)) continue;
      found[chunk].insert(found[chunk].end(), cell.vertices.begin(), cell.vertices.end());
    }
  });
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < reach_.size(); ++v) {
    const double squared = (x_new[v] - input_[v]).squaredNorm();
    if (squared > reach_[v] * reach_[v] && squared > (x[v] - input_[v]).squaredNorm()) {
      vertices.push_back(static_cast<Index>(v));
    }
  }
  for (const auto& part : found) vertices.insert(vertices.end(), part.begin(), part.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace evenmesh
