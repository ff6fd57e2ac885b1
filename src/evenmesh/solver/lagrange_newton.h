// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "evenmesh/solver/quadratic_program.h"
#include "evenmesh/solver/report.h"

namespace evenmesh {

/// What lagrange_newton() minimises:
///
///   min f(y)   subject to   c_i(y) = 0 (i < equations),   c_i(y) >= 0 (the inequalities after
///   them)
///
/// Values may be infinite or NaN away from the start: a trial step that leads there is shortened.
class NonlinearProgram {
 public:
  virtual ~NonlinearProgram() = default;

  virtual Eigen::Index unknowns() const = 0;
  virtual Eigen::Index equations() const { return 0; }
  virtual Eigen::Index inequalities() const { return 0; }

  /// f(y).
  /// @param[out] gradient  if not null: f'(y), resized as needed
  virtual double cost(const Eigen::VectorXd& y, Eigen::VectorXd* gradient) const = 0;
  /// c(y), equations first. Never called if there are no constraints.
  /// @param[out] c         resized as needed
  /// @param[out] jacobian  if not null: row i holds the derivatives of c_i
  virtual void constraints(const Eigen::VectorXd& y, Eigen::VectorXd& c,
                           SparseRowMatrix* jacobian) const;

  /// The unknowns after a step was accepted, y + step unless overridden. If unknowns are local
  /// coordinates (along curves, in tangent planes), here is where to put their origin at the new
  /// place: f and c there must equal those at y + step, their derivatives are with respect to the
  /// new coordinates. Curvature is carried over as it is.
  virtual Eigen::VectorXd advance(const Eigen::VectorXd& y, const Eigen::VectorXd& step);
  /// The greatest alpha for which y + alpha h may be tried, in (0, 1]: 1 unless overridden.
  virtual double largest_step(const Eigen::VectorXd& y, const Eigen::VectorXd& h) const;
};

/// One step of lagrange_newton().
struct LagrangeNewtonIteration {
  int number = 0;        // 0: the start, where only cost, penalty, violation and evaluations count
  double cost = 0.0;     // f(x)
  double penalty = 0.0;  // pi(x, mu), the exact L1 penalty function (4), mu as in this step
  double violation = 0.0;  // greatest |c_i| of equations and |min(0, c_i)| of inequalities
  StopMeasure eta = {};
  double alpha = 0.0;        // step length
  double largest = 0.0;      // |alpha h|_inf
  std::size_t active = 0;    // members of the active set, equations included
  bool elastic = false;      // linearised constraints contradicted each other: some stayed broken
  bool update_kept = false;  // W was updated, not skipped (true of no update after the last step)
  int evaluations = 0;       // of f so far, with or without its gradient
};

struct LagrangeNewtonOptions {
  double epsilon = 1e-6;     // stop when eta < epsilon, absolute; > 0
  int max_iterations = 200;  // >= 0
  double curvature = 1.0;    // of the cost, to begin with: W = curvature I; > 0
  /// Where linearised constraints contradict each other, breaking one costs this many times what
  /// the multiplier of a constraint on its own would be, about; >= 1. Grows if that was too little.
  double elastic_weight = 10.0;
  /// Called after every step; return false to stop there.
  std::function<bool(const LagrangeNewtonIteration&)> progress = {};
  /// Asked often during a step, which may take long; return true to stop where it began.
  std::function<bool()> stop = {};
};

struct LagrangeNewtonResult {
  Eigen::VectorXd y;
  Eigen::VectorXd multipliers;  // lambda, of the last quadratic program; L = f - lambda^T c
  std::vector<Eigen::Index> active;
  Stop stop = Stop::nothing_to_move;
  std::vector<LagrangeNewtonIteration> history;  // history[0] is the start
};

/// The Lagrange-Newton method (sequential quadratic programming) with dense curvature.
///
/// Each step solves the quadratic program (3) with W, an approximation of the second derivatives of
/// L(x, lambda) = f - lambda^T c that starts as the identity (or a multiple of it); goes along its
/// solution h as far as the exact L1 penalty function (4), weights (5), falls enough (soft line
/// search (7), (8)); and updates W by BFGS (11), unless curvature along the step is not positive:
/// then W is kept. Ends by (12).
///
/// Beyond the paper: if the linearised constraints contradict each other, the step minimises the
/// quadratic model plus the violations that remain, weighted (see QuadraticProgram), and (7) takes
/// these into account. Stop::no_descent: the penalty does not fall along h, as low as doubles
/// resolve it, or no step reduces violations any more.
///
/// W is held as a root of its inverse: a step takes O(n^2) time and O(n^2) for each change of the
/// active set. Deterministic. Memory: dense_memory_bytes().
/// @param start  y
/// @throws InvalidOption  an option is outside its range, or cost, constraints or their derivatives
///                        are not finite at the start
/// @see  Kulovec, Kos, Duhovnik 2011, section 1.2, Eqs. 1 to 12; Madsen, Nielsen, Tingleff,
///       Optimization with Constraints, 2004; Powell 1978
LagrangeNewtonResult lagrange_newton(NonlinearProgram& program, const Eigen::VectorXd& start,
                                     const LagrangeNewtonOptions& options = {});

/// Memory that lagrange_newton() takes at most, about, not counting the program itself.
double dense_memory_bytes(std::size_t unknowns, std::size_t constraints);

}  // namespace evenmesh
