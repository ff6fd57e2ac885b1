// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// a . b over all components; same bits for any number of threads.
inline double dot(Workers& workers, Points a, Points b) {
  return sum_over_ranges(workers, a.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i) sum += a[i].dot(b[i]);
    return sum;
  });
}

/// result = a + factor * b
inline void add(Workers& workers, Points a, double factor, Points b, std::span<Vec3> result) {
  for_ranges(workers, a.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) result[i] = a[i] + factor * b[i];
  });
}

/// Greatest length of a vector.
inline double largest(Workers& workers, Points a) {
  std::vector<double> greatest((a.size() + kRangeSize - 1) / kRangeSize, 0.0);
  for_ranges(workers, a.size(), [&](std::size_t first, std::size_t last) {
    double& most = greatest[first / kRangeSize];
    for (std::size_t i = first; i < last; ++i) most = std::max(most, a[i].squaredNorm());
  });
  return greatest.empty() ? 0.0 : std::sqrt(*std::max_element(greatest.begin(), greatest.end()));
}

}  // namespace evenmesh
