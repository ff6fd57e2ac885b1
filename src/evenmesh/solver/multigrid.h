// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/solver/blocks.h"
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
///
/// Where unknowns may move along a line or in a plane only, with projectors P_i, it is the matrix
/// P (S (x) I) P that is inverted, S being the matrix given and P the diagonal of the P_i. It is
/// interpolated by P p, p being what S is interpolated by; so coarse unknowns have three
/// coordinates everywhere, and p^T P (S (x) I) P p couples them near rows with a projector. There
/// coarse rows consist of 3x3 matrices, elsewhere of scalars. Their diagonal blocks may be
/// singular, as where all that an aggregate gathers moves along one line: what has next to no
/// stiffness stays where it is.
class Multigrid {
 public:
  /// @param projectors  of the rows whose unknown cannot move in all directions; each row once
  Multigrid(Workers& workers, SymmetricMatrix matrix, std::span<const Projector> projectors = {});

  /// z = M r, with M symmetric and positive definite on the rows that have an unknown, in the
  /// directions in which it may move. M = M P = P M.
  /// @param r     one vector per row, any scale
  /// @param[out] z  one vector per row; 0 where the row has no unknown
  void apply(Workers& workers, std::span<const Vec3> r, std::span<Vec3> z);

  int levels() const { return static_cast<int>(levels_.size()); }
  /// Entries of all levels' matrices over those of the first.
  double operator_complexity() const;

 private:
  struct Level {
    SymmetricMatrix matrix;
    Projections projections;  // on the finest level only
    CoupledRows coupled;      // on the other levels only
    std::vector<float> inverse_diagonal;
    std::vector<Block> inverse_block;  // per coupled row
    SparseMatrix interpolation;        // rows: this level, columns: the next
    SparseMatrix restriction;          // its transpose
    std::vector<std::vector<std::uint32_t>> colours;
    std::vector<Row> right, solution, residual;

    void relax(std::size_t i);  // solves row i for its own unknown
    void relax_constrained(std::size_t i);
    void find_residual(std::size_t i);  // of row i
    void find_residual_constrained(std::size_t i);
    void project(std::size_t i, Row& vector) const;  // onto where row i can move
    Row without_coupled(std::size_t i, std::uint32_t number, Row sum) const;
    bool is_constrained() const { return !projections.chosen.empty() || !coupled.chosen.empty(); }
  };

  void coarsen(Workers& workers, std::size_t coarsest);
  void prepare(Workers& workers, Level& level);
  void factorise(const Level& level);
  void factorise_coupled(const Level& level);
  void solve_coarsest(Level& level) const;
  void cycle(Workers& workers, std::size_t depth);
  void smooth_forwards(Workers& workers, Level& level);
  void smooth_backwards(Workers& workers, Level& level);

  double scale_;  // of the matrix
  std::vector<Level> levels_;
  Eigen::LDLT<Eigen::MatrixXf> coarsest_;
};

}  // namespace evenmesh
