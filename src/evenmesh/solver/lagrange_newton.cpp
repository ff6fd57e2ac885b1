// SPDX-License-Identifier: MIT
#include "evenmesh/solver/lagrange_newton.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "evenmesh/base/error.h"

namespace evenmesh {

using Eigen::VectorXd;

void NonlinearProgram::constraints(const VectorXd&, VectorXd& c, SparseRowMatrix* jacobian) const {
  assert(equations() + inequalities() == 0);
  c.resize(0);
  if (jacobian) jacobian->resize(0, unknowns());
}

VectorXd NonlinearProgram::advance(const VectorXd& y, const VectorXd& step) { return y + step; }

double NonlinearProgram::largest_step(const VectorXd&, const VectorXd&) const { return 1.0; }

namespace {

using Eigen::Index;

constexpr double kSlope = 0.1;             // of the predicted fall that a step must reach
constexpr double kResolution = 1e-14;      // of the penalty, relative, in which rounding hides
constexpr double kCurvatureNoise = 1e-14;  // of y^T s, relative to |y| |s|: no sign to rely on
constexpr double kWeightGrowth = 10.0;
constexpr double kGreatestGrowth = 1e5;
constexpr double kShortRow = 1e-3;  // rows shorter than this, relative to the mean, count as that

/// A point and what is known there.
struct Iterate {
  VectorXd y;
  double cost = 0.0;
  VectorXd gradient;
  VectorXd c;
  SparseRowMatrix jacobian;
};

/// The method at work.
class LagrangeNewton {
 public:
  LagrangeNewton(NonlinearProgram& program, const VectorXd& start,
                 const LagrangeNewtonOptions& options);
  LagrangeNewtonResult run();

 private:
  bool is_equation(Index i) const { return i < program_.equations(); }
  double violation(Index i, double c) const {
    return is_equation(i) ? std::abs(c) : std::max(0.0, -c);
  }
  double greatest_violation(const VectorXd& c) const;
  double weighted_violation(const VectorXd& c) const;
  double penalty() const { return at_.cost + weighted_violation(at_.c); }

  void evaluate(const VectorXd& y);
  std::optional<Stop> iterate();
  void record(LagrangeNewtonIteration entry);
  bool solve_quadratic_program();
  VectorXd elastic_weights() const;
  bool grow_elastic_weight();
  void update_weights();
  double predicted_change(double slope) const;
  std::optional<double> search(double predicted, double resolution);
  StopMeasure measure(double alpha, double slope) const;
  bool update_curvature(double alpha, const Iterate& old);

