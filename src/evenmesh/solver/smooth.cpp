// SPDX-License-Identifier: MIT
#include "evenmesh/solver/smooth.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/parallel.h"
#include "evenmesh/base/timer.h"
#include "evenmesh/solver/descent.h"
#include "evenmesh/solver/flips.h"
#include "evenmesh/solver/guard.h"
#include "evenmesh/solver/multigrid.h"
#include "evenmesh/solver/objective.h"

namespace evenmesh {
namespace {

void check(const Options& options) {
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0)) {
    throw InvalidOption(
        fmt::format("the tolerance must lie between 0 and 1, not {}", options.tolerance));
  }
  if (options.max_iterations < 0) {
    throw InvalidOption(
        fmt::format("the number of iterations must not be negative: {}", options.max_iterations));
  }
  if (!(options.time_limit_seconds >= 0.0)) {
    throw InvalidOption(
        fmt::format("the time limit must not be negative: {}", options.time_limit_seconds));
  }
  if (options.threads < 0) {
    throw InvalidOption(
        fmt::format("the number of threads must not be negative: {}", options.threads));
  }
}

// Where the solver takes the mesh, promise or not.
std::vector<Vec3> minimise(Workers& workers, const Mesh& mesh, const Problem& problem,
                           const Options& options, Report& report) {
  const Timer setup;
  Objective objective(mesh, problem);
  std::vector<Vec3> x = objective.gather(mesh.points());
  const Timer multigrid_setup;
  Multigrid preconditioner(workers, objective.majoriser(workers, x));
  report.multigrid_setup_seconds = multigrid_setup.seconds();
  report.multigrid_levels = preconditioner.levels();
  report.setup_seconds = setup.seconds();

  const Timer solve;
  const Flips flips(objective.layout(), mesh, problem.orientation);
  descend(workers, objective, preconditioner, flips, options, x, report);
  report.solve_seconds = solve.seconds();

  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  objective.scatter(x, points);
  return points;
}

double cost_at(Workers& workers, const Mesh& mesh, const Problem& problem, Points points) {
  const Objective objective(mesh, problem);
  return objective.evaluate(workers, objective.gather(points), {});
}

void count_moves(Points before, Points after, Report& report) {
  double sum = 0.0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (before[v] == after[v]) continue;
    const double move = (after[v] - before[v]).norm();
    ++report.moved;
    report.max_move = std::max(report.max_move, move);
    sum += move;
  }
  if (report.moved > 0) report.mean_move = sum / static_cast<double>(report.moved);
}

}  // namespace

Report smooth(Mesh& mesh, const Problem& problem, const Options& options) {
  check(options);
  assert(problem.motion.size() == mesh.point_count());
  Workers workers(options.threads);
  Report report;
  report.vertices = mesh.point_count();
  report.movable = problem.motion.moving();

  Timer checking;
  const Guard guard(workers, mesh, problem.orientation);
  report.check_seconds = checking.seconds();
  report.quality_before = report.quality_after = guard.before();
  if (report.movable == 0 || problem.terms.empty()) return report;

  std::vector<Vec3> points = minimise(workers, mesh, problem, options, report);
  report.cost_before = report.history.front().cost;
  report.cost_after = report.history.back().cost;

  checking = Timer();
  const Judge judge = options.allow_worse ? Judge::inversion : Judge::quality_and_inversion;
  const Guard::Result result = guard.enforce(workers, points, judge, options.representable);
  report.promise = result.promise;
  report.pulled_back = result.pulled_back;
  report.quality_after = result.after;
  if (result.pulled_back > 0 || options.representable) {
    report.cost_after = cost_at(workers, mesh, problem, points);
  }
  count_moves(mesh.points(), points, report);
  report.check_seconds += checking.seconds();
  mesh.set_points(std::move(points));
  return report;
}

}  // namespace evenmesh
