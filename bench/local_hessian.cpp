// SPDX-License-Identifier: MIT
#include "bench/local_hessian.h"

#include <algorithm>

namespace evenmesh::bench {
namespace {

using Matrix2 = Eigen::Matrix2d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// Entry (row, column) as one number that sorts by row first.
std::uint64_t key(std::ptrdiff_t row, std::ptrdiff_t column) {
  return static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint64_t>(column);
}

Matrix6 second_derivatives(const std::array<Eigen::Vector2d, 3>& corner) {
  std::array<Eigen::Vector2d, 3> unit;
  std::array<double, 3> length;
  double sum = 0.0;
  Vector6 slope = Vector6::Zero();  // of the sum of lengths
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Eigen::Index k = (j + 1) % 3;
    const auto i = static_cast<std::size_t>(j);
    const Eigen::Vector2d edge = corner[static_cast<std::size_t>(k)] - corner[i];
    length[i] = edge.norm();
    unit[i] = edge / length[i];
    sum += length[i];
    slope.segment<2>(2 * k) += unit[i];
    slope.segment<2>(2 * j) -= unit[i];
  }
  Matrix6 result = -2.0 / 3.0 * slope * slope.transpose();
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Eigen::Index k = (j + 1) % 3;
    const auto i = static_cast<std::size_t>(j);
    const Matrix2 across = Matrix2::Identity() - unit[i] * unit[i].transpose();
    const Matrix2 stiffness = 2.0 * Matrix2::Identity() - (2.0 / 3.0 * sum / length[i]) * across;
    result.block<2, 2>(2 * j, 2 * j) += stiffness;
    result.block<2, 2>(2 * k, 2 * k) += stiffness;
    result.block<2, 2>(2 * j, 2 * k) -= stiffness;
    result.block<2, 2>(2 * k, 2 * j) -= stiffness;
  }
  return result;
}

// Of the signed area: 2 a = sum_j (x_j y_k - x_k y_j), k the corner after j.
Matrix6 area_derivatives() {
  Matrix6 result = Matrix6::Zero();
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Eigen::Index k = (j + 1) % 3;
    result(2 * j, 2 * k + 1) = result(2 * k + 1, 2 * j) = 0.5;
    result(2 * k, 2 * j + 1) = result(2 * j + 1, 2 * k) = -0.5;
  }
  return result;
}

}  // namespace

LocalHessian::LocalHessian(const Mesh& mesh, std::span<const std::ptrdiff_t> first_unknown)
    : mesh_(mesh), first_unknown_(first_unknown) {
  const auto for_entries = [&](std::size_t cell, const auto& body) {
    const auto vertices = mesh.cells().vertices(cell);
    for (std::size_t a = 0; a < kSize; ++a) {
      for (std::size_t b = 0; b < kSize; ++b) {
        const std::ptrdiff_t first_a = first_unknown[vertices[a / 2]];
        const std::ptrdiff_t first_b = first_unknown[vertices[b / 2]];
        if (first_a < 0 || first_b < 0) continue;
        const auto row = first_a + static_cast<std::ptrdiff_t>(a % 2);
        const auto column = first_b + static_cast<std::ptrdiff_t>(b % 2);
        if (column <= row) body(kSize * a + b, key(row, column));
      }
    }
  };
  std::vector<std::uint64_t> keys;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    for_entries(c, [&](std::size_t, std::uint64_t k) { keys.push_back(k); });
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  for (const std::uint64_t k : keys) {
    rows_.push_back(static_cast<int>(k >> 32));
    columns_.push_back(static_cast<int>(k & 0xffffffffU));
  }
  slots_.resize(mesh.cells().size());
  for (std::size_t c = 0; c < slots_.size(); ++c) {
    slots_[c].fill(kNowhere);
    for_entries(c, [&](std::size_t place, std::uint64_t k) {
      const auto found = std::lower_bound(keys.begin(), keys.end(), k);
      slots_[c][place] = static_cast<std::uint32_t>(found - keys.begin());
    });
  }
}

Eigen::Vector2d LocalHessian::position(Index vertex, std::span<const double> y) const {
  const std::ptrdiff_t first = first_unknown_[vertex];
  if (first < 0) return mesh_.points()[vertex].head<2>();
  const auto i = static_cast<std::size_t>(first);
  return {y[i], y[i + 1]};
}

std::size_t LocalHessian::entry(std::ptrdiff_t row, std::ptrdiff_t column) const {
  const auto [first, last] = std::equal_range(rows_.begin(), rows_.end(), static_cast<int>(row));
  const auto from = columns_.begin() + (first - rows_.begin());
  const auto to = columns_.begin() + (last - rows_.begin());
  const auto found = std::lower_bound(from, to, static_cast<int>(column));
  return static_cast<std::size_t>(found - columns_.begin());
}

void LocalHessian::evaluate(std::span<const double> y, double factor,
                            std::span<const double> area_factors, std::span<double> values) const {
  const Matrix6 of_area = area_derivatives();
  std::fill(values.begin(), values.end(), 0.0);
  for (std::size_t c = 0; c < slots_.size(); ++c) {
    const auto v = mesh_.cells().vertices(c);
    Matrix6 part =
        factor * second_derivatives({position(v[0], y), position(v[1], y), position(v[2], y)});
    if (!area_factors.empty()) part += area_factors[c] * of_area;
    for (std::size_t i = 0; i < slots_[c].size(); ++i) {
      if (slots_[c][i] == kNowhere) continue;
      values[slots_[c][i]] +=
          part(static_cast<Eigen::Index>(i / kSize), static_cast<Eigen::Index>(i % kSize));
    }
  }
}

}  // namespace evenmesh::bench