  NonlinearProgram& program_;
  const LagrangeNewtonOptions& options_;
  Iterate at_;
  Eigen::MatrixXd root_;  // T, W^-1 = T^T T
  VectorXd mu_;           // weights of the penalty; empty before the first step
  QuadraticSolution model_;
  bool elastic_ = false;
  double growth_ = 1.0;  // of the weights of elastic constraints
  double last_eta_ = std::numeric_limits<double>::infinity();
  int evaluations_ = 0;
  LagrangeNewtonResult result_;
};

LagrangeNewton::LagrangeNewton(NonlinearProgram& program, const VectorXd& start,
                               const LagrangeNewtonOptions& options)
    : program_(program),
      options_(options),
      root_(Eigen::MatrixXd::Identity(program.unknowns(), program.unknowns()) /
            std::sqrt(options.curvature)) {
  evaluate(start);
  const Eigen::Map<const VectorXd> entries(at_.jacobian.valuePtr(), at_.jacobian.nonZeros());
  if (!std::isfinite(at_.cost) || !at_.gradient.allFinite() || !at_.c.allFinite() ||
      !entries.allFinite()) {
    throw InvalidOption(
        "the cost, a constraint or a derivative is not finite at the start: begin elsewhere");
  }
}

void LagrangeNewton::evaluate(const VectorXd& y) {
  at_.y = y;
  at_.cost = program_.cost(at_.y, &at_.gradient);
  ++evaluations_;
  if (program_.equations() + program_.inequalities() > 0) {
    program_.constraints(at_.y, at_.c, &at_.jacobian);
    at_.jacobian.makeCompressed();
  }
}

double LagrangeNewton::greatest_violation(const VectorXd& c) const {
  double greatest = 0.0;
  for (Index i = 0; i < c.size(); ++i) greatest = std::max(greatest, violation(i, c[i]));
  return greatest;
}

double LagrangeNewton::weighted_violation(const VectorXd& c) const {
  double sum = 0.0;
  for (Index i = 0; i < mu_.size(); ++i) sum += mu_[i] * violation(i, c[i]);
  return sum;
}

// ---- the quadratic program (3) -----------------------------------------------------------------

/// @return  false if told to stop; the model is then the last one
bool LagrangeNewton::solve_quadratic_program() {
  QuadraticProgram quadratic{root_, at_.gradient, at_.c, at_.jacobian, program_.equations()};
  const QuadraticSolution* guess = model_.step.size() > 0 ? &model_ : nullptr;
  if (!elastic_) {
    QuadraticSolution solution = solve(quadratic, guess, options_.stop);
    if (solution.stopped) return false;
    if (solution.feasible) {
      model_ = std::move(solution);
      return true;
    }
  }
  // If it turns out that nothing is broken, this is the solution of the program without weights.
  const VectorXd weights = elastic_weights();
  quadratic.weights = &weights;
  QuadraticSolution solution = solve(quadratic, guess, options_.stop);
  if (solution.stopped) return false;
  model_ = std::move(solution);
  elastic_ = !model_.feasible;
  return true;
}

/// Measured with W^-1, row i alone needs the multiplier (|f'| + distance to c_i = 0) / |J_i|.
VectorXd LagrangeNewton::elastic_weights() const {
  VectorXd length(at_.c.size());
  for (Index i = 0; i < length.size(); ++i) {
    length[i] = transform_row(root_, at_.jacobian, i).norm();
  }
  const double mean = length.mean();
  length = length.cwiseMax(mean > 0.0 ? kShortRow * mean : 1.0);

  std::vector<double> distances;
  for (Index i = 0; i < length.size(); ++i) {
    const double v = violation(i, at_.c[i]);
    if (v > 0.0) distances.push_back(v / length[i]);
  }
  double typical = 0.0;
  if (!distances.empty()) {
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    typical = *middle;
  }
  const double force = options_.elastic_weight * growth_ *
                       ((root_ * at_.gradient).norm() + std::max(typical, 1e-100));
  VectorXd weights = force * length.cwiseInverse();
  // Not below the penalty's, or else a step may raise that.
  if (mu_.size() > 0) weights = weights.cwiseMax(mu_);
  return weights;
}

/// @return  false if violations cost so much already that no greater weight will help
bool LagrangeNewton::grow_elastic_weight() {
  if (!elastic_ || growth_ >= kGreatestGrowth) return false;
  growth_ *= kWeightGrowth;
  return true;
}

// ---- the soft line search ----------------------------------------------------------------------

/// (5).
void LagrangeNewton::update_weights() {
  const VectorXd magnitude = model_.multipliers.cwiseAbs();
  mu_ = mu_.size() == 0 ? magnitude : magnitude.cwiseMax(0.5 * (mu_ + magnitude));
}

/// Delta (7), with the violations that the linearised constraints keep, if they contradict each
/// other.
double LagrangeNewton::predicted_change(double slope) const {
  double change = slope - weighted_violation(at_.c);
  if (elastic_) change += weighted_violation(at_.c + at_.jacobian * model_.step);
  return change;
}

/// The step length alpha for which the penalty function falls enough, by (7) and (8). Nothing if
/// it would be so short that the fall is less than rounding.
std::optional<double> LagrangeNewton::search(double predicted, double resolution) {
  const double start = penalty();
  double alpha = std::min(1.0, program_.largest_step(at_.y, model_.step));
  VectorXd c = at_.c;
  double slack = resolution;  // the first trial may lower violations alone, near the solution
  while (alpha > 0.0 && (slack > 0.0 || -alpha * predicted > resolution)) {
    const VectorXd y = at_.y + alpha * model_.step;
    double value = program_.cost(y, nullptr);
    ++evaluations_;
    if (c.size() > 0) program_.constraints(y, c, nullptr);
    value += weighted_violation(c);
    if (!std::isfinite(value) || !c.allFinite()) {
      alpha *= 0.1;
      slack = 0.0;
      continue;
    }
    if (value <= start + kSlope * alpha * predicted + slack) return alpha;
    slack = 0.0;
    const double beta = -predicted * alpha * alpha / (2.0 * (value - start - predicted * alpha));
    alpha = std::min(0.9 * alpha, std::max(beta, 0.1 * alpha));
  }
  return std::nullopt;
}

// ---- after the step ----------------------------------------------------------------------------

/// (12), of the constraints' values here.
/// @param slope  h^T f' where the step began
StopMeasure LagrangeNewton::measure(double alpha, double slope) const {
  StopMeasure eta;
  eta.model = std::abs(0.5 * alpha * alpha * model_.coordinates.squaredNorm() + alpha * slope);
  std::vector<char> is_active(static_cast<std::size_t>(at_.c.size()), 0);
  for (const Index i : model_.active) is_active[static_cast<std::size_t>(i)] = 1;
  for (Index i = 0; i < at_.c.size(); ++i) {
    const double lambda = model_.multipliers[i];
    if (is_equation(i) || is_active[static_cast<std::size_t>(i)] || lambda != 0.0) {
      eta.active += std::abs(lambda * at_.c[i]);
    } else {
      eta.inactive += violation(i, at_.c[i]);
    }
  }
  return eta;
}

/// BFGS (10), (11), for W^-1 = T^T T: with s = alpha h and w = T^-T s it becomes
///   T <- T - r s^T,   r = T y / (y^T s) - w / sqrt(y^T s |w|^2).
bool LagrangeNewton::update_curvature(double alpha, const Iterate& old) {
  VectorXd y = at_.gradient - old.gradient;
  if (at_.c.size() > 0) {
    y += (old.jacobian.transpose() - at_.jacobian.transpose()) * model_.multipliers;
  }
  const VectorXd s = alpha * model_.step;
  const double curvature = y.dot(s);
  if (!(curvature > kCurvatureNoise * y.norm() * s.norm())) return false;
  const VectorXd w = alpha * model_.coordinates;
  const VectorXd r = root_ * y / curvature - w / std::sqrt(curvature * w.squaredNorm());
  root_.noalias() -= r * s.transpose();
  return true;
}

/// One iteration: a step, or finding that there is none.
/// @return  why to stop, if that is so
std::optional<Stop> LagrangeNewton::iterate() {
  if (!solve_quadratic_program()) return Stop::interrupted;
  update_weights();
  const double slope = model_.step.dot(at_.gradient);
  const double predicted = predicted_change(slope);
  const double resolution = kResolution * (std::abs(at_.cost) + weighted_violation(at_.c));
  const std::optional<double> alpha = search(predicted, resolution);

  LagrangeNewtonIteration entry;
  entry.elastic = elastic_;
  entry.active = model_.active.size();
  if (alpha) {
    const VectorXd moved = *alpha * model_.step;
    const Iterate old = std::exchange(at_, {});
    evaluate(program_.advance(old.y, moved));
    entry.update_kept = update_curvature(*alpha, old);
    entry.alpha = *alpha;
    entry.largest = moved.lpNorm<Eigen::Infinity>();
  }
  entry.eta = measure(alpha.value_or(1.0), slope);
  record(entry);

  // The last step is one, too.
  const bool go_on = !options_.progress || options_.progress(result_.history.back());
  if (entry.eta.sum() < options_.epsilon) return Stop::converged;
  if (!go_on) return Stop::interrupted;
  const bool lost = -predicted <= resolution && entry.eta.sum() > 0.5 * last_eta_;
  const bool stuck = !alpha || lost || (elastic_ && entry.eta.model < options_.epsilon);
  last_eta_ = entry.eta.sum();
  if (stuck && !grow_elastic_weight()) return Stop::no_descent;
  return std::nullopt;
}

void LagrangeNewton::record(LagrangeNewtonIteration entry) {
  entry.number = static_cast<int>(result_.history.size());
  entry.cost = at_.cost;
  entry.penalty = penalty();
  entry.violation = greatest_violation(at_.c);
  entry.evaluations = evaluations_;
  result_.history.push_back(entry);
}

LagrangeNewtonResult LagrangeNewton::run() {
  record({});
  std::optional<Stop> stop;
  if (program_.unknowns() == 0) stop = Stop::nothing_to_move;
  for (int i = 0; i < options_.max_iterations && !stop; ++i) stop = iterate();
  result_.stop = stop.value_or(Stop::iteration_limit);
  result_.y = std::move(at_.y);
  result_.multipliers = std::move(model_.multipliers);
  result_.active = std::move(model_.active);
  return std::move(result_);
}

void check(const LagrangeNewtonOptions& options) {
  if (!(options.epsilon > 0.0 && std::isfinite(options.epsilon))) {
    throw InvalidOption("epsilon must be positive and finite");
  }
  if (options.max_iterations < 0) throw InvalidOption("max_iterations must not be negative");
  if (!(options.curvature > 0.0 && std::isfinite(options.curvature))) {
    throw InvalidOption("curvature must be positive and finite");
  }
  if (!(options.elastic_weight >= 1.0 && std::isfinite(options.elastic_weight))) {
    throw InvalidOption("elastic_weight must be at least 1 and finite");
  }
}

}  // namespace

LagrangeNewtonResult lagrange_newton(NonlinearProgram& program, const VectorXd& start,
                                     const LagrangeNewtonOptions& options) {
  assert(start.size() == program.unknowns());
  check(options);
  return LagrangeNewton(program, start, options).run();
}

/// T; Q and R of the active set, whose arrays are copied when they grow.
double dense_memory_bytes(std::size_t unknowns, std::size_t constraints) {
  const double n = static_cast<double>(unknowns);
  const double m = static_cast<double>(std::min(unknowns, constraints));
  return sizeof(double) *
         (n * n + 1.5 * m * (n + m) + 12.0 * n + 12.0 * static_cast<double>(constraints));
}

}  // namespace evenmesh
