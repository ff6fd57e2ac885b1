// SPDX-License-Identifier: MIT
#include "evenmesh/solver/smooth.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/parallel.h"
#include "evenmesh/base/timer.h"
#include "evenmesh/mesh/measure.h"
#include "evenmesh/solver/bring.h"
#include "evenmesh/solver/dense.h"
#include "evenmesh/solver/descent.h"
#include "evenmesh/solver/flips.h"
#include "evenmesh/solver/guard.h"
#include "evenmesh/solver/holding.h"
#include "evenmesh/solver/input_check.h"
#include "evenmesh/solver/lift.h"
#include "evenmesh/solver/milder_cost.h"
#include "evenmesh/solver/multigrid.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/relax.h"
#include "evenmesh/solver/reorder.h"
#include "evenmesh/solver/stages.h"

namespace evenmesh {

void check(const Options& options) {
  constexpr int kMostThreads = 1024;
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0)) {
    throw InvalidOption(
        fmt::format("the tolerance must lie between 0 and 1, not {}", options.tolerance));
  }
  if (!(options.eta >= 0.0)) {
    throw InvalidOption(fmt::format("eta must not be negative: {}", options.eta));
  }
  if (options.max_iterations < 0) {
    throw InvalidOption(
        fmt::format("the number of iterations must not be negative: {}", options.max_iterations));
  }
  if (!(options.time_limit_seconds >= 0.0)) {
    throw InvalidOption(
        fmt::format("the time limit must not be negative: {}", options.time_limit_seconds));
  }
  if (!(options.lift_below <= 1.0)) {
    throw InvalidOption(
        fmt::format("shape is at most 1, cells below {} cannot be lifted", options.lift_below));
  }
  if (options.threads < 0 || options.threads > kMostThreads) {
    throw InvalidOption(fmt::format("the number of threads must lie between 0 and {}, not {}",
                                    kMostThreads, options.threads));
  }
}

namespace {

// Adding 0 turns -0 into 0. Coordinates that have not moved keep their bits.
void restore_unmoved(Points before, std::vector<Vec3>& after) {
  for (std::size_t v = 0; v < before.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      if (after[v][axis] == before[v][axis]) after[v][axis] = before[v][axis];
    }
  }
}

void count_moves(Points before, Points after, Report& report) {
  double sum = 0.0;
  report.moved = 0;
  report.max_move = 0.0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (before[v] == after[v]) continue;
    const double move = (after[v] - before[v]).norm();
    ++report.moved;
    report.max_move = std::max(report.max_move, move);
    sum += move;
  }
  if (report.moved > 0) report.mean_move = sum / static_cast<double>(report.moved);
}

// Multipliers leave moves longer than allowed by a part in many thousands: cuts these off.
// @param origin  where moves are measured from
// @param start   where vertices are at the motion's start
void keep_within_moves(const Problem& problem, Points origin, Points start,
                       std::vector<Vec3>& points) {
  if (problem.max_move.empty()) return;
  const Motion& motion = problem.motion;
  Motion::Places places = motion.start();
  for (Index v = 0; v < points.size(); ++v) {
    if (motion.leader(v) != v || motion.freedom(v) == Motion::Freedom::fixed) continue;
    double limit = std::numeric_limits<double>::infinity();
    motion.for_tied(v, [&](Index u) { limit = std::min(limit, problem.max_move[u]); });
    // A track may bend away from the way back: a few attempts.
    constexpr int kMostCuts = 20;
    for (int i = 0; i < kMostCuts && (points[v] - origin[v]).norm() > limit; ++i) {
      const Vec3 move = points[v] - origin[v];
      points[v] = origin[v] + ((1.0 - 1e-12 - 1e-3 * i) * limit / move.norm()) * move;
      motion.retract(v, start, motion.start(), points, places);
    }
  }
}

// Relative to a start that is all but the minimum.
constexpr double kToleranceOfRest = 0.1;

