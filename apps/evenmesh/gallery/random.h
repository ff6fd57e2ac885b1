// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "evenmesh/base/vec3.h"

namespace evenmesh::gallery {

/// A small random generator (splitmix64) whose numbers are the same on every platform, which the
/// distributions of the standard library do not promise.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// Uniform in [-1, 1).
  double signed_unit() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1.0;
  }
  /// Uniform in the square [-1, 1)^2 of the xy plane.
  Vec3 in_square() {
    const double x = signed_unit();
    return {x, signed_unit(), 0.0};
  }
  /// A unit vector of the xy plane.
  Vec3 direction() {
    const double angle_rad = std::numbers::pi * signed_unit();
    return {std::cos(angle_rad), std::sin(angle_rad), 0.0};
  }

 private:
  std::uint64_t state_;
};

}  // namespace evenmesh::gallery
