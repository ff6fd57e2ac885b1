// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/solver/sparse.h"

namespace evenmesh {

/// A symmetric positive (semi-)definite matrix with the diagonal kept apart. A row whose diagonal
/// is 0 has no unknown (a fixed vertex); its entries must be absent.
struct SymmetricMatrix {
  double scale = 1.0;  // > 0: what diagonal and entries, of ordinary size, are in units of
  std::vector<float> diagonal;
  SparseMatrix off_diagonal;

  std::size_t rows() const { return diagonal.size(); }
};

/// An approximate inverse of a Laplacian-like matrix: one V(1,1) cycle of smoothed-aggregation
/// multigrid (Vanek, Mandel, Brezina 1996), applied to the three coordinates at once.
///
/// Neighbouring unknowns are gathered into aggregates; a step of damped Jacobi smooths their
/// indicator functions into the interpolation P; the next level is P^T A P, down to a few hundred
/// unknowns, which are solved by dense Cholesky. The smoother is Gauss-Seidel, forwards before and
/// backwards after, chunk by chunk with coupled chunks in different colours: symmetric, parallel,
/// and the same bits for any number of threads. Everything is in single precision.
class Multigrid {
 public:
  Multigrid(Workers& workers, SymmetricMatrix matrix);

  /// z = M r, with M symmetric and positive definite on the rows that have an unknown.
  /// @param r     one vector per row, any scale
  /// @param[out] z  one vector per row; 0 where the row has no unknown
  void apply(Workers& workers, std::span<const Vec3> r, std::span<Vec3> z);

  int levels() const { return static_cast<int>(levels_.size()); }
  /// Entries of all levels' matrices over those of the first.
  double operator_complexity() const;

 private:
  using Row = Eigen::Vector4f;  // three coordinates and a spare lane, one SIMD register

  struct Level {
    SymmetricMatrix matrix;
    std::vector<float> inverse_diagonal;
    SparseMatrix interpolation;  // rows: this level, columns: the next
    SparseMatrix restriction;    // its transpose
    std::vector<std::vector<std::uint32_t>> colours;
    std::vector<Row> right, solution, residual;
  };

  void prepare(Workers& workers, Level& level);
  void cycle(Workers& workers, std::size_t depth);
  void smooth_forwards(Workers& workers, Level& level);
  void smooth_backwards(Workers& workers, Level& level);

  double scale_;  // of the matrix
  std::vector<Level> levels_;
  Eigen::LDLT<Eigen::MatrixXf> coarsest_;
};

}  // namespace evenmesh