// smooth() for a mesh in good order, step by step.
class Smoothing {
 public:
  /// @param origin  where moves are measured from: the mesh's points, unless it has been brought
  ///                to targets
  Smoothing(Workers& workers, const Mesh& mesh, Points origin, const Problem& problem,
            const Options& options)
      : workers_(workers),
        mesh_(mesh),
        origin_(origin),
        problem_(problem),
        options_(options),
        guard_(workers, mesh, problem.orientation) {
    if (std::isfinite(problem.max_deviation)) {
      limit_.emplace(mesh, problem.orientation.type, problem.max_deviation);
      guard_.set_limit(&*limit_);
    }
    guard_.set_motion(&problem.motion);
    report_.method = options.method;
    report_.vertices = mesh.point_count();
    report_.movable = problem.motion.moving();
    report_.quality_before = report_.quality_after = guard_.before();
    report_.check_seconds = timer_.seconds();
    points_.assign(mesh.points().begin(), mesh.points().end());
  }

  void run() {
    const bool classic = options_.method != Method::lagrange_newton;
    if (report_.movable == 0 || (problem_.terms.empty() && !classic)) return;
    Report untangling;
    Problem from_there;
    const bool untangles = !classic && wants_valid_cells(problem_) && guard_.before().inverted > 0;
    if (untangles) {
      untangling = untangle();
      from_there = problem_;
      from_there.motion.start_from(workers_, mesh_.points(), points_);
    }
    start_ = points_;
    timer_ = Timer();
    const double cpu_before = cpu_seconds();
    Objective objective(mesh_, untangles ? from_there : problem_);
    objective.constrain(workers_, mesh_, origin_);
    if (classic) {
      sweep(objective, cpu_before);
    } else if (options_.solver == SolverKind::dense) {
      minimise_densely(objective, cpu_before);
    } else {
      minimise(objective, cpu_before);
    }
    if (untangles) put_before(untangling, report_);
  }

  const Report& report() const { return report_; }
  std::vector<Vec3>& points() { return points_; }

 private:
  static bool wants_valid_cells(const Problem& problem) {
    return std::any_of(problem.terms.begin(), problem.terms.end(),
                       [](const Term& term) { return term.cost->wants_valid_cells(); });
  }

  /// Moves points_ until no cell is inverted, with other costs; the options lose what that took.
  Report untangle() {
    const Timer timer;
    const double cpu_before = cpu_seconds();
    Problem problem = problem_;
    problem.terms = untangling_terms(mesh_, problem_);
    Objective objective(mesh_, problem);
    objective.constrain(workers_, mesh_, origin_);
    Multigrid preconditioner = preconditioner_of(objective, points_);
    Flips flips = flips_of(objective, 0.0);
    Report report;
    report.setup_seconds = timer.seconds();
    report.setup_cpu_seconds = cpu_seconds() - cpu_before;

    Options options = options_;
    bool go_on = true;
    options.progress = [&](const Iteration& iteration) {
      go_on = !options_.progress || options_.progress(iteration);
      return go_on && iteration.inverted > 0;
    };
    descend(workers_, objective, preconditioner, flips, options, points_, report, {});
    report.solve_seconds = timer.seconds() - report.setup_seconds;

    take_from(options_, report.history.back().number, timer.seconds());
    if (!go_on) options_.max_iterations = 0;
    report.stop = go_on ? Stop::converged : Stop::interrupted;
    return report;
  }

  using Observe = std::function<bool(Points)>;
  /// Moves the vertices from x, in place, and fills in the report's stop and history.
  using Mover = std::function<void(std::vector<Vec3>& x, Report& report, const Observe& observe)>;

  void minimise(Objective& objective, double cpu_before) {
    Multigrid preconditioner = preconditioner_of(objective, points_);
    report_.multigrid_levels = preconditioner.levels();
    note_setup(cpu_before);

    const double least_shape = options_.judge == Judge::quality_and_inversion
                                   ? guard_.before().of(Metric::shape).worst
                                   : 0.0;
    Flips flips = flips_of(objective, least_shape);
    move(objective, [&](std::vector<Vec3>& x, Report& report, const Observe& observe) {
      descend(workers_, objective, preconditioner, flips, options_, x, report, observe);
      if (observe || report.stop != Stop::converged) return;
      if (report.held > 0) go_on_without_holding(x, report, least_shape);
      if (lifts()) {
        report.lifting =
            lift_worst(workers_, mesh_, objective.problem(), start_, origin_, options_, x);
      }
    });
  }

