// SPDX-License-Identifier: MIT
#include "evenmesh/cost/shape.h"

#include <array>
#include <cmath>
#include <numbers>

#include "evenmesh/cost/edges.h"
#include "evenmesh/mesh/determinants.h"

namespace evenmesh {
namespace {

// Corners with a smaller t are treated more and more like inverted ones.
constexpr double kDelta = 0.05;

struct Inverse {
  double value;  // 1 / chi(t) - 1 / chi(1)
  double slope;
};

// 1 / chi(t), without cancellation on either side.
double inverse_of_chi(double t, double root) {
  return t > 0.0 ? 2.0 / (t + root) : 2.0 * (root - t) / (kDelta * kDelta);
}

Inverse inverse(double t) {
  static const double kIdeal = inverse_of_chi(1.0, std::sqrt(1.0 + kDelta * kDelta));
  const double root = std::sqrt(t * t + kDelta * kDelta);
  const double value = inverse_of_chi(t, root);
  return {value - kIdeal, -value / root};
}

// Squares of edges shorter than this would leave the range of doubles.
constexpr double kLeastNorm = 1e-280;

/// t at a corner of a surface cell with the interior angle of the regular one.
struct SurfaceCorner {
  PlaneCorner corner;
  double sine, cosine;

  double norm() const {
    return corner.p.squaredNorm() + corner.q.squaredNorm() - 2.0 * cosine * corner.p.dot(corner.q);
  }

  double add(double weight, std::span<Vec3> gradient) const {
    const double n = norm();
    if (!(n > kLeastNorm)) return weight * inverse(0.0).value;
    const double t = 2.0 * sine * corner.determinant() / n;
    const auto [value, slope] = inverse(t);
    if (gradient.empty()) return weight * value;
    const double factor = weight * slope / n;
    corner.add_gradient(2.0 * sine * factor, gradient);
    const double by_norm = -2.0 * t * factor;
    const Vec3 by_p = by_norm * (corner.p - cosine * corner.q);
    const Vec3 by_q = by_norm * (corner.q - cosine * corner.p);
    gradient[corner.vertices[0]] -= by_p + by_q;
    gradient[corner.vertices[1]] += by_p;
    gradient[corner.vertices[2]] += by_q;
    return weight * value;
  }
};

/// |T|^2 at a corner of a volume cell and half its derivatives with respect to the edges there; the
/// factor between det T and the determinant of the edges.
struct Norm {
  double value;
  double factor;
  Vec3 by_p, by_q, by_r;
};

Norm norm_of(CellKind kind, const SpaceCorner& c) {
  const auto& [p, q, r] = std::tie(c.p, c.q, c.r);
  switch (kind) {
    case CellKind::tet: {
      const Vec3 a = 1.5 * p - 0.5 * (q + r);
      const Vec3 b = 1.5 * q - 0.5 * (r + p);
      const Vec3 d = 1.5 * r - 0.5 * (p + q);
      return {a.dot(p) + b.dot(q) + d.dot(r), std::numbers::sqrt2, a, b, d};
    }
    case CellKind::wedge: {  // p and q span the triangle
      const Vec3 a = 4.0 / 3.0 * (p - 0.5 * q);
      const Vec3 b = 4.0 / 3.0 * (q - 0.5 * p);
      return {a.dot(p) + b.dot(q) + r.squaredNorm(), 2.0 / std::numbers::sqrt3, a, b, r};
    }
    case CellKind::pyramid: {  // r leads to the apex
      const Vec3 rise = r - 0.5 * (p + q);
      return {p.squaredNorm() + q.squaredNorm() + 2.0 * rise.squaredNorm(), std::numbers::sqrt2,
              p - rise, q - rise, 2.0 * rise};
    }
    default:
      return {p.squaredNorm() + q.squaredNorm() + r.squaredNorm(), 1.0, p, q, r};
  }
}

double add_volume_corner(CellKind kind, const SpaceCorner& corner, double weight,
                         std::span<Vec3> gradient) {
  const Norm norm = norm_of(kind, corner);
  if (!(norm.value > kLeastNorm)) return weight * inverse(0.0).value;
  constexpr double kRoot27 = 3.0 * std::numbers::sqrt3;
  const double scale = kRoot27 * norm.factor / (norm.value * std::sqrt(norm.value));
  const double t = scale * corner.determinant();
  const auto [value, slope] = inverse(t);
  if (gradient.empty()) return weight * value;
  corner.add_gradient(weight * slope * scale, gradient);
  const double by_norm = -3.0 * weight * slope * t / norm.value;
  gradient[corner.vertices[0]] -= by_norm * (norm.by_p + norm.by_q + norm.by_r);
  gradient[corner.vertices[1]] += by_norm * norm.by_p;
  gradient[corner.vertices[2]] += by_norm * norm.by_q;
  gradient[corner.vertices[3]] += by_norm * norm.by_r;
  return weight * value;
}

/// The corners of surface cells; about their own normal where there is no up.
double evaluate_surface(const CellBlock& cells, Points x, double weight, std::span<Vec3> gradient) {
  const auto n = static_cast<std::size_t>(cells.vertices_per_cell);
  const double angle = (1.0 - 2.0 / static_cast<double>(n)) * std::numbers::pi;
  const double sine = std::sin(angle);
  const double cosine = n == 4 ? 0.0 : std::cos(angle);
  const std::size_t corners = n == 3 ? 1 : n;
  const double each = weight / static_cast<double>(corners);
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto cell = cells.cell(i);
    const Vec3 up = cells.up(i);
    for (std::size_t k = 0; k < corners; ++k) {
      PlaneCorner corner(cell[k], cell[(k + 1) % n], cell[(k + n - 1) % n], x, up);
      if (up.isZero(0.0)) corner.up = corner.p.cross(corner.q).stableNormalized();
      sum += SurfaceCorner{corner, sine, cosine}.add(each, gradient);
    }
  }
  return sum;
}

double evaluate_volume(const CellBlock& cells, Points x, double weight, std::span<Vec3> gradient) {
  const double each = weight / static_cast<double>(determinants_of(cells.kind));
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for_determinants(cells.kind, cells.cell(i), x, Vec3::Zero(), cells.sign(i),
                     [&](std::uint32_t, const auto& corner) {
                       if constexpr (std::is_same_v<decltype(corner), const SpaceCorner&>) {
                         sum += add_volume_corner(cells.kind, corner, each, gradient);
                       }
                     });
  }
  return sum;
}

}  // namespace

double Shape::evaluate(const CellBlock& cells, Points x, double weight,
                       std::span<Vec3> gradient) const {
  const bool is_volume = traits(cells.kind).dimension == 3;
  if (!is_volume && cells.in_volume()) return 0.0;
  return is_volume ? evaluate_volume(cells, x, weight, gradient)
                   : evaluate_surface(cells, x, weight, gradient);
}

// 1 / t is |T|^d over the determinant. With the determinant held, it curves like springs along the
// edges; flat cells are taken for less flat ones, which they will be.
void Shape::add_springs(const CellBlock& cells, Points x, std::vector<Spring>& springs) const {
  if (traits(cells.kind).dimension == 2 && cells.in_volume()) return;
  const std::vector<LocalEdge> edges = local_edges(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto cell = cells.cell(i);
    double square = 0.0;
    for (const auto [a, b] : edges) square += (x[cell[b]] - x[cell[a]]).squaredNorm();
    square /= static_cast<double>(edges.size());
    if (!(square > 0.0)) continue;
    for (const auto [a, b] : edges) springs.push_back({cell[a], cell[b], 2.0 / square});
  }
}

}  // namespace evenmesh
