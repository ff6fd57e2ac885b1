// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace evenmesh {

/// How far values are from being equal: sum_j (l_j - m)^2 with m their mean.
/// @param[out] slopes  derivative with respect to each value, 2 (l_j - m)
inline double spread(std::span<const double> values, std::span<double> slopes) {
  double mean = 0.0;
  for (const double l : values) mean += l;
  mean /= static_cast<double>(values.size());
  double sum = 0.0;
  for (std::size_t j = 0; j < values.size(); ++j) {
    const double excess = values[j] - mean;
    sum += excess * excess;
    slopes[j] = 2.0 * excess;
  }
  return sum;
}

/// The same relative to the mean: S / m^2 with S = spread(values). 0 if all values are 0.
/// @param[out] slopes  2 (l_j - m) / m^2 - 2 S / (p m^3), p the number of values
inline double relative_spread(std::span<const double> values, std::span<double> slopes) {
  const double absolute = spread(values, slopes);
  double mean = 0.0;
  for (const double l : values) mean += l;
  mean /= static_cast<double>(values.size());
  if (!(mean > 0.0)) return 0.0;
  const double relative = absolute / (mean * mean);
  const double common = 2.0 * relative / (static_cast<double>(values.size()) * mean);
  for (double& slope : slopes) slope = slope / (mean * mean) - common;
  return relative;
}

}  // namespace evenmesh
