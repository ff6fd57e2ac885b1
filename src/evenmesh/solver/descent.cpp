// SPDX-License-Identifier: MIT
#include "evenmesh/solver/descent.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "evenmesh/base/timer.h"
#include "evenmesh/solver/direction.h"
#include "evenmesh/solver/newton.h"
#include "evenmesh/solver/vectors.h"

namespace evenmesh {
namespace {

constexpr double kSufficient = 1e-4;  // part of the predicted decrease a step must bring
constexpr double kFlat = 0.1;         // a slope this much smaller than at the start needs no secant
constexpr double kRounding = 1e-13;   // relative error of a sum of costs
constexpr double kNoMove = 1e-15;     // relative to the coordinates
constexpr int kMostBacktracks = 12;
constexpr double kShortestStep = 1e-6;  // of a step that cannot be taken whole
constexpr int kMostLimitRounds = 15;
constexpr int kStrikes = 3;  // vertices limited this often stay where they are
constexpr int kFailuresBeforeLbfgs = 2;
constexpr int kSlowAfter = 100;     // iterations in which the gradient should fall tenfold
constexpr double kInnerFall = 0.1;  // of the gradient before multipliers are worth updating
constexpr int kStepsBetweenLooks = 30;
constexpr std::size_t kWindow = 30;  // iterations from which the rate of convergence is told
constexpr std::size_t kMostVerticesForNewton = 100000;  // unless it was asked for
constexpr double kMostOperationsForNewton = 1e10;       // of a factorisation

class Descent {
 public:
  Descent(Workers& workers, Objective& objective, Multigrid& preconditioner, const Flips& flips,
          const Options& options, std::vector<Vec3>& x, Report& report,
          const std::function<bool(Points)>& observe)
      : workers_(workers),
        objective_(objective),
        preconditioner_(preconditioner),
        flips_(flips),
        options_(options),
        report_(report),
        observe_(observe),
        x_(x),
        x_new_(x),
        g_(x.size()),
        g_new_(x.size()),
        z_(x.size()),
        p_(x.size(), Vec3::Zero()),
        places_(objective.motion().start()),
        places_new_(places_),
        strikes_(x.size(), 0),
        inverted_(x.size()) {}

  void run() {
    cost_ = evaluate(x_, places_, g_);
    precondition();
    start_ = std::sqrt(std::max(decrement_, std::max(0.0, cost_)));
    start_decrement_ = decrement_;
    start_plain_ = dot(workers_, g_, g_);
    look_for_inverted_cells();
    record(0.0, 0.0, 0);
    report_.stop = Stop::iteration_limit;
    if (!std::isfinite(cost_) || !std::isfinite(decrement_)) {
      report_.stop = Stop::no_descent;  // beyond the range of double: nothing to compare with
      return;
    }
    // z is what a Newton step would move. Less than the rounding of coordinates is nothing.
    size_ = largest(workers_, x_);
    if (largest(workers_, z_) <= kNoMove * size_ && demands_are_met()) {
      report_.stop = Stop::converged;
      return;
    }
    inner_target_ = kInnerFall * norm();
    if (options_.solver == SolverKind::newton) turn_to_newton();
    for (int i = 1;; ++i) {
      if (observe_ && !observe_(x_)) return;
      if (!observe_ && options_.watch) options_.watch(report_.history.back(), x_);
      const bool go_on = !options_.progress || options_.progress(report_.history.back());
      if (done()) {
        report_.stop = Stop::converged;
        return;
      }
      if (!go_on) {
        report_.stop = Stop::interrupted;
        return;
      }
      if (out_of_time()) {
        report_.stop = Stop::time_limit;
        return;
      }
      if (i > options_.max_iterations) return;
      if (!step() && !change_function(true) && !turn_to_newton()) {
        report_.stop = Stop::no_descent;
        return;
      }
    }
  }

 private:
  bool out_of_time() const {
    return options_.time_limit_seconds > 0.0 && timer_.seconds() >= options_.time_limit_seconds;
  }

  double evaluate(const std::vector<Vec3>& x, const Motion::Places& places, std::vector<Vec3>& g) {
    ++evaluations_;
    const double value = objective_.evaluate(workers_, x, g);
    objective_.motion().reduce(workers_, places, g);
    return value;
  }

  // z = M g, and what a Newton step with M would gain, twice.
  void precondition() {
    preconditioner_.apply(workers_, g_, z_);
    project(z_);
    decrement_ = dot(workers_, g_, z_);
    if (decrement_ < 0.0) decrement_ = 0.0;  // rounding; what is not a number stays so
  }

  // ---- constraints: the function changes on the way ----

  double norm() const { return std::sqrt(twice_the_gain()); }

