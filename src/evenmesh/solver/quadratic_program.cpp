// SPDX-License-Identifier: MIT
#include "evenmesh/solver/quadratic_program.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Jacobi>

namespace evenmesh {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A row counts as dependent if so little of it, relative to its length, is new; rounding leaves
// about 1e-15 of a row that is.
constexpr double kIndependent = 1e-10;
// Rounding of c + J h, relative to the terms of that sum.
constexpr double kRounding = 1e-11;

/// The rows of active constraints in the coordinates w = T^-T h, in which the objective is
/// 1/2 |w|^2 + (T g)^T w: columns b_i = T J_i^T of a matrix B = Q R.
///
/// Q is orthonormal, by Gram-Schmidt applied twice, R upper triangular.
class ActiveSet {
 public:
  explicit ActiveSet(Index unknowns) : q_(unknowns, 0) {}

  Index size() const { return static_cast<Index>(members_.size()); }
  const std::vector<Index>& members() const { return members_; }
  auto q() const { return q_.leftCols(size()); }

  /// What is left of a row without its part in the span of the members', and that part: b = Q a +
  /// rest.
  struct Split {
    VectorXd along;  // a
    VectorXd rest;
    double squared_rest = 0.0;  // 0 if b depends on the members
  };
  Split split(const VectorXd& b) const {
    Split s{q().transpose() * b, b, 0.0};
    s.rest.noalias() -= q() * s.along;
    const VectorXd again = q().transpose() * s.rest;
    s.rest.noalias() -= q() * again;
    s.along += again;
    s.squared_rest = s.rest.squaredNorm();
    if (s.squared_rest <= kIndependent * kIndependent * b.squaredNorm()) s.squared_rest = 0.0;
    return s;
  }
  /// @pre  s.squared_rest > 0
  void add(Index constraint, const Split& s) {
    const Index k = size();
    if (k == q_.cols()) {
      const Index capacity = std::min(q_.rows(), std::max<Index>(16, 2 * k));
      q_.conservativeResize(Eigen::NoChange, capacity);
      r_.conservativeResize(capacity, capacity);
    }
    const double rest = std::sqrt(s.squared_rest);
    q_.col(k) = s.rest / rest;
    r_.col(k).head(k) = s.along;
    r_(k, k) = rest;
    members_.push_back(constraint);
  }
  void drop(Index place) {
    const Index last = size() - 1;
    for (Index k = place; k < last; ++k) {
      r_.col(k).head(k + 2) = r_.col(k + 1).head(k + 2);
      Eigen::JacobiRotation<double> rotation;
      rotation.makeGivens(r_(k, k), r_(k + 1, k), &r_(k, k));
      r_.block(k, k + 2, 2, last - k - 1).applyOnTheLeft(0, 1, rotation.adjoint());
      q_.middleCols(k, 2).applyOnTheRight(0, 1, rotation);
    }
    members_.erase(members_.begin() + place);
  }

  /// R^-1 a.
  VectorXd solve(const VectorXd& a) const {
    return r_.topLeftCorner(size(), size()).triangularView<Eigen::Upper>().solve(a);
  }
  /// R^-T a.
  VectorXd solve_transposed(const VectorXd& a) const {
    return r_.topLeftCorner(size(), size()).triangularView<Eigen::Upper>().transpose().solve(a);
  }

 private:
  Eigen::MatrixXd q_;  // as many columns as there is room for
  Eigen::MatrixXd r_;
  std::vector<Index> members_;
};

/// The dual active-set method at work.
///
/// Between pursuits, multipliers of members of the active set are what minimises the objective with
/// these constraints as equations; all others are held at a bound of theirs. (Equations that have
/// not been active yet are held at 0.)
class DualMethod {
 public:
  DualMethod(const QuadraticProgram& program, const std::function<bool()>& stop);

  void start_from(const QuadraticSolution* guess);
  void run();
  QuadraticSolution solution();

