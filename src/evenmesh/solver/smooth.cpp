// SPDX-License-Identifier: MIT
#include "evenmesh/solver/smooth.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/parallel.h"
#include "evenmesh/base/timer.h"
#include "evenmesh/solver/descent.h"
#include "evenmesh/solver/flips.h"
#include "evenmesh/solver/guard.h"
#include "evenmesh/solver/multigrid.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/reorder.h"

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
  const double cpu_before = cpu_seconds();
  Objective objective(mesh, problem);
  Multigrid preconditioner(workers, objective.majoriser(workers, mesh.points()));
  report.multigrid_levels = preconditioner.levels();
  report.setup_seconds += setup.seconds();
  report.setup_cpu_seconds = cpu_seconds() - cpu_before;

  const Timer solve;
  const Flips flips(objective.layout(), mesh.points(), problem.orientation);
  std::vector<Vec3> x(mesh.points().begin(), mesh.points().end());
  descend(workers, objective, preconditioner, flips, options, x, report);
  report.solve_seconds = solve.seconds();
  return x;
}

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
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (before[v] == after[v]) continue;
    const double move = (after[v] - before[v]).norm();
    ++report.moved;
    report.max_move = std::max(report.max_move, move);
    sum += move;
  }
  if (report.moved > 0) report.mean_move = sum / static_cast<double>(report.moved);
}

double cost_at(Workers& workers, const Mesh& mesh, const Problem& problem, Points points) {
  return Objective(mesh, problem).evaluate(workers, points, {});
}

// smooth() for a mesh in good order.
Report smooth_in_order(Workers& workers, Mesh& mesh, const Problem& problem,
                       const Options& options) {
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
  restore_unmoved(mesh.points(), points);
  count_moves(mesh.points(), points, report);
  report.check_seconds += checking.seconds();
  mesh.set_points(std::move(points));
  return report;
}

}  // namespace

Report smooth(Mesh& mesh, const Problem& problem, const Options& options) {
  check(options);
  assert(problem.motion.size() == mesh.point_count());
  Workers workers(options.threads);
  const Timer ordering;
  std::optional<Reordered> reordered = reorder_if_poor(mesh, problem);
  if (!reordered) return smooth_in_order(workers, mesh, problem, options);

  const double ordering_seconds = ordering.seconds();
  Options inner = options;
  if (options.representable) {
    inner.representable = [&](Points points) {
      return reordered->from_original(options.representable(reordered->to_original(points)));
    };
  }
  Report report = smooth_in_order(workers, reordered->mesh, reordered->problem, inner);
  report.setup_seconds += ordering_seconds;
  mesh.set_points(reordered->to_original(reordered->mesh.points()));
  return report;
}

}  // namespace evenmesh