  // Vertices that were stopped on the way because cells around them are bad, as they are at the
  // start, may move now that these are not.
  void go_on_without_holding(std::vector<Vec3>& x, Report& report, double least_shape) {
    Problem problem = problem_;
    problem.motion.start_from(workers_, mesh_.points(), x);
    Objective objective(mesh_, problem);
    objective.constrain(workers_, mesh_, origin_);
    objective.lagrangian()->reset(workers_, x);
    Multigrid preconditioner = preconditioner_of(objective, x);
    const Flips flips = flips_of(objective, least_shape);
    Options options = options_;
    take_from(options, report.history.back().number, report.history.back().seconds);
    options.tolerance = std::max(options.tolerance, kToleranceOfRest);
    Report again;
    again.solver = report.solver;
    descend(workers_, objective, preconditioner, flips, options, x, again, {});
    Report first = report;
    first.held = 0;
    put_before(first, again);
    report.history = std::move(again.history);
    report.stop = again.stop;
    report.solver = again.solver;
    report.held = again.held;
    report.newton_steps = again.newton_steps;
  }

  bool lifts() const {
    if (options_.lift_below != 0.0) return options_.lift_below > 0.0;
    return options_.judge == Judge::quality_and_inversion && wants_valid_cells(problem_);
  }

  Multigrid preconditioner_of(const Objective& objective, Points x) const {
    return Multigrid(workers_, objective.majoriser(workers_, x),
                     objective.projectors(objective.problem().motion.start()));
  }

  Flips flips_of(const Objective& objective, double least_shape) const {
    Flips flips(objective.layout(), mesh_.points(), problem_.orientation, least_shape);
    // Surfaces have soft modes, along which all vertices of a patch drift together at little gain;
    // no vertex needs to go further than to its neighbours.
    if (problem_.orientation.type == MeshType::surface) flips.set_reach(local_edge_lengths(mesh_));
    return flips;
  }

  // It shortens steps as a whole, so it must not for the sake of one vertex: shape and reach do not
  // count on the way.
  void minimise_densely(Objective& objective, double cpu_before) {
    const Flips flips(objective.layout(), mesh_.points(), problem_.orientation);
    const Flips* judged = options_.judge == Judge::nothing ? nullptr : &flips;
    note_setup(cpu_before);
    move(objective, [&](std::vector<Vec3>& x, Report& report, const Observe& observe) {
      descend_densely(workers_, objective, judged, options_, x, report, observe);
    });
  }

  void sweep(Objective& objective, double cpu_before) {
    const auto relaxation = relaxation_of(options_.method, mesh_, problem_);
    note_setup(cpu_before);
    move(objective, [&](std::vector<Vec3>& x, Report& report, const Observe& observe) {
      relax(workers_, *relaxation, mesh_, objective, options_, x, report, observe);
    });
  }

  void note_setup(double cpu_before) {
    report_.setup_seconds = timer_.seconds();
    report_.setup_cpu_seconds = cpu_seconds() - cpu_before;
  }

  // Moves the vertices and makes what comes of it keep the promise.
  void move(Objective& objective, const Mover& mover) {
    timer_ = Timer();
    mover(points_, report_, {});
    report_.solve_seconds = timer_.seconds();

    timer_ = Timer();
    keep_within_moves(problem_, origin_, mesh_.points(), points_);
    Guard::Result result =
        guard_.enforce(workers_, points_, options_.judge, options_.representable, options_.spoilt);
    report_.inverted_unguarded = result.inverted_unguarded;
    find_holding(objective);
    const bool mean_fell = result.mean_fell;
    if (mean_fell) keep_best_iterate(objective, mover, result);
    std::unique_ptr<Objective> milder;
    if (mean_fell && may_be_milder()) milder = try_milder_cost(result);
    const Objective& minimised = milder ? *milder : objective;
    report_.cost_before = minimised.cost(workers_, mesh_.points());
    report_.promise = result.promise;
    report_.pulled_back = result.pulled_back;
    report_.deviation = result.deviation;
    report_.quality_after = result.after;
    report_.cost_after = minimised.cost(workers_, points_);
    restore_unmoved(mesh_.points(), points_);
    count_moves(mesh_.points(), points_, report_);
    report_.check_seconds += timer_.seconds();
  }

