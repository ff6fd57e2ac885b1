// SPDX-License-Identifier: MIT
#include "evenmesh/cost/shape.h"

#include <array>
#include <cmath>
#include <numbers>

#include "evenmesh/cost/edges.h"
#include "evenmesh/mesh/determinants.h"
#include "evenmesh/mesh/ideal_norm.h"

namespace evenmesh {
namespace {

double power(double base, int exponent) {
  double result = 1.0;
  for (; exponent > 0; exponent /= 2, base *= base) {
    if (exponent % 2 == 1) result *= base;
  }
  return result;
}

// What corners cost, as a function of t.
class Price {
 public:
  struct Value {
    double value;  // (1 / chi(t)^p - 1 / chi(1)^p) / p, or log(chi(1) / chi(t)) for p = 0
    double slope;
  };

  Price(int exponent, double softness)
      : exponent_(exponent), square_(softness * softness), ideal_(inverse_of_chi(1.0)) {}

  Value operator()(double t) const {
    const double root = std::sqrt(t * t + square_);
    const double value = inverse_of_chi(t, root);
    if (exponent_ == 0) return {std::log(value / ideal_), -1.0 / root};
    if (exponent_ == 1) return {value - ideal_, -value / root};
    const double raised = power(value, exponent_);
    return {(raised - power(ideal_, exponent_)) / exponent_, -raised / root};
  }

 private:
  // 1 / chi(t), without cancellation on either side.
  double inverse_of_chi(double t, double root) const {
    return t > 0.0 ? 2.0 / (t + root) : 2.0 * (root - t) / square_;
  }
  double inverse_of_chi(double t) const { return inverse_of_chi(t, std::sqrt(t * t + square_)); }

  int exponent_;
  double square_;  // of the softness
  double ideal_;   // 1 / chi(1)
};

// Squares of edges shorter than this would leave the range of doubles.
constexpr double kLeastNorm = 1e-280;

/// t at a corner of a surface cell with the interior angle of the regular one.
struct SurfaceCorner {
  PlaneCorner corner;
  double sine, cosine;
  const Price& price;

  double norm() const {
    return corner.p.squaredNorm() + corner.q.squaredNorm() - 2.0 * cosine * corner.p.dot(corner.q);
  }

  double add(double weight, std::span<Vec3> gradient) const {
    const double n = norm();
    if (!(n > kLeastNorm)) return weight * price(0.0).value;
    const double t = 2.0 * sine * corner.determinant() / n;
    const auto [value, slope] = price(t);
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

template <CellKind kind>
double add_volume_corner(const SpaceCorner& corner, const Price& price, double weight,
                         std::span<Vec3> gradient) {
  const IdealNorm norm = ideal_norm<kind>(corner);
  if (!(norm.value > kLeastNorm)) return weight * price(0.0).value;
  constexpr double kRoot27 = 3.0 * std::numbers::sqrt3;
  const double scale = kRoot27 * norm.factor / (norm.value * std::sqrt(norm.value));
  const double t = scale * corner.determinant();
  const auto [value, slope] = price(t);
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
double evaluate_surface(const CellBlock& cells, Points x, const Price& price, double weight,
                        std::span<Vec3> gradient) {
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
      sum += SurfaceCorner{corner, sine, cosine, price}.add(each, gradient);
    }
  }
  return sum;
}

template <CellKind kind>
double evaluate_volume(const CellBlock& cells, Points x, const Price& price, double weight,
                       std::span<Vec3> gradient) {
  const double each = weight / static_cast<double>(determinants_of(kind));
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for_determinants(kind, cells.cell(i), x, Vec3::Zero(), cells.sign(i),
                     [&](std::uint32_t, const auto& corner) {
                       if constexpr (std::is_same_v<decltype(corner), const SpaceCorner&>) {
                         sum += add_volume_corner<kind>(corner, price, each, gradient);
                       }
                     });
  }
  return sum;
}

}  // namespace

double Shape::evaluate(const CellBlock& cells, Points x, double weight,
                       std::span<Vec3> gradient) const {
  const Price price(exponent_, softness_);
  if (traits(cells.kind).dimension == 3) {
    return with_volume_kind(cells.kind, [&](auto kind) {
      return evaluate_volume<kind()>(cells, x, price, weight, gradient);
    });
  }
  return cells.in_volume() ? 0.0 : evaluate_surface(cells, x, price, weight, gradient);
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
