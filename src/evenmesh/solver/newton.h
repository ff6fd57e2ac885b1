// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/motion.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/reduced_matrix.h"

namespace evenmesh {

/// Newton's equations for an objective, of the unknowns of its motion, by sparse Cholesky:
///
///   p = -Z (Z^T H Z + C)^-1 Z^T g
///
/// H is the Hessian of costs and constraints, found cell by cell as differences of gradients, so
/// that costs need not give second derivatives. C is what tracks add by bending: a vertex that
/// slides in direction t has the second derivative g . curvature(t) there.
///
/// Exact first: if the matrix is not positive definite, what makes it so are the matrices of single
/// cells (and of tracks) without their negative eigenvalues. A Hessian that is always treated like
/// that takes ten times as many steps.
///
/// Bounds on functions of more than kFewVertices vertices, which would fill the matrix, are added
/// after the factorisation (Sherman, Morrison, Woodbury), one solve each, without their own second
/// derivatives. Cells with more than kManyVertices vertices count with the diagonal of their
/// costs' springs.
class NewtonSystem {
 public:
  static constexpr std::size_t kFewVertices = 40;
  static constexpr std::size_t kManyVertices = 64;

  enum class Kind : std::uint8_t { exact, clamped };

  /// Finds out where entries will be, for vertices that may move now. The objective must outlive
  /// the object.
  /// @param x  where vertices are, about
  NewtonSystem(const Objective& objective, Points x);

  /// Multiplications (about) that a factorisation takes.
  double operations() const { return matrix_.factor_operations(); }
  /// False if the factor has more entries than can be numbered; nothing else may be called then.
  bool fits() const { return matrix_.factor_entries() < 2e9; }

  /// Sets the equations up at x and factorises them. Same bits for any number of threads.
  /// @return  false if that fails even with clamped matrices
  bool update(Workers& workers, Points x, const Motion::Places& places);
  /// Which matrix it became.
  Kind kind() const { return kind_; }
  /// @param g       reduced, as by Motion::reduce()
  /// @param[out] p  one vector per vertex
  /// @pre  update() returned true
  void solve(Points g, std::span<Vec3> p) const;

  // ---- the parts of update() --------------------------------------------------------------------

  void assemble(Workers& workers, Points x, const Motion::Places& places, Kind kind);
  bool factorise();
  const ReducedMatrix& matrix() const { return matrix_; }

 private:
  void visit_cliques(const std::function<void(std::span<const Index>)>& visit) const;
  bool is_small(std::size_t bound) const;
  void add(Kind kind, std::span<const Index> vertices, Eigen::MatrixXd& block);
  void add_cells(Workers& workers, Points x, Kind kind);
  void add_springs(const Layout::Block& block, Points x);
  void add_bounds(Points x, Kind kind);
  void add_leashes(Points x);
  void add_tracks(Workers& workers, Points x, const Motion::Places& places, Kind kind);

  const Objective& objective_;
  ReducedMatrix matrix_;
  double unit_;  // of length, for what has no size
  Kind kind_ = Kind::exact;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>>
      factor_;
  bool analysed_ = false;
  Eigen::MatrixXd large_;         // a column per bound on a large function: root of its curvature
  Eigen::MatrixXd solved_large_;  // times its slope; and the solutions for these
  Eigen::LDLT<Eigen::MatrixXd> coupling_;
};

}  // namespace evenmesh