  void find_holding(Objective& objective) {
    report_.holding = holding_at(workers_, mesh_, problem_.motion, objective, points_);
    report_.unmet = count_unmet(report_.holding);
  }

  // The minimiser has a lower mean of shape than the input: the cost and the measure disagree here.
  // Goes the same way again, stops where the mean is highest, and takes that if it is better than
  // what pulling back made of the minimiser.
  void keep_best_iterate(Objective& objective, const Mover& mover, Guard::Result& result) {
    constexpr int kPatience = 4;  // iterates without a new best
    Report again = report_;
    again.history.clear();
    again.held = 0;
    again.solver = SolverKind::multigrid;
    again.newton_steps = 0;
    objective.motion() = objective.problem().motion;
    objective.lagrangian()->reset(workers_, mesh_.points());
    std::vector<Vec3> x = start_;
    std::vector<Vec3> best = x;
    double best_mean = guard_.before().of(Metric::shape).mean;
    int best_number = 0;
    int number = 0;
    mover(x, again, [&](Points iterate) {
      const double mean = guard_.mean_shape_at(workers_, iterate);
      if (mean > best_mean) {
        best_mean = mean;
        best_number = number;
        best.assign(iterate.begin(), iterate.end());
      }
      return number++ < best_number + kPatience;
    });
    if (best_number == 0) return;
    keep_within_moves(problem_, origin_, mesh_.points(), best);
    const Guard::Result other =
        guard_.enforce(workers_, best, options_.judge, options_.representable, options_.spoilt);
    if (other.promise == Promise::unimproved ||
        other.after.of(Metric::shape).mean <= result.after.of(Metric::shape).mean) {
      return;
    }
    result = other;
    result.promise = Promise::earlier_iterate;
    points_ = std::move(best);
    // Newton's are the last ones.
    const int left_out = again.history.back().number - best_number;
    again.newton_steps = std::max(0, again.newton_steps - left_out);
    again.history.resize(static_cast<std::size_t>(best_number) + 1);
    again.stop = report_.stop;
    report_ = std::move(again);
    find_holding(objective);
  }

  bool may_be_milder() const {
    return options_.method == Method::lagrange_newton && options_.solver != SolverKind::dense &&
           has_milder_cost(mesh_, problem_) && guard_.before().inverted == 0 &&
           report_.stop != Stop::interrupted && report_.stop != Stop::time_limit;
  }

  // Minimises the milder cost and takes that over if it is better than `result`.
  // @return  the cost with that, null if it was not taken over
  std::unique_ptr<Objective> try_milder_cost(Guard::Result& result) {
    const Timer timer;
    milder_problem_ = problem_;
    milder_problem_.terms = milder_terms(problem_);
    auto objective = std::make_unique<Objective>(mesh_, milder_problem_);
    objective->constrain(workers_, mesh_, origin_);
    std::vector<Vec3> x = start_;
    Multigrid preconditioner = preconditioner_of(*objective, x);
    const Flips flips = flips_of(*objective, 0.0);  // the wall sees to the worst cells
    Options options = options_;
    take_from(options, 0, report_.solve_seconds + timer_.seconds());
    options.watch = {};  // nobody knows yet whether this will have been the way
    Report milder = report_;
    milder.history.clear();
    milder.held = 0;
    milder.solver = SolverKind::multigrid;
    milder.newton_steps = 0;
    milder.lifting = {};
    descend(workers_, *objective, preconditioner, flips, options, x, milder, {});
    if (lifts() && milder.stop != Stop::interrupted && milder.stop != Stop::time_limit) {
      milder.lifting = lift_worst(workers_, mesh_, milder_problem_, start_, origin_, options, x);
    }
    const double seconds = timer.seconds();
    for (Report* report : {&report_, &milder}) {
      report->solve_seconds += seconds;
      report->check_seconds -= seconds;  // within which this is
    }
    if (milder.stop == Stop::interrupted) report_.stop = Stop::interrupted;
    keep_within_moves(problem_, origin_, mesh_.points(), x);
    const Guard::Result other =
        guard_.enforce(workers_, x, options_.judge, options_.representable, options_.spoilt);
    if (other.promise == Promise::unimproved ||
        other.after.of(Metric::shape).mean <= result.after.of(Metric::shape).mean ||
        objective->cost(workers_, x) >= objective->cost(workers_, mesh_.points())) {
      return nullptr;
    }
    result = other;
    points_ = std::move(x);
    report_ = std::move(milder);
    report_.milder_cost = true;
    report_.inverted_unguarded = other.inverted_unguarded;
    find_holding(*objective);
    return objective;
  }

