// SPDX-License-Identifier: MIT
#include "evenmesh/solver/dense.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <Eigen/SparseCore>
#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/timer.h"
#include "evenmesh/solver/lagrange_newton.h"
#include "evenmesh/solver/vectors.h"

namespace evenmesh {
namespace {

constexpr double kOfFirstFlip = 0.95;  // part of the way to it that a step may go
constexpr double kShortestStep = 1e-6;
constexpr double kLeastFall = 1e-12;  // part of the cost below which a change is rounding

int directions(Motion::Freedom freedom) { return static_cast<int>(freedom); }
static_assert(static_cast<int>(Motion::Freedom::fixed) == 0 &&
              static_cast<int>(Motion::Freedom::free) == 3);

// The unknowns of the vertices that may move: steps along axes, each vertex with its own.
class LocalSteps {
 public:
  LocalSteps(const Motion& motion, const Motion::Places& places) : motion_(motion) {
    first_.assign(motion.size(), 0);
    for (Index v = 0; v < motion.size(); ++v) {
      first_[v] = static_cast<std::uint32_t>(axes_.size());
      if (motion.leader(v) != v) continue;
      const int count = directions(motion.freedom(v));
      for (int k = 0; k < count; ++k) {
        vertices_.push_back(v);
        axes_.push_back(Vec3::Unit(k));
      }
    }
    turn(places);
  }

  std::size_t size() const { return axes_.size(); }
  Index vertex(std::size_t unknown) const { return vertices_[unknown]; }
  const Vec3& axis(std::size_t unknown) const { return axes_[unknown]; }
  /// The unknowns of a vertex or of what it is tied to: [first, first + count).
  std::size_t first(Index v) const { return first_[motion_.leader(v)]; }
  std::size_t count(Index v) const {
    return static_cast<std::size_t>(directions(motion_.freedom(motion_.leader(v))));
  }

  /// Turns axes into where vertices may move now, as little as can be.
  void turn(const Motion::Places& places) {
    for (std::size_t i = 0; i < size(); i += count(vertices_[i])) {
      const Index v = vertices_[i];
      if (motion_.freedom(v) == Motion::Freedom::free) continue;
      std::array<Vec3, 5> candidates;  // what the axes were, then any
      const std::size_t n = count(v);
      std::copy_n(axes_.begin() + static_cast<std::ptrdiff_t>(i), n, candidates.begin());
      for (std::size_t k = 0; k < 3; ++k) {
        candidates[n + k] = Vec3::Unit(static_cast<Eigen::Index>(k));
      }
      std::size_t found = 0;
      for (std::size_t c = 0; c < n + 3 && found < n; ++c) {
        Vec3 axis = motion_.project(places, v, candidates[c]);
        if (found == 1) axis -= axes_[i].dot(axis) * axes_[i];
        const double length = axis.norm();
        if (length < 0.5) continue;
        axes_[i + found++] = axis / length;
      }
    }
  }

 private:
  const Motion& motion_;
  std::vector<std::uint32_t> first_;  // per vertex
  std::vector<Index> vertices_;       // per unknown
  std::vector<Vec3> axes_;            // per unknown
};

// A mesh's costs and demands as functions of the unknowns. These are steps from a base that follows
// the iterates, so that y is 0 at every one of them.
class MeshProgram final : public NonlinearProgram {
 public:
  MeshProgram(Workers& workers, const Objective& objective, const Flips* flips,
              std::vector<Vec3>& x)
      : workers_(workers),
        objective_(objective),
        lagrangian_(*objective.lagrangian()),
        flips_(flips),
        base_(x),
        places_(objective.motion().start()),
        trial_(x),
        trial_places_(places_),
        steps_(objective.motion(), places_),
        unit_(unit_of_unknowns()) {
    lagrangian_.for_each_row(base_, [&](const Lagrangian::Row& row) {
      is_equation_.push_back(row.is_equation);
      equations_ += row.is_equation ? 1 : 0;
    });
    limit_steps();
  }

