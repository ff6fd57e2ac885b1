// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh::shapes {

/// A small random generator (splitmix64) whose numbers are the same on every platform, which the
/// distributions of the standard library do not promise.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// Uniform in [-1, 1).
  double signed_unit() { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1.0; }
  /// Uniform in the unit disc of the xy plane.
  Vec3 in_disc() {
    double x = 0.0;
    double y = 0.0;
    do {
      x = signed_unit();
      y = signed_unit();
    } while (x * x + y * y > 1.0);
    return {x, y, 0.0};
  }
  /// Uniform in [0, n), up to a bias of n / 2^64.
  std::size_t below(std::size_t n) { return bits() % n; }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace evenmesh::shapes