  Workers& workers_;
  const Mesh& mesh_;
  const Points origin_;
  const Problem& problem_;
  Options options_;
  Timer timer_;
  Guard guard_;
  std::optional<DeviationLimit> limit_;
  Report report_;
  std::vector<Vec3> points_;
  Problem milder_problem_;
  std::vector<Vec3> start_;  // of the iterations: the input, or what untangling made of it
};

// smooth() for a mesh in good order: brings vertices to their targets, then smooths.
Report bring_and_smooth(Workers& workers, Mesh& mesh, const Problem& problem,
                        const Options& options) {
  if (problem.targets.empty()) {
    Smoothing smoothing(workers, mesh, mesh.points(), problem, options);
    smoothing.run();
    mesh.set_points(std::move(smoothing.points()));
    return smoothing.report();
  }
  const Timer timer;
  Brought brought = bring_to_targets(workers, mesh, problem, options);
  Options rest = options;
  if (options.time_limit_seconds > 0.0) {
    rest.time_limit_seconds = std::max(1e-9, options.time_limit_seconds - timer.seconds());
  }
  std::vector<Vec3> there(brought.mesh.points().begin(), brought.mesh.points().end());
  keep_within_moves(problem, mesh.points(), mesh.points(), there);
  brought.mesh.set_points(options.representable ? options.representable(there) : there);
  Problem at_targets = problem;
  at_targets.motion.start_from(workers, mesh.points(), brought.mesh.points());
  Smoothing smoothing(workers, brought.mesh, mesh.points(), at_targets, rest);
  smoothing.run();
  Report report = smoothing.report();
  report.quality_before =
      summarize(workers, measure_cells(workers, mesh, mesh.points(), problem.orientation));
  report.target_steps = brought.steps;
  restore_unmoved(mesh.points(), smoothing.points());
  count_moves(mesh.points(), smoothing.points(), report);
  mesh.set_points(std::move(smoothing.points()));
  return report;
}

}  // namespace

Report smooth(Mesh& mesh, const Problem& problem, const Options& options) {
  check(options);
  check_input(mesh, problem);
  check_method(options.method, mesh, problem);
  assert(problem.motion.size() == mesh.point_count());
  Workers workers(options.threads);
  const Timer ordering;
  std::optional<Reordered> reordered = reorder_if_poor(mesh, problem);
  if (!reordered) return bring_and_smooth(workers, mesh, problem, options);

  const double ordering_seconds = ordering.seconds();
  Options inner = options;
  if (options.representable) {
    inner.representable = [&](Points points) {
      return reordered->from_original(options.representable(reordered->to_original(points)));
    };
  }
  if (options.watch) {
    inner.watch = [&](const Iteration& iteration, Points points) {
      options.watch(iteration, reordered->to_original(points));
    };
  }
  if (options.spoilt) {
    inner.spoilt = [&](Points points) {
      std::vector<Index> here(reordered->order.size());
      for (std::size_t k = 0; k < here.size(); ++k) {
        here[reordered->order[k]] = static_cast<Index>(k);
      }
      std::vector<Index> vertices = options.spoilt(reordered->to_original(points));
      for (Index& v : vertices) v = here[v];
      return vertices;
    };
  }
  Report report = bring_and_smooth(workers, reordered->mesh, reordered->problem, inner);
  mesh.set_points(reordered->to_original(reordered->mesh.points()));
  reordered->to_original(report.holding);
  report.setup_seconds += ordering_seconds;
  return report;
}

}  // namespace evenmesh
