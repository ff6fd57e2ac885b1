// SPDX-License-Identifier: MIT
#include "evenmesh/solver/relax.h"

#include <algorithm>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/timer.h"
#include "evenmesh/cost/global.h"
#include "evenmesh/mesh/measure.h"
#include "evenmesh/quality/metric.h"
#include "evenmesh/solver/global_laplacian.h"

namespace evenmesh {
namespace {

class Sweeps {
 public:
  Sweeps(Workers& workers, Relaxation& relaxation, const Mesh& mesh, const Objective& objective,
         const Options& options, std::vector<Vec3>& x, Report& report,
         const std::function<bool(Points)>& observe)
      : workers_(workers),
        relaxation_(relaxation),
        mesh_(mesh),
        objective_(objective),
        options_(options),
        report_(report),
        observe_(observe),
        x_(x),
        places_(objective.problem().motion.start()),
        edge_(local_edge_lengths(mesh)) {}

  void run() {
    record({}, 1.0);
    report_.stop = Stop::iteration_limit;
    for (int i = 1;; ++i) {
      if (observe_ && !observe_(x_)) return;
      if (!observe_ && options_.watch) options_.watch(report_.history.back(), x_);
      const bool go_on = !options_.progress || options_.progress(report_.history.back());
      if (i > 1 && report_.history.back().gradient <= options_.tolerance) {
        report_.stop = Stop::converged;
        return;
      }
      if (!go_on) {
        report_.stop = Stop::interrupted;
        return;
      }
      if (options_.time_limit_seconds > 0.0 && timer_.seconds() >= options_.time_limit_seconds) {
        report_.stop = Stop::time_limit;
        return;
      }
      if (i > options_.max_iterations) return;
      const std::vector<Vec3> before = x_;
      relaxation_.sweep(workers_, x_, places_);
      record(before, 0.0);
    }
  }

 private:
  struct Moves {
    double greatest = 0.0;  // mesh length unit
    double relative = 0.0;  // to the edges around
  };

  // The greatest of many is the same in any order.
  Moves moves_from(Points before) const {
    Moves moves;
    for (std::size_t v = 0; v < before.size(); ++v) {
      if (before[v] == x_[v]) continue;
      const double move = (x_[v] - before[v]).norm();
      moves.greatest = std::max(moves.greatest, move);
      if (edge_[v] > 0.0) moves.relative = std::max(moves.relative, move / edge_[v]);
    }
    return moves;
  }

  // As Iteration::inverted has it: cells without a vertex that may move do not count.
  std::size_t count_inverted() const {
    const Cells& cells = mesh_.cells();
    const Problem& problem = objective_.problem();
    const double sum =
        sum_over_ranges(workers_, cells.size(), [&](std::size_t first, std::size_t last) {
          std::vector<Vec3> corners;
          double part = 0.0;
          for (std::size_t c = first; c < last; ++c) {
            bool moves = false;
            corners.clear();
            for (const Index v : cells.vertices(c)) {
              moves = moves || problem.motion.freedom(v) != Motion::Freedom::fixed;
              corners.push_back(x_[v]);
            }
            if (!moves) continue;
            part += is_inverted(cells.kind(c), corners, problem.orientation.up(c),
                                problem.orientation.sign(c));
          }
          return part;
        });
    return static_cast<std::size_t>(sum);
  }

  // @param before  where vertices were before the sweep; empty: there was none
  void record(Points before, double gradient) {
    const Moves moves = moves_from(before);
    const int number = static_cast<int>(report_.history.size());
    report_.history.push_back({.number = number,
                               .cost = objective_.cost(workers_, x_),
                               .gradient = before.empty() ? gradient : moves.relative,
                               .plain_gradient = before.empty() ? gradient : moves.relative,
                               .step = before.empty() ? 0.0 : 1.0,
                               .max_move = moves.greatest,
                               .inverted = count_inverted(),
                               .evaluations = number,
                               .seconds = timer_.seconds()});
  }

  Workers& workers_;
  Relaxation& relaxation_;
  const Mesh& mesh_;
  const Objective& objective_;
  const Options& options_;
  Report& report_;
  const std::function<bool(Points)>& observe_;
  const Timer timer_;
  std::vector<Vec3>& x_;
  Motion::Places places_;
  const std::vector<double> edge_;  // per vertex: the mean length of its edges in the input
};

}  // namespace

void check_method(Method method, const Mesh& mesh, const Problem& problem) {
  if (method == Method::lagrange_newton) return;
  check_cells(method, mesh.cells());
  const auto refuse = [&](std::string_view what, std::string_view remedy) {
    throw InvalidOption(fmt::format("the method {} cannot {}; {}, or choose lagrange_newton",
                                    name(method), what, remedy));
  };
  if (!problem.bounds.empty()) {
    refuse(fmt::format("keep {} within bounds", problem.bounds[0].function->name()),
           "leave the demand out");
  }
  if (problem.validity.min_size > 0.0 || problem.validity.min_jacobian > 0.0) {
    refuse("keep cells above a least size or Jacobian", "leave the demand out");
  }
  if (!problem.targets.empty() && problem.terms.empty()) {
    refuse("let vertices follow those that are brought to targets", "give the problem a cost");
  }
  const bool keeps_lengths = method == Method::lennard_jones ||
                             method == Method::lennard_jones_printed || method == Method::pliant;
  if (keeps_lengths) return;
  if (const auto vertex = find_loose_vertex(mesh, problem)) {
    refuse(fmt::format("hold the piece of the mesh around vertex {}, all of whose vertices may "
                       "move to one place: it would shrink to a point",
                       *vertex),
           "fix some (--fix boundary)");
  }
}

std::unique_ptr<Relaxation> relaxation_of(Method method, const Mesh& mesh, const Problem& problem) {
  if (method == Method::global_laplacian) {
    return std::make_unique<GlobalLaplacian>(mesh, problem.motion);
  }
  return make_relaxation(method, {.mesh = mesh,
                                  .orientation = problem.orientation,
                                  .motion = problem.motion,
                                  .length = mean_edge_length(mesh)});
}

void relax(Workers& workers, Relaxation& relaxation, const Mesh& mesh, const Objective& objective,
           const Options& options, std::vector<Vec3>& x, Report& report,
           const std::function<bool(Points x)>& observe) {
  Sweeps(workers, relaxation, mesh, objective, options, x, report, observe).run();
}

}  // namespace evenmesh
