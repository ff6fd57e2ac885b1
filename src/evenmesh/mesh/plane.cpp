// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/plane.h"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "evenmesh/mesh/extent.h"

namespace evenmesh {
namespace {

/// The vertices moved and scaled into [-1, 1]^3.
class Scaled {
 public:
  Scaled(Points points, std::span<const Index> vertices, const Extent& extent)
      : points_(points), vertices_(vertices), middle_(extent.middle()), half_(extent.half()) {}

  std::size_t size() const { return vertices_.size(); }
  Vec3 operator[](std::size_t i) const { return (points_[vertices_[i]] - middle_) / half_; }

  template <class Measure>
  std::size_t largest(Measure measure) const {
    std::size_t best = 0;
    double best_value = -1.0;
    for (std::size_t i = 0; i < size(); ++i) {
      const double value = measure((*this)[i]);
      if (value > best_value) {
        best_value = value;
        best = i;
      }
    }
    return best;
  }

 private:
  Points points_;
  std::span<const Index> vertices_;
  Vec3 middle_;
  double half_;
};

struct Plane {
  Vec3 point;
  Vec3 normal;

  double distance(const Vec3& x) const { return std::abs((x - point).dot(normal)); }
};

double largest_distance(const Scaled& x, const Plane& plane) {
  return plane.distance(x[x.largest([&](const Vec3& p) { return plane.distance(p); })]);
}

/// Through two vertices far apart and the one farthest from their line.
Plane plane_through_three(const Scaled& x) {
  const Vec3 start = x[0];
  const Vec3 a = x[x.largest([&](const Vec3& p) { return (p - start).squaredNorm(); })];
  const Vec3 b = x[x.largest([&](const Vec3& p) { return (p - a).squaredNorm(); })];
  const Vec3 line = (b - a).normalized();
  const auto off_line = [&](const Vec3& p) -> Vec3 { return (p - a) - (p - a).dot(line) * line; };
  const Vec3 across = off_line(x[x.largest([&](const Vec3& p) { return off_line(p).norm(); })]);
  const double width = across.norm();
  if (width > 1e-15) return {a, line.cross(across / width).normalized()};
  const Vec3 up = std::abs(line.z()) < 0.9 ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  return {a, (up - up.dot(line) * line).normalized()};
}

Plane least_squares_plane(const Scaled& x) {
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < x.size(); ++i) mean += x[i];
  mean /= static_cast<double>(x.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 d = x[i] - mean;
    covariance += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  return {mean, eigen.eigenvectors().col(0)};
}

/// The one of n and -n that points up or, if level, forth, then right.
Vec3 pointing_up(const Vec3& n) {
  constexpr double kLevel = 1e-9;
  for (const int axis : {2, 1, 0}) {
    if (std::abs(n[axis]) > kLevel) return n[axis] > 0.0 ? n : Vec3(-n);
  }
  return n;
}

}  // namespace

std::optional<Vec3> common_plane(Points points, std::span<const Index> vertices, double tolerance) {
  if (vertices.empty()) return std::nullopt;
  const Extent extent = extent_of(points, vertices);
  for (const int axis : {2, 1, 0}) {
    if (extent.low[axis] == extent.high[axis]) return Vec3(Vec3::Unit(axis));
  }
  const Scaled x(points, vertices, extent);
  const double half = extent.half();
  const double allowed = tolerance * 2.0 * ((extent.high / 2.0 - extent.low / 2.0) / half).norm();

  const Plane through_three = plane_through_three(x);
  const double first = largest_distance(x, through_three);
  // Its three points are extremes, so no plane comes much closer to all of them.
  if (!(first <= 10.0 * allowed)) return std::nullopt;
  const Plane fitted = least_squares_plane(x);
  const double second = largest_distance(x, fitted);
  if (!(std::min(first, second) <= allowed)) return std::nullopt;
  return pointing_up(second < first ? fitted.normal : through_three.normal);
}

}  // namespace evenmesh
