// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh::bench {

/// The exact second derivatives of the cost `local` on planar triangles, and of their areas, with
/// respect to x and y of the vertices that move: the lower triangle of a sparse matrix, every entry
/// once.
///
///   f_e = sum_j l_j^2 - S^2 / 3,   S = l_1 + l_2 + l_3,   u_j = edge j / l_j
///   f_e'' = 2 sum_j B_j^T B_j - 2/3 (S'^T S' + S sum_j B_j^T (I - u_j u_j^T) B_j / l_j)
///
/// with edge j = B_j x. The signed area is quadratic; its second derivatives are constant. evenmesh
/// itself gets by without; optimisers it is compared with do not.
class LocalHessian {
 public:
  /// @param first_unknown  per vertex the number of its x (y is the next); -1 if it is fixed
  LocalHessian(const Mesh& mesh, std::span<const std::ptrdiff_t> first_unknown);

  std::size_t entries() const { return rows_.size(); }
  const std::vector<int>& rows() const { return rows_; }
  const std::vector<int>& columns() const { return columns_; }  // at most the row

  /// Number of an entry.
  /// @pre  it is one of those that rows() and columns() list
  std::size_t entry(std::ptrdiff_t row, std::ptrdiff_t column) const;

  /// @param y             the unknowns
  /// @param factor        times the cost
  /// @param area_factors  per cell, times its signed area; or empty
  /// @param[out] values   one per entry
  void evaluate(std::span<const double> y, double factor, std::span<const double> area_factors,
                std::span<double> values) const;

 private:
  // Six unknowns per triangle: x and y of each vertex.
  static constexpr std::size_t kSize = 6;
  static constexpr std::uint32_t kNowhere = ~std::uint32_t{0};

  Eigen::Vector2d position(Index vertex, std::span<const double> y) const;

  const Mesh& mesh_;
  std::span<const std::ptrdiff_t> first_unknown_;
  std::vector<int> rows_, columns_;
  std::vector<std::array<std::uint32_t, kSize * kSize>> slots_;  // per cell; where each goes
};

}  // namespace evenmesh::bench
