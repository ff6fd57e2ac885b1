// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// A power of two that brings lengths into the range in which their fourth powers are doubles and
/// they themselves are single-precision numbers.
///
/// Multiplying by it loses no bit and is undone exactly. 1 for every ordinary unit of length.
struct UnitScale {
  double to_unit = 1.0;
  double from_unit = 1.0;
};

/// How far from a plane, relative to the size of the whole, points may lie to count as in it.
/// Single-precision files need the slack.
inline constexpr double kFlatTolerance = 1e-7;

/// @param points  finite; the greatest coordinate counts
inline UnitScale unit_scale(Points points) {
  constexpr double kLeast = 1e-30;
  constexpr double kGreatest = 1e30;
  constexpr int kGreatestExponent = 1000;  // 2^1000 and 2^-1000 are doubles both
  double largest = 0.0;
  for (const Vec3& p : points) largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
  if (!(largest > 0.0) || (largest > kLeast && largest < kGreatest)) return {};
  int exponent = 0;
  std::frexp(largest, &exponent);
  exponent = std::clamp(exponent, -kGreatestExponent, kGreatestExponent);
  return {std::ldexp(1.0, -exponent), std::ldexp(1.0, exponent)};
}

}  // namespace evenmesh