  bool demands_are_met() {
    const Lagrangian* lagrangian = objective_.lagrangian();
    return lagrangian == nullptr || lagrangian->violation(workers_, x_).greatest == 0.0;
  }

  // True if the function has been minimised and is the last one.
  bool done() {
    if (norm() <= options_.tolerance * start_) return !change_function(true);
    if (looks_often() || norm() <= inner_target_ || ++steps_since_look_ >= kStepsBetweenLooks) {
      change_function(false);
    }
    return false;
  }

  // Where a look may change the function at every iterate.
  bool looks_often() const {
    const Lagrangian* lagrangian = objective_.lagrangian();
    return lagrangian != nullptr &&
           (lagrangian->dormant() || lagrangian->mode() == Lagrangian::Mode::exact_penalty);
  }

  // Lets multipliers and penalties follow the iterates; true if that made it another function.
  bool change_function(bool minimised) {
    Lagrangian* lagrangian = objective_.lagrangian();
    if (lagrangian == nullptr) return false;
    const bool changed = lagrangian->advance(workers_, x_, steps_since_change_, minimised);
    steps_since_look_ = 0;
    if (!changed) {
      if (norm() <= inner_target_) inner_target_ = kInnerFall * norm();
      return false;
    }
    steps_since_change_ = 0;
    ++function_;
    cost_ = evaluate(x_, places_, g_);
    precondition();
    conjugate_.restart();
    lbfgs_.restart();
    lbfgs_on_ = false;
    slow_since_ = report_.history.size();
    trial_ = 1.0;
    inner_target_ = kInnerFall * norm();
    return true;
  }

  // While cells are inverted steps are not limited: they have to pass through one another.
  void look_for_inverted_cells() {
    if (inverted_ == 0) return;
    const Lagrangian* lagrangian = objective_.lagrangian();
    inverted_ = lagrangian == nullptr ? 0 : lagrangian->violation(workers_, x_).inverted;
  }

  // About twice what the cost can still fall; below a part of the cost it is lost in rounding.
  // Where springs are much stiffer than the cost, steps are far longer than 1 and the gain is as
  // many times what the preconditioner makes of it.
  double twice_the_gain() const { return (trial_ > 10.0 ? trial_ : 1.0) * decrement_; }

  void project(std::vector<Vec3>& vectors) {
    objective_.motion().project(workers_, places_, vectors);
  }

  // One iterate further; false if no direction leads down.
  bool step() {
    note_slowness();
    choose_direction();
    double slope = dot(workers_, g_, p_);
    double alpha = slope < 0.0 ? search_line(slope) : 0.0;
    if (alpha == 0.0) {
      forget_past();
      for_ranges(workers_, p_.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) p_[v] = -z_[v];
      });
      slope = -decrement_;
      trial_ = 1.0;
      alpha = search_line(slope);
      if (alpha == 0.0) return false;
    }
    trial_ = alpha;
    const std::size_t limited = limit(alpha);
    if (limited == kRejected) return false;
    add(workers_, x_new_, -1.0, x_, z_);  // z is free until the next preconditioning
    const double max_move = largest(workers_, z_);
    if (max_move <= kNoMove * size_) return false;
    if (lbfgs_on_) lbfgs_.remember(workers_, x_new_, x_, g_new_, g_);
    std::swap(x_, x_new_);
    std::swap(g_, g_new_);
    std::swap(places_, places_new_);
    cost_ = cost_new_;
    ++steps_since_change_;
    precondition();
    look_for_inverted_cells();
    record(alpha, max_move, limited);
    return true;
  }

  void choose_direction() {
    if (newton_) {
      trial_ = 1.0;
      if (!newton_->update(workers_, x_, places_)) {
        std::fill(p_.begin(), p_.end(), Vec3::Zero());  // none: step() goes along -M g
        return;
      }
      newton_->solve(g_, p_);
      ++report_.newton_steps;
      return;
    }
    if (!lbfgs_on_) {
      conjugate_.next(workers_, g_, g_new_, z_, p_);
      if (!objective_.motion().slots().empty()) project(p_);  // directions turn along tracks
      return;
    }
    p_ = g_;
    lbfgs_.before_preconditioner(workers_, p_);
    preconditioner_.apply(workers_, p_, p_);
    project(p_);
    lbfgs_.after_preconditioner(workers_, p_);
    project(p_);
    trial_ = 1.0;
  }

  void forget_past() {
    conjugate_.restart();
    lbfgs_.restart();
    if (++failures_ >= kFailuresBeforeLbfgs) lbfgs_on_ = true;
  }