  /// Lets demands be part of the cost, as the lagrangian has it, instead of constraints.
  void penalise(bool on) { is_penalised_ = on; }

  Eigen::Index unknowns() const override { return static_cast<Eigen::Index>(steps_.size()); }
  Eigen::Index equations() const override { return is_penalised_ ? 0 : equations_; }
  Eigen::Index inequalities() const override {
    return is_penalised_ ? 0 : static_cast<Eigen::Index>(is_equation_.size()) - equations_;
  }

  double cost(const Eigen::VectorXd& y, Eigen::VectorXd* gradient) const override {
    move_to(y);
    std::vector<Vec3> g(gradient == nullptr ? 0 : trial_.size());
    const double value = is_penalised_ ? objective_.evaluate(workers_, trial_, g)
                                       : objective_.cost(workers_, trial_, g);
    if (gradient == nullptr) return value;
    objective_.motion().reduce(workers_, trial_places_, g);
    gradient->resize(unknowns());
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      (*gradient)[static_cast<Eigen::Index>(i)] = unit_ * steps_.axis(i).dot(g[steps_.vertex(i)]);
    }
    return value;
  }

  void constraints(const Eigen::VectorXd& y, Eigen::VectorXd& c,
                   SparseRowMatrix* jacobian) const override {
    move_to(y);
    c.resize(static_cast<Eigen::Index>(is_equation_.size()));
    std::vector<Eigen::Triplet<double>> entries;
    for_rows([&](Eigen::Index i, const Lagrangian::Row& row) {
      c[i] = row.value;
      if (jacobian != nullptr) add_entries(i, row, entries);
    });
    if (jacobian == nullptr) return;
    jacobian->resize(c.size(), unknowns());
    jacobian->setFromTriplets(entries.begin(), entries.end());
  }

  Eigen::VectorXd advance(const Eigen::VectorXd& y, const Eigen::VectorXd& step) override {
    move_to(y + step);
    max_move_ = 0.0;
    for (std::size_t v = 0; v < base_.size(); ++v) {
      max_move_ = std::max(max_move_, (trial_[v] - base_[v]).norm());
    }
    base_ = trial_;
    places_ = trial_places_;
    steps_.turn(places_);
    limit_steps();
    return Eigen::VectorXd::Zero(unknowns());
  }

  double largest_step(const Eigen::VectorXd& y, const Eigen::VectorXd& h) const override {
    if (!is_limited_) return 1.0;
    if (is_valid_at(y + h)) return 1.0;
    double valid = 0.0;
    double invalid = 1.0;
    while (invalid - valid > 0.01 * invalid && invalid > kShortestStep) {
      const double middle = 0.5 * (valid + invalid);
      (is_valid_at(y + middle * h) ? valid : invalid) = middle;
    }
    return std::max(kOfFirstFlip * valid, kShortestStep);
  }

  double max_move() const { return max_move_; }
  std::size_t inverted() const { return inverted_; }
  std::size_t rows() const { return is_equation_.size(); }

  /// From equations first to the order of the rows.
  std::vector<double> in_order_of_rows(const Eigen::VectorXd& multipliers) const {
    std::vector<double> result(is_equation_.size());
    Eigen::Index equation = 0;
    Eigen::Index inequality = equations_;
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = multipliers[is_equation_[i] ? equation++ : inequality++];
    }
    return result;
  }

 private:
  double unit_of_unknowns() const {
    constexpr double kUsual = 2.0;
    constexpr double kRange = 100.0;
    const double ratio = objective_.typical_stiffness(base_) / kUsual;
    return ratio < kRange && ratio > 1.0 / kRange ? 1.0 : 1.0 / std::sqrt(ratio);
  }

