// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace evenmesh {

using SparseRowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// A strictly convex quadratic program with dense curvature and sparse constraints:
///
///   min  1/2 h^T W h + g^T h   subject to   c_i + (J h)_i  = 0   (i < equations)
///                                           c_i + (J h)_i >= 0   (the others)
///
/// With finite weights mu a constraint may be broken at a price, so that there always is a
/// solution; added to the objective is
///
///   sum mu_i |c_i + (J h)_i|  (i < equations)  +  sum mu_i |min(0, c_i + (J h)_i)|  (the others)
///
/// The dual sees only that multipliers are bounded by mu. If weights exceed the multipliers of the
/// program without them, the solution is the same.
///
/// A view of the caller's arrays, n unknowns and m constraints.
struct QuadraticProgram {
  const Eigen::MatrixXd& root;        // T, n x n, with W^-1 = T^T T (see inverse_root())
  const Eigen::VectorXd& gradient;    // g, n
  const Eigen::VectorXd& constraint;  // c, m
  const SparseRowMatrix& jacobian;    // J, m x n, compressed
  Eigen::Index equations = 0;
  const Eigen::VectorXd* weights = nullptr;  // mu, m, > 0, infinity allowed; null: all infinite
};

struct QuadraticSolution {
  Eigen::VectorXd step;         // h
  Eigen::VectorXd coordinates;  // T^-T h: the squared norm of it is h^T W h
  /// lambda, m: gradient of the objective at h = J^T lambda. >= 0 for inequalities, within the
  /// weights, 0 for what is neither active nor broken.
  Eigen::VectorXd multipliers;
  std::vector<Eigen::Index> active;  // constraints held at 0, ascending, with independent rows
  /// Every constraint is met, up to rounding. If not and weights are infinite, the constraints
  /// contradict each other; step and multipliers are where this was found and of no use.
  bool feasible = false;
  bool stopped = false;  // somebody asked to: nothing else here is of use
  int changes = 0;       // constraints that were added to or dropped from the active set
};

/// Solves a quadratic program by the dual active-set method: from the unconstrained minimum, the
/// most violated constraint is brought to 0 by raising its multiplier; active ones whose
/// multipliers reach a bound on the way are dropped.
///
/// Dependent and redundant constraints, rows of zeros and vertices where more constraints meet than
/// there are unknowns do no harm. O(n^2) time per change of the active set; storage for as many
/// n-vectors as it has members. Deterministic.
/// @param guess  a solution of a similar program, with the same constraints, to start from: saves
///               time if many of the same are active
/// @param stop   asked before every change of the active set; returns true to end there
/// @see  Goldfarb and Idnani, A numerically stable dual method for solving strictly convex
///       quadratic programs, Mathematical Programming 27, 1983
QuadraticSolution solve(const QuadraticProgram& program, const QuadraticSolution* guess = nullptr,
                        const std::function<bool()>& stop = {});

/// T = L^-1, W = L L^T: lower triangular, with W^-1 = T^T T. O(n^3).
/// @pre  W is symmetric and positive definite
Eigen::MatrixXd inverse_root(const Eigen::MatrixXd& curvature);

/// T J_i^T, whose norm is that of row i of the Jacobian measured with W^-1.
Eigen::VectorXd transform_row(const Eigen::MatrixXd& root, const SparseRowMatrix& jacobian,
                              Eigen::Index row);

}  // namespace evenmesh
