// SPDX-License-Identifier: MIT
#include "evenmesh/quality/surface_cell.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "evenmesh/geometry/area.h"
#include "evenmesh/geometry/unit_size.h"

namespace evenmesh {
namespace {

// Within these bounds of the sum of squared sides no product of the measures leaves the range of
// double, so that the points may be used as they are.
constexpr double kSmallSum = 1e-80;
constexpr double kLargeSum = 1e80;

SurfaceCell::Regular regular_corner(std::size_t corners) {
  if (corners == 3) return {0.5 * std::numbers::sqrt3, 0.5, std::numbers::sqrt3};
  if (corners == 4) return {1.0, 0.0, 1.0};
  const double turn = 2.0 * std::numbers::pi / static_cast<double>(corners);
  return {std::sin(turn), -std::cos(turn), std::tan(0.5 * turn)};
}

/// A vector of about length 1, or zero.
Vec3 direction(const Vec3& v) {
  const double largest = v.lpNorm<Eigen::Infinity>();
  if (!(largest > 0.0 && largest <= std::numeric_limits<double>::max())) return Vec3::Zero();
  return v / largest;
}

double sign_of(double x) { return static_cast<double>(x > 0.0) - static_cast<double>(x < 0.0); }

}  // namespace

void SurfaceCell::set(std::span<const Vec3> points, const Vec3& up) {
  assert(points.size() >= 3);
  if (points.size() != count_) regular_ = regular_corner(points.size());
  if (!try_set(points, up)) try_set(unit_sized(points), up);  // at worst all zero: collapsed
}

bool SurfaceCell::try_set(std::span<const Vec3> points, const Vec3& up) {
  const Vec3 area = area_vector(points);
  const Vec3 positive = direction(up);
  area_ = area.norm();
  const bool has_normal = area_ > 0.0;
  const Vec3 normal = has_normal ? Vec3(area / area_) : positive.stableNormalized();
  sign_ = has_normal && !positive.isZero(0.0) ? sign_of(area.dot(positive)) : 1.0;

  const auto corners = make_room(points.size());
  const bool is_triangle = corners.size() == 3;
  longest_ = 0.0;
  shortest_ = std::numeric_limits<double>::infinity();
  perimeter_ = 0.0;
  double sum = 0.0;
  Vec3 before = points.front() - points.back();
  double previous = before.norm();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 after = (i + 1 == points.size() ? points[0] : points[i + 1]) - points[i];
    const double squared = after.squaredNorm();
    Corner& corner = corners[i];
    corner.dot = -before.dot(after);
    corner.previous = previous;
    corner.next = std::sqrt(squared);
    if (is_triangle) {
      corner.signed_area = corner.area = 2.0 * area_;  // the same at every corner
    } else {
      const Vec3 cross = before.cross(after);
      corner.signed_area = cross.dot(normal);
      corner.area = cross.norm();
    }
    sum += squared;
    longest_ = std::max(longest_, corner.next);
    shortest_ = std::min(shortest_, corner.next);
    perimeter_ += corner.next;
    before = after;
    previous = corner.next;
  }
  return sum > kSmallSum && sum < kLargeSum;  // false for NaN
}

std::span<SurfaceCell::Corner> SurfaceCell::make_room(std::size_t count) {
  count_ = count;
  many_.resize(count > kFew ? count : 0);
  return {many_.empty() ? few_.data() : many_.data(), count};
}

}  // namespace evenmesh