  void move_to(const Eigen::VectorXd& y) const {
    trial_ = base_;
    trial_places_ = places_;
    if (y.isZero(0.0)) return;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      trial_[steps_.vertex(i)] += unit_ * y[static_cast<Eigen::Index>(i)] * steps_.axis(i);
    }
    objective_.motion().retract(workers_, base_, places_, trial_, trial_places_);
  }

  bool is_valid_at(const Eigen::VectorXd& y) const {
    move_to(y);
    return flips_->find(workers_, base_, trial_).empty();
  }

  // While cells are inverted they have to pass through one another.
  void limit_steps() {
    inverted_ = lagrangian_.violation(workers_, base_).inverted;
    is_limited_ = flips_ != nullptr && inverted_ == 0;
  }

  template <typename Body>
  void for_rows(const Body& body) const {
    Eigen::Index equation = 0;
    Eigen::Index inequality = equations_;
    lagrangian_.for_each_row(trial_, [&](const Lagrangian::Row& row) {
      body(row.is_equation ? equation++ : inequality++, row);
    });
  }

  void add_entries(Eigen::Index i, const Lagrangian::Row& row,
                   std::vector<Eigen::Triplet<double>>& entries) const {
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      const Index v = row.vertices[k];
      for (std::size_t j = steps_.first(v); j < steps_.first(v) + steps_.count(v); ++j) {
        entries.emplace_back(i, static_cast<Eigen::Index>(j),
                             unit_ * steps_.axis(j).dot(row.slope[k]));
      }
    }
  }

  Workers& workers_;
  const Objective& objective_;
  const Lagrangian& lagrangian_;
  const Flips* flips_;
  std::vector<Vec3>& base_;
  Motion::Places places_;
  mutable std::vector<Vec3> trial_;  // where move_to() went last
  mutable Motion::Places trial_places_;
  LocalSteps steps_;
  double unit_;
  std::vector<char> is_equation_;  // per row
  Eigen::Index equations_ = 0;
  std::size_t inverted_ = 0;
  bool is_limited_ = false;
  bool is_penalised_ = false;
  double max_move_ = 0.0;
};

void check_memory(const MeshProgram& program) {
  const auto unknowns = static_cast<std::size_t>(program.unknowns());
  const double bytes = dense_memory_bytes(unknowns, program.rows());
  if (bytes <= kMostDenseBytes) return;
  throw InvalidOption(fmt::format(
      "the solver dense would take {:.1f} GB for {} unknowns and {} constraints, more than {:.1f} "
      "GB; use multigrid or newton, which go by the size of the mesh, or fix more vertices",
      bytes / 1e9, unknowns, program.rows(), kMostDenseBytes / 1e9));
}

// The method from outside: its phases, the report, and who wants to stop.
class DenseDescent {
 public:
  DenseDescent(Workers& workers, Objective& objective, const Flips* flips, const Options& options,
               std::vector<Vec3>& x, Report& report, const std::function<bool(Points)>& observe)
      : workers_(workers),
        objective_(objective),
        lagrangian_(*objective.lagrangian()),
        options_(options),
        x_(x),
        report_(report),
        observe_(observe),
        program_(workers, objective, flips, x) {}

  void run() {
    check_memory(program_);
    report_.solver = SolverKind::dense;
    report_.stop = Stop::no_descent;
    const double cost = objective_.cost(workers_, x_);
    if (!std::isfinite(cost)) return;
    method_.epsilon = options_.eta > 0.0
                          ? options_.eta
                          : std::max(options_.tolerance * options_.tolerance, kLeastFall) *
                                std::max(cost, std::numeric_limits<double>::min());
    method_.progress = [this](const LagrangeNewtonIteration& step) { return record(step); };
    method_.stop = [this] { return is_told_to_stop_during_a_step(); };
    if (!record({.cost = cost, .evaluations = 1})) return;
    while (lagrangian_.mode() == Lagrangian::Mode::exact_penalty) {
      if (!untangle()) return;
    }
    const LagrangeNewtonResult result = minimise(options_.max_iterations);
    if (result.multipliers.size() > 0) {  // there are none before the first step
      lagrangian_.set_multipliers(program_.in_order_of_rows(result.multipliers));
    }
  }

