// SPDX-License-Identifier: MIT
#include "evenmesh/solver/descent.h"

#include <algorithm>
#include <cmath>

#include "evenmesh/base/timer.h"
#include "evenmesh/solver/direction.h"
#include "evenmesh/solver/vectors.h"

namespace evenmesh {
namespace {

constexpr double kSufficient = 1e-4;  // part of the predicted decrease a step must bring
constexpr double kFlat = 0.1;         // a slope this much smaller than at the start needs no secant
constexpr double kRounding = 1e-13;   // relative error of a sum of costs
constexpr int kMostBacktracks = 12;
constexpr int kLocalRounds = 8;  // of shortening single vertices, before the whole step is halved
constexpr int kMostHalvings = 10;
constexpr int kStrikes = 3;  // vertices limited this often stay where they are
constexpr int kFailuresBeforeLbfgs = 2;
constexpr int kSlowAfter = 100;  // iterations in which the gradient should fall tenfold

class Descent {
 public:
  Descent(Workers& workers, Objective& objective, Multigrid& preconditioner, const Flips& flips,
          const Options& options, std::vector<Vec3>& x, Report& report)
      : workers_(workers),
        objective_(objective),
        preconditioner_(preconditioner),
        flips_(flips),
        options_(options),
        report_(report),
        x_(x),
        x_new_(x),
        g_(x.size()),
        g_new_(x.size()),
        z_(x.size()),
        p_(x.size(), Vec3::Zero()),
        strikes_(x.size(), 0) {}

  void run() {
    cost_ = evaluate(x_, g_);
    precondition();
    start_ = std::sqrt(std::max(decrement_, std::max(0.0, cost_)));
    start_decrement_ = decrement_;
    start_plain_ = dot(workers_, g_, g_);
    record(0.0, 0.0, 0);
    report_.stop = Stop::iteration_limit;
    for (int i = 1;; ++i) {
      // decrement_ is about twice what the cost can still fall; below this it is lost in rounding.
      if (std::sqrt(decrement_) <= options_.tolerance * start_) {
        report_.stop = Stop::converged;
        return;
      }
      if (stop_requested(i)) return;
      if (!step()) {
        report_.stop = Stop::no_descent;
        return;
      }
    }
  }

 private:
  bool stop_requested(int next_iteration) {
    if (options_.progress && !options_.progress(report_.history.back())) {
      report_.stop = Stop::interrupted;
      return true;
    }
    if (options_.time_limit_seconds > 0.0 && timer_.seconds() >= options_.time_limit_seconds) {
      report_.stop = Stop::time_limit;
      return true;
    }
    return next_iteration > options_.max_iterations;
  }

  double evaluate(const std::vector<Vec3>& x, std::vector<Vec3>& g) {
    ++evaluations_;
    return objective_.evaluate(workers_, x, g);
  }

  // z = M g, and what a Newton step with M would gain, twice.
  void precondition() {
    preconditioner_.apply(workers_, g_, z_);
    project(z_);
    decrement_ = std::max(0.0, dot(workers_, g_, z_));
  }

  void project(std::vector<Vec3>& vectors) {
    for_ranges(workers_, vectors.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        vectors[v] = objective_.motion().project(static_cast<Index>(v), vectors[v]);
      }
    });
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
    if (lbfgs_on_) lbfgs_.remember(workers_, x_new_, x_, g_new_, g_);
    std::swap(x_, x_new_);
    std::swap(g_, g_new_);
    cost_ = cost_new_;
    precondition();
    record(alpha, max_move, limited);
    return true;
  }

  void choose_direction() {
    if (!lbfgs_on_) return conjugate_.next(workers_, g_, g_new_, z_, p_);
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

  void note_slowness() {
    const std::size_t n = report_.history.size();
    if (lbfgs_on_ || n <= kSlowAfter) return;
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
    add(workers_, x_, alpha, p_, x_new_);
    cost_new_ = evaluate(x_new_, g_new_);
    return dot(workers_, g_new_, p_);
  }

  // Shortens the step of vertices around cells that it would turn over, halving until none does;
  // where that does not end, shortens the whole step. Returns how many vertices that took, or
  // kRejected.
  std::size_t limit(double& alpha) {
    std::vector<Index> offenders = flips_.find(workers_, x_, x_new_);
    if (offenders.empty()) return 0;
    std::vector<std::pair<Index, double>> shortened;  // sorted by vertex
    for (int round = 0; !offenders.empty(); ++round) {
      if (round == kLocalRounds * kMostHalvings) return kRejected;
      if (round > 0 && round % kLocalRounds == 0) {
        // Vertices that stay behind turn over cells of those that do not, and so on outwards: the
        // step is many cells long, and no few vertices are to blame.
        alpha *= 0.5;
        shortened.clear();
        add(workers_, x_, alpha, p_, x_new_);
        offenders = flips_.find(workers_, x_, x_new_);
        if (offenders.empty()) break;
      }
      shorten(offenders, round % kLocalRounds, alpha, shortened);
      offenders = flips_.find(workers_, x_, x_new_);
    }
    for (const auto& [v, factor] : shortened) hold_after_strikes(v);
    cost_new_ = evaluate(x_new_, g_new_);
    if (cost_new_ <= cost_ + kRounding * std::abs(cost_)) return shortened.size();
    // What the others gain does not make up for it: go without these vertices.
    for (const auto& [v, factor] : shortened) hold(v);
    return retry_without_held(shortened.size());
  }

  void shorten(const std::vector<Index>& offenders, int round, double alpha,
               std::vector<std::pair<Index, double>>& shortened) {
    for (const Index v : offenders) {
      auto place = std::lower_bound(shortened.begin(), shortened.end(), std::pair(v, -1.0));
      if (place == shortened.end() || place->first != v) {
        place = shortened.insert(place, {v, 1.0});
      }
      place->second = round < 4 ? 0.5 * place->second : 0.0;
      x_new_[v] = x_[v] + place->second * alpha * p_[v];
    }
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

  std::size_t retry_without_held(std::size_t limited) {
    conjugate_.restart();
    lbfgs_.restart();
    double alpha = trial_;
    for (int i = 0; i < kMostBacktracks; ++i, alpha *= 0.5) {
      try_step(alpha);
      if (cost_new_ > cost_ || !flips_.find(workers_, x_, x_new_).empty()) continue;
      return limited;
    }
    // Nothing gained this way either; the next direction starts afresh from where we are.
    x_new_ = x_;
    cost_new_ = evaluate(x_new_, g_new_);
    return limited;
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
  Timer timer_;

  std::vector<Vec3>& x_;
  std::vector<Vec3> x_new_;
  std::vector<Vec3> g_, g_new_;  // after a step g_new_ holds the previous gradient
  std::vector<Vec3> z_, p_;
  std::vector<std::uint8_t> strikes_;
  double cost_ = 0.0;
  double cost_new_ = 0.0;
  double decrement_ = 0.0;  // g.z
  double start_ = 0.0;
  double start_decrement_ = 0.0;
  double start_plain_ = 0.0;
  double trial_ = 1.0;  // step length to try first
  int evaluations_ = 0;
  int failures_ = 0;
  bool lbfgs_on_ = false;
  ConjugateGradients conjugate_;
  Lbfgs lbfgs_;
};

}  // namespace

void descend(Workers& workers, Objective& objective, Multigrid& preconditioner, const Flips& flips,
             const Options& options, std::vector<Vec3>& x, Report& report) {
  Descent(workers, objective, preconditioner, flips, options, x, report).run();
}

}  // namespace evenmesh