 private:
  Index count() const { return program_.constraint.size(); }
  double upper(Index i) const { return program_.weights ? (*program_.weights)[i] : kInfinity; }
  double lower(Index i) const { return i < program_.equations ? -upper(i) : 0.0; }
  double tolerance(Index i) const {
    return kRounding * (std::abs(program_.constraint[i]) + row_norm_[i] * reach_);
  }
  VectorXd transformed_row(Index i) const {
    return transform_row(program_.root, program_.jacobian, i);
  }
  void hold(Index i, double multiplier);
  void activate(Index i, const VectorXd& b, const ActiveSet::Split& split);
  void drop(Index place, double multiplier);
  void minimise_on_active_set();
  void drop_what_is_out_of_bounds();
  void evaluate();
  Index most_violated() const;
  bool pursue(Index p);
  bool is_told_to_stop() {
    stopped_ = stopped_ || (stop_ && stop_());
    return stopped_;
  }

  const QuadraticProgram& program_;
  const std::function<bool()>& stop_;
  ActiveSet active_;
  std::vector<char> is_active_;
  VectorXd slope_;  // T (g - J^T lambda) over the constraints that are not active
  VectorXd w_;
  VectorXd step_;       // h
  VectorXd value_;      // c + J h
  VectorXd lambda_;     // m
  VectorXd row_norm_;   // m
  double reach_ = 0.0;  // length of steps met so far, for rounding
  int changes_ = 0;
  bool consistent_ = true;
  bool stopped_ = false;
};

DualMethod::DualMethod(const QuadraticProgram& program, const std::function<bool()>& stop)
    : program_(program),
      stop_(stop),
      active_(program.gradient.size()),
      is_active_(static_cast<std::size_t>(count()), 0),
      slope_(program.root * program.gradient),
      lambda_(VectorXd::Zero(count())),
      row_norm_(count()),
      reach_((program.root.transpose() * slope_).norm()) {
  for (Index i = 0; i < count(); ++i) row_norm_[i] = program.jacobian.row(i).norm();
}

/// Sets the multiplier of a constraint that is not active.
void DualMethod::hold(Index i, double multiplier) {
  if (multiplier == lambda_[i]) return;
  slope_ -= (multiplier - lambda_[i]) * transformed_row(i);
  lambda_[i] = multiplier;
}

void DualMethod::activate(Index i, const VectorXd& b, const ActiveSet::Split& split) {
  if (lambda_[i] != 0.0) slope_ += lambda_[i] * b;
  active_.add(i, split);
  is_active_[static_cast<std::size_t>(i)] = 1;
  ++changes_;
}

void DualMethod::drop(Index place, double multiplier) {
  const Index i = active_.members()[static_cast<std::size_t>(place)];
  active_.drop(place);
  is_active_[static_cast<std::size_t>(i)] = 0;
  lambda_[i] = 0.0;  // the slope is without it
  hold(i, multiplier);
  ++changes_;
}

/// Minimises 1/2 |w|^2 + slope^T w subject to c_i + b_i^T w = 0 for the active i: there
/// w = -slope + B lambda, and with a = R lambda, R^T (a - Q^T slope) = -c.
void DualMethod::minimise_on_active_set() {
  VectorXd c(active_.size());
  for (Index k = 0; k < c.size(); ++k) {
    c[k] = program_.constraint[active_.members()[static_cast<std::size_t>(k)]];
  }
  const VectorXd a = active_.q().transpose() * slope_ - active_.solve_transposed(c);
  const VectorXd lambda = active_.solve(a);
  for (Index k = 0; k < c.size(); ++k) {
    lambda_[active_.members()[static_cast<std::size_t>(k)]] = lambda[k];
  }
  w_ = -slope_;
  w_.noalias() += active_.q() * a;
}

/// Begins with the equations, and with what a guess has active or held at its weight.
void DualMethod::start_from(const QuadraticSolution* guess) {
  std::vector<Index> first;
  for (Index i = 0; i < program_.equations; ++i) first.push_back(i);
  if (guess) {
    assert(guess->multipliers.size() == count());
    std::vector<char> is_active(static_cast<std::size_t>(count()), 0);
    for (const Index i : guess->active) {
      is_active[static_cast<std::size_t>(i)] = 1;
      if (i >= program_.equations) first.push_back(i);
    }
    for (Index i = program_.equations; i < count(); ++i) {
      const bool held = guess->multipliers[i] > 0.0 && !is_active[static_cast<std::size_t>(i)];
      if (held && upper(i) < kInfinity) hold(i, upper(i));
    }
  }
  for (const Index i : first) {
    if (is_told_to_stop()) return;
    const VectorXd b = transformed_row(i);
    const ActiveSet::Split split = active_.split(b);
    if (split.squared_rest > 0.0) activate(i, b, split);
  }
  drop_what_is_out_of_bounds();
}

/// What remains is a solution of the program without the constraints that are not active: all that
/// the method asks of a start.
void DualMethod::drop_what_is_out_of_bounds() {
  for (;;) {
    minimise_on_active_set();
    if (is_told_to_stop()) return;
    Index worst = -1;
    double excess = 0.0;
    for (Index k = 0; k < active_.size(); ++k) {
      const Index i = active_.members()[static_cast<std::size_t>(k)];
      const double beyond = std::max(lambda_[i] - upper(i), lower(i) - lambda_[i]) * row_norm_[i];
      if (beyond > excess) {
        excess = beyond;
        worst = k;
      }
    }
    if (worst < 0) return;
    const Index i = active_.members()[static_cast<std::size_t>(worst)];
    drop(worst, lambda_[i] > upper(i) ? upper(i) : lower(i));
  }
}

void DualMethod::evaluate() {
  step_.noalias() = program_.root.transpose() * w_;
  reach_ = std::max(reach_, step_.norm());
  value_ = program_.constraint;
  if (count() > 0) value_ += program_.jacobian * step_;
}

/// The constraint farthest from being met, among those whose multiplier has room; -1 if none is.
Index DualMethod::most_violated() const {
  Index worst = -1;
  double farthest = 0.0;
  for (Index i = 0; i < count(); ++i) {
    if (is_active_[static_cast<std::size_t>(i)] || std::abs(value_[i]) <= tolerance(i)) continue;
    const bool has_room = value_[i] < 0.0 ? lambda_[i] < upper(i) : lambda_[i] > lower(i);
    if (!has_room) continue;
    const double distance = std::abs(value_[i]) / std::max(row_norm_[i], 1e-300);
    if (distance > farthest) {
      farthest = distance;
      worst = i;
    }
  }
  return worst;
}

/// Moves the multiplier of p, and those of active constraints with it so that these stay at 0,
/// until p is at 0 as well or its multiplier at its bound. Constraints whose multipliers reach a
/// bound on the way are dropped. The dual objective rises, hence no active set comes twice.
/// @return  false if that has no end: p contradicts the active constraints; or if told to stop
bool DualMethod::pursue(Index p) {
  const VectorXd b = transformed_row(p);
  const double sign = value_[p] < 0.0 ? 1.0 : -1.0;
  const double start = lambda_[p];
  const double bound = sign > 0.0 ? upper(p) : lower(p);
  double value = std::abs(value_[p]);
  double moved = 0.0;
  const auto hold_at = [&](double multiplier) {  // of p; for the slope it was at start so far
    lambda_[p] = start;
    hold(p, multiplier);
  };
  while (!is_told_to_stop()) {
    const ActiveSet::Split split = active_.split(b);
    const VectorXd r = -sign * active_.solve(split.along);
    const double to_zero = split.squared_rest > 0.0 ? value / split.squared_rest : kInfinity;
    const double to_bound = std::abs(bound - start) - moved;
    double length = std::min(to_zero, to_bound);
    Index blocking = -1;
    double blocking_bound = 0.0;
    for (Index k = 0; k < active_.size(); ++k) {
      if (r[k] == 0.0) continue;
      const Index i = active_.members()[static_cast<std::size_t>(k)];
      const double limit = r[k] > 0.0 ? upper(i) : lower(i);
      const double to_limit = std::max(0.0, (limit - lambda_[i]) / r[k]);
      if (to_limit < length) {
        length = to_limit;
        blocking = k;
        blocking_bound = limit;
      }
    }
    if (length == kInfinity) return false;
    for (Index k = 0; k < active_.size(); ++k) {
      lambda_[active_.members()[static_cast<std::size_t>(k)]] += length * r[k];
    }
    moved += length;
    value -= length * split.squared_rest;
    if (blocking >= 0) {
      drop(blocking, blocking_bound);
    } else if (to_zero <= to_bound) {
      lambda_[p] = start;
      activate(p, b, split);
      return true;
    } else {
      hold_at(bound);
      return true;
    }
  }
  return false;
}

void DualMethod::run() {
  // Each pursuit raises the dual objective: the limit is only for what rounding may do.
  const Index limit = 100 + 20 * (count() + program_.gradient.size());
  for (Index pursuits = 0; pursuits < limit; ++pursuits) {
    if (is_told_to_stop()) break;
    evaluate();
    const Index p = most_violated();
    if (p < 0) return;
    if (!pursue(p)) break;
    minimise_on_active_set();
  }
  consistent_ = false;
  if (stopped_) return;
  minimise_on_active_set();
  evaluate();
}

QuadraticSolution DualMethod::solution() {
  QuadraticSolution s;
  s.stopped = stopped_;
  if (stopped_) return s;
  s.feasible = consistent_;
  for (Index i = 0; i < count(); ++i) {
    if (is_active_[static_cast<std::size_t>(i)]) {
      s.active.push_back(i);
      lambda_[i] = std::clamp(lambda_[i], lower(i), upper(i));
      continue;
    }
    const double broken = i < program_.equations ? std::abs(value_[i]) : -value_[i];
    if (broken > tolerance(i)) s.feasible = false;
  }
  s.step = std::move(step_);
  s.coordinates = std::move(w_);
  s.multipliers = std::move(lambda_);
  s.changes = changes_;
  return s;
}

}  // namespace