 private:
  // A stage of the smoothed penalty, until demands are met. Where cells are inverted, linearised
  // demands contradict each other, and the penalty (4) has minima of its own in which the method
  // would be caught; smoothed, wide first, it has fewer.
  // Returns false if someone wants to stop.
  bool untangle() {
    program_.penalise(true);
    is_untangling_ = true;
    minimise(kMostStepsInStage);
    program_.penalise(false);
    is_untangling_ = false;
    lagrangian_.advance(workers_, x_, kMostStepsInStage, true);
    return !is_told_to_stop_ && steps() < options_.max_iterations;
  }

  LagrangeNewtonResult minimise(int most) {
    evaluations_before_ = report_.history.back().evaluations;
    first_eta_ = 0.0;
    method_.max_iterations = std::min(most, options_.max_iterations - steps());
    LagrangeNewtonResult result =
        lagrange_newton(program_, Eigen::VectorXd::Zero(program_.unknowns()), method_);
    if (!is_told_to_stop_) report_.stop = result.stop;
    if (steps() == options_.max_iterations && report_.stop != Stop::converged &&
        !is_told_to_stop_) {
      report_.stop = Stop::iteration_limit;
    }
    ++function_;
    return result;
  }

  bool is_late() const {
    return options_.time_limit_seconds > 0.0 && timer_.seconds() >= options_.time_limit_seconds;
  }

  bool is_told_to_stop_during_a_step() {
    const bool interrupted = options_.interrupted && options_.interrupted();
    if (!interrupted && !is_late()) return false;
    is_told_to_stop_ = true;
    report_.stop = interrupted ? Stop::interrupted : Stop::time_limit;
    return true;
  }

  int steps() const { return report_.history.back().number; }

  // False if the method is to stop here.
  bool record(const LagrangeNewtonIteration& step) {
    if (step.number == 1) first_eta_ = step.eta.sum();
    const double relative = first_eta_ > 0.0          ? std::sqrt(step.eta.sum() / first_eta_)
                            : report_.history.empty() ? 1.0
                                                      : 0.0;
    report_.history.push_back({.number = static_cast<int>(report_.history.size()),
                               .cost = step.cost,
                               .gradient = relative,
                               .plain_gradient = relative,
                               .step = step.alpha,
                               .max_move = step.number > 0 ? program_.max_move() : 0.0,
                               .limited = 0,
                               .inverted = program_.inverted(),
                               .function = function_,
                               .evaluations = evaluations_before_ + step.evaluations,
                               .seconds = timer_.seconds(),
                               .eta = step.eta});
    const bool late = is_late();
    if (!observe_ && options_.watch) options_.watch(report_.history.back(), x_);
    const bool interrupted = (observe_ && !observe_(x_)) ||
                             (options_.progress && !options_.progress(report_.history.back()));
    is_told_to_stop_ = late || interrupted;
    if (is_told_to_stop_) report_.stop = interrupted ? Stop::interrupted : Stop::time_limit;
    if (is_untangling_ && lagrangian_.violation(workers_, x_).cells == 0) return false;
    return !is_told_to_stop_;
  }

  static constexpr int kMostStepsInStage = 30;

  Workers& workers_;
  Objective& objective_;
  Lagrangian& lagrangian_;
  const Options& options_;
  std::vector<Vec3>& x_;
  Report& report_;
  const std::function<bool(Points)>& observe_;
  MeshProgram program_;
  LagrangeNewtonOptions method_;
  Timer timer_;
  double first_eta_ = 0.0;
  int function_ = 0;  // counts what was minimised
  int evaluations_before_ = 0;
  bool is_untangling_ = false;
  bool is_told_to_stop_ = false;
};

}  // namespace

void descend_densely(Workers& workers, Objective& objective, const Flips* flips,
                     const Options& options, std::vector<Vec3>& x, Report& report,
                     const std::function<bool(Points x)>& observe) {
  DenseDescent(workers, objective, flips, options, x, report, observe).run();
}

}  // namespace evenmesh
