// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/unit_size.h"

#include <algorithm>
#include <cmath>

namespace evenmesh {
namespace {

constexpr double kHalf = 0.5;  // a difference of two halves cannot overflow

/// x 2^exponent, also where 2^exponent is no double.
Vec3 scaled(const Vec3& x, int exponent) {
  return {std::ldexp(x[0], exponent), std::ldexp(x[1], exponent), std::ldexp(x[2], exponent)};
}

/// Halves large coordinates and leaves the others alone, lest the smallest lose their last bit.
double safe_factor(std::span<const Vec3> points) {
  double largest = 0.0;
  for (const Vec3& p : points) largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
  return largest > 1.0 ? kHalf : 1.0;
}

}  // namespace

std::vector<Vec3> unit_sized(std::span<const Vec3> points) {
  std::vector<Vec3> result(points.size(), Vec3::Zero());
  if (!std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.allFinite(); })) {
    return result;
  }
  const double factor = safe_factor(points);
  double largest = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    result[i] = factor * points[i] - factor * points[0];
    largest = std::max(largest, result[i].lpNorm<Eigen::Infinity>());
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (Vec3& p : result) p = scaled(p, -exponent);
  return result;
}

}  // namespace evenmesh