QuadraticSolution solve(const QuadraticProgram& program, const QuadraticSolution* guess,
                        const std::function<bool()>& stop) {
  assert(program.root.rows() == program.gradient.size());
  assert(program.root.cols() == program.gradient.size());
  assert(program.equations <= program.constraint.size());
  assert(program.constraint.size() == 0 || (program.jacobian.rows() == program.constraint.size() &&
                                            program.jacobian.cols() == program.gradient.size()));
  assert(!program.weights || program.weights->size() == program.constraint.size());
  DualMethod method(program, stop);
  method.start_from(guess);
  method.run();
  return method.solution();
}

VectorXd transform_row(const Eigen::MatrixXd& root, const SparseRowMatrix& jacobian,
                       Eigen::Index row) {
  VectorXd b = VectorXd::Zero(root.rows());
  for (SparseRowMatrix::InnerIterator entry(jacobian, row); entry; ++entry) {
    b += entry.value() * root.col(entry.col());
  }
  return b;
}

Eigen::MatrixXd inverse_root(const Eigen::MatrixXd& curvature) {
  const Eigen::LLT<Eigen::MatrixXd> cholesky(curvature);
  assert(cholesky.info() == Eigen::Success);
  Eigen::MatrixXd root = Eigen::MatrixXd::Identity(curvature.rows(), curvature.cols());
  cholesky.matrixL().solveInPlace(root);
  return root;
}

}  // namespace evenmesh