  // Newton's directions from here on; false if they are in use, not wanted or not affordable.
  bool turn_to_newton() {
    if (newton_ || options_.solver == SolverKind::multigrid || newton_refused_) return false;
    const bool automatic = options_.solver == SolverKind::automatic;
    newton_refused_ =
        automatic && (x_.size() > kMostVerticesForNewton || objective_.motion().has_kinks());
    if (newton_refused_) return false;
    newton_.emplace(objective_, x_);
    newton_refused_ =
        !newton_->fits() || (automatic && newton_->operations() > kMostOperationsForNewton);
    if (newton_refused_) {
      newton_.reset();
      return false;
    }
    report_.solver = SolverKind::newton;
    return true;
  }

  // True if at the rate of the last iterations those that are left are not enough.
  bool will_run_out() {
    const std::size_t n = report_.history.size();
    if (n <= kWindow) return false;
    const double left = options_.max_iterations - static_cast<double>(n - 1);
    // Where the function changes on the way there is no rate to speak of.
    if (n <= slow_since_ + kWindow) return left < 0.25 * options_.max_iterations;
    const double fall =
        std::log(report_.history[n - 1 - kWindow].gradient / report_.history.back().gradient);
    const double wanted = std::log(norm() / (options_.tolerance * start_));
    return wanted * static_cast<double>(kWindow) > left * fall;
  }

  void note_slowness() {
    const std::size_t n = report_.history.size();
    const bool automatic = options_.solver == SolverKind::automatic;
    if (automatic && inverted_ == 0 && will_run_out()) turn_to_newton();
    if (newton_) return;
    if (lbfgs_on_ || n <= slow_since_ + kSlowAfter) return;
    if (report_.history.back().gradient > 0.1 * report_.history[n - 1 - kSlowAfter].gradient) {
      lbfgs_on_ = true;
    }
  }

  // Finds a step length along p that lowers the cost; x_new, g_new and cost_new belong to it.
  // 0 if there is none.
  double search_line(double slope) {
    double alpha = trial_;
    double slope_new = try_step(alpha);
    if (std::isfinite(cost_new_) && std::abs(slope_new) > kFlat * std::abs(slope)) {
      const double secant = slope_new > slope ? alpha * slope / (slope - slope_new) : 4.0 * alpha;
      alpha = std::clamp(secant, 0.1 * alpha, 10.0 * alpha);
      slope_new = try_step(alpha);
    }
    for (int i = 0; i < kMostBacktracks; ++i) {
      if (cost_new_ <= cost_ + kSufficient * alpha * slope) return alpha;
      const bool flat = cost_new_ <= cost_ + kRounding * std::abs(cost_);
      if (flat && std::abs(slope_new) <= 0.9 * std::abs(slope)) return alpha;
      // The parabola through both values and the slope has its least value here.
      const double excess = cost_new_ - cost_ - alpha * slope;
      const double parabola = -0.5 * slope * alpha * alpha / excess;
      alpha =
          std::isfinite(parabola) ? std::clamp(parabola, 0.05 * alpha, 0.5 * alpha) : 0.1 * alpha;
      slope_new = try_step(alpha);
    }
    return 0.0;
  }

  double try_step(double alpha) {
    move_to(alpha);
    cost_new_ = evaluate(x_new_, places_new_, g_new_);
    return dot(workers_, g_new_, p_);
  }

  void move_to(double alpha) {
    add(workers_, x_, alpha, p_, x_new_);
    objective_.motion().retract(workers_, x_, places_, x_new_, places_new_);
  }

  // Shortens the step of vertices around cells that it would turn over, halving until none does.
  // Returns how many vertices that took, or kRejected.
  std::size_t limit(double& alpha) {
    if (options_.judge == Judge::nothing || inverted_ > 0) return 0;
    std::vector<Index> shortened;
    // Stopping one vertex can make the next cell turn over, and so on through the mesh. Where that
    // does not end soon the whole step is too long.
    const double whole = alpha;
    while (!shorten_until_valid(alpha, shortened)) {
      forget_shortened(shortened);
      alpha *= 0.3;
      if (alpha < kShortestStep * whole) return kRejected;
      move_to(alpha);
    }
    const std::size_t limited = shortened.size();
    if (limited == 0 && alpha == whole) return 0;
    // A step too long for everybody says nothing about single vertices.
    if (alpha == whole) {
      for (const Index v : shortened) hold_after_strikes(v);
    }
    cost_new_ = evaluate(x_new_, places_new_, g_new_);
    const bool lower = cost_new_ <= cost_ + kRounding * std::abs(cost_);
    if (!lower) {
      // What the others gain does not make up for it: go without these vertices.
      for (const Index v : shortened) hold(v);
      retry_without_held();
    }
    forget_shortened(shortened);
    return limited;
  }

