// SPDX-License-Identifier: MIT
#include "evenmesh/solver/bring.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "evenmesh/base/timer.h"
#include "evenmesh/mesh/measure.h"
#include "evenmesh/mesh/whole_cell.h"
#include "evenmesh/solver/descent.h"

namespace evenmesh {
namespace {

constexpr double kShortestPart = 1.0 / 64.0;  // of the way, that a step may have
constexpr int kIterations = 40;               // of each step

// The way to the targets, step by step.
class Way {
 public:
  Way(Workers& workers, const Mesh& mesh, const Problem& problem, const Options& options)
      : workers_(workers), mesh_(mesh), problem_(problem), options_(options) {
    for (const Target& target : problem.targets) problem_.motion.fix(target.vertex);
    options_.max_iterations = kIterations;
    options_.watch = {};
    options_.tolerance = 1e-2;
    // Its iterations are not those of the run, but who wants to stop can do so here too.
    options_.progress = [this, &options](const Iteration& iteration) {
      interrupted_ = interrupted_ || (options.progress && !options.progress(iteration));
      return !interrupted_;
    };
    points_.assign(mesh.points().begin(), mesh.points().end());
    valid_.resize(mesh.cells().size());
    for (std::size_t c = 0; c < valid_.size(); ++c) valid_[c] = is_valid(c, points_);
  }

  Brought go() {
    Brought result;
    double gone = 0.0;
    double part = 1.0;
    while (gone < 1.0 && anything_to_do() && !interrupted_) {
      const double to = std::min(1.0, gone + part);
      std::vector<Vec3> there = follow(to);
      if (interrupted_) break;
      if (newly_inverted(there) > 0 && part > kShortestPart) {
        part *= 0.5;
        continue;
      }
      ++result.steps;
      problem_.motion.start_from(workers_, points_, there);
      points_ = std::move(there);
      gone = to;
      part = std::min(2.0 * part, 1.0);
    }
    result.mesh = mesh_;
    result.mesh.set_points(std::move(points_));
    return result;
  }

 private:
  bool anything_to_do() const {
    return std::any_of(problem_.targets.begin(), problem_.targets.end(),
                       [&](const Target& t) { return mesh_.points()[t.vertex] != t.position; });
  }

  bool is_valid(std::size_t cell, Points x) const {
    const CellKind kind = mesh_.cells().kind(cell);
    const auto vertices = mesh_.cells().vertices(cell);
    const Orientation& orientation = problem_.orientation;
    const auto at = [&](int i) -> const Vec3& { return x[vertices[static_cast<std::size_t>(i)]]; };
    if (traits(kind).dimension == 3) {
      std::array<Vec3, 8> corners;
      for (std::size_t i = 0; i < vertices.size(); ++i) corners[i] = x[vertices[i]];
      return is_positive_everywhere(kind, {corners.data(), vertices.size()},
                                    orientation.sign(cell));
    }
    return least_corner(kind, static_cast<int>(vertices.size()), at, orientation.up(cell), 1.0) >
           0.0;
  }

  std::size_t newly_inverted(Points x) const {
    std::size_t count = 0;
    for (std::size_t c = 0; c < valid_.size(); ++c) count += valid_[c] && !is_valid(c, x);
    return count;
  }

  // Positions with the targets that part of their way, the others where they are led from points_.
  std::vector<Vec3> follow(double part) {
    std::vector<Vec3> x = points_;
    for (const Target& target : problem_.targets) {
      const Vec3& from = mesh_.points()[target.vertex];
      x[target.vertex] = part == 1.0 ? target.position : from + part * (target.position - from);
    }
    const std::vector<Vec3> start = x;
    Objective objective(mesh_, problem_);
    objective.constrain(workers_, mesh_, mesh_.points());
    objective.lagrangian()->reset(workers_, x);
    Multigrid preconditioner(workers_, objective.majoriser(workers_, mesh_.points()),
                             objective.projectors(problem_.motion.start()));
    const Flips flips(objective.layout(), start, problem_.orientation);
    Options options = options_;
    if (options.time_limit_seconds > 0.0) {  // not 0, which would be no limit
      options.time_limit_seconds = std::max(1e-9, options.time_limit_seconds - timer_.seconds());
    }
    Report report;
    descend(workers_, objective, preconditioner, flips, options, x, report);
    return x;
  }

  Workers& workers_;
  const Mesh& mesh_;
  Problem problem_;
  Options options_;
  const Timer timer_;
  bool interrupted_ = false;
  std::vector<Vec3> points_;
  std::vector<char> valid_;  // per cell, in the input
};

}  // namespace

Brought bring_to_targets(Workers& workers, const Mesh& mesh, const Problem& problem,
                         const Options& options) {
  return Way(workers, mesh, problem, options).go();
}

}  // namespace evenmesh