  bool shorten_until_valid(double alpha, std::vector<Index>& shortened) {
    for (int round = 0; round < kMostLimitRounds; ++round) {
      const std::vector<Index> offenders = flips_.find(workers_, x_, x_new_);
      if (offenders.empty()) return true;
      shorten(offenders, round, alpha, shortened);
    }
    return false;
  }

  void shorten(const std::vector<Index>& offenders, int round, double alpha,
               std::vector<Index>& shortened) {
    if (part_.empty()) part_.assign(x_.size(), 1.0f);
    const Motion& motion = objective_.motion();
    for (const Index offender : offenders) {
      const Index v = motion.leader(offender);
      if (motion.freedom(v) == Motion::Freedom::fixed) continue;
      if (part_[v] == 1.0f) shortened.push_back(v);
      part_[v] = round < 4 ? 0.5f * part_[v] : 0.0f;
      x_new_[v] = x_[v] + part_[v] * alpha * p_[v];
      motion.retract(v, x_, places_, x_new_, places_new_);
    }
  }

  void forget_shortened(std::vector<Index>& shortened) {
    for (const Index v : shortened) part_[v] = 1.0f;
    shortened.clear();
  }

  void hold_after_strikes(Index v) {
    if (++strikes_[v] >= kStrikes) hold(v);
  }

  void hold(Index v) {
    if (objective_.motion().freedom(v) == Motion::Freedom::fixed) return;
    objective_.motion().fix(v);
    p_[v] = g_[v] = g_new_[v] = Vec3::Zero();
    ++report_.held;
  }

  void retry_without_held() {
    conjugate_.restart();
    lbfgs_.restart();
    double alpha = trial_;
    for (int i = 0; i < kMostBacktracks; ++i, alpha *= 0.5) {
      try_step(alpha);
      if (cost_new_ <= cost_ && flips_.find(workers_, x_, x_new_).empty()) return;
    }
    // Nothing gained this way either; the next direction starts afresh from where we are.
    x_new_ = x_;
    places_new_ = places_;
    cost_new_ = evaluate(x_new_, places_new_, g_new_);
  }

  void record(double step, double max_move, std::size_t limited) {
    const auto relative = [](double now, double first) {
      return first > 0.0 ? std::sqrt(now / first) : 0.0;
    };
    report_.history.push_back({.number = static_cast<int>(report_.history.size()),
                               .cost = cost_,
                               .gradient = relative(decrement_, start_decrement_),
                               .plain_gradient = relative(dot(workers_, g_, g_), start_plain_),
                               .step = step,
                               .max_move = max_move,
                               .limited = limited,
                               .inverted = inverted_,
                               .function = function_,
                               .evaluations = evaluations_,
                               .seconds = timer_.seconds()});
  }

  static constexpr std::size_t kRejected = ~std::size_t{0};

  Workers& workers_;
  Objective& objective_;
  Multigrid& preconditioner_;
  const Flips& flips_;
  const Options& options_;
  Report& report_;
  const std::function<bool(Points)>& observe_;
  Timer timer_;

  std::vector<Vec3>& x_;
  std::vector<Vec3> x_new_;
  std::vector<Vec3> g_, g_new_;  // after a step g_new_ holds the previous gradient
  std::vector<Vec3> z_, p_;
  Motion::Places places_, places_new_;
  std::vector<std::uint8_t> strikes_;
  std::size_t inverted_;     // cells, of those that constraints want valid; not known at first
  std::vector<float> part_;  // of its step that a vertex takes, 1 but while limit() is at work
  double cost_ = 0.0;
  double cost_new_ = 0.0;
  double size_ = 0.0;       // of the coordinates
  double decrement_ = 0.0;  // g.z
  double start_ = 0.0;
  double start_decrement_ = 0.0;
  double start_plain_ = 0.0;
  double trial_ = 1.0;          // step length to try first
  double inner_target_ = 0.0;   // norm at which constraints are looked at again
  int function_ = 0;            // counts its changes
  int steps_since_change_ = 0;  // of the function
  int steps_since_look_ = 0;    // at constraints
  std::size_t slow_since_ = 0;  // iterate from which on slowness counts
  int evaluations_ = 0;
  int failures_ = 0;
  bool lbfgs_on_ = false;
  ConjugateGradients conjugate_;
  Lbfgs lbfgs_;
  std::optional<NewtonSystem> newton_;
  bool newton_refused_ = false;
};

}  // namespace

void descend(Workers& workers, Objective& objective, Multigrid& preconditioner, const Flips& flips,
             const Options& options, std::vector<Vec3>& x, Report& report,
             const std::function<bool(Points x)>& observe) {
  Descent(workers, objective, preconditioner, flips, options, x, report, observe).run();
}

}  // namespace evenmesh
