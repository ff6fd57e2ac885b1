// SPDX-License-Identifier: MIT
#include "apps/evenmesh/gallery/run.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <memory>

#include "evenmesh/constraint/keep.h"
#include "evenmesh/cost/barycenter.h"
#include "evenmesh/cost/global.h"
#include "evenmesh/cost/local.h"
#include "evenmesh/geometry/analytic_tracks.h"
#include "evenmesh/mesh/measure.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/problem/constraints.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh::gallery {
namespace {

// An eps near the resolution of doubles.
constexpr double kToTheEnd = 1e-16;

bool is_cured(Way way) { return way == Way::cured_dense || way == Way::cured_evenmesh; }

const Setup& setup_of(const Case& of, Way way) {
  assert(!is_cured(way) || !of.cure.costs.empty());
  return is_cured(way) ? of.cure : of.setup;
}

// Unlike add_costs(), also where nothing keeps the mesh from collapsing: the paper's figures show
// just that. L is from the area if the mesh is tangled.
void add_terms(const Setup& setup, const Mesh& mesh, bool tangled, Problem& problem) {
  const Scaling scaling = setup.scale_free ? Scaling::scale_free : Scaling::absolute;
  for (const CostChoice& choice : setup.costs) {
    std::shared_ptr<const Cost> cost;
    if (choice.name == "local") cost = std::make_shared<Local>(scaling);
    if (choice.name == "barycenter") cost = std::make_shared<Barycenter>(scaling);
    if (choice.name == "global") {
      cost = std::make_shared<Global>(
          tangled ? length_from_size(mesh, problem.orientation) : mean_edge_length(mesh), scaling);
    }
    assert(cost != nullptr);
    problem.terms.push_back({choice.weight, std::move(cost)});
  }
}

// Which vertices may go where.
void hold(const Case& of, Way way, const Mesh& mesh, Problem& problem) {
  const Topology topology = find_topology(mesh, problem.orientation);
  const bool on_sheet = of.start == Start::fig28 && way != Way::paper;
  Constraints constraints;
  constraints.fixed = Selection{"boundary", topology.boundary};
  if (setup_of(of, way).held == Held::nothing) {
    constraints.fixed = Selection{"none", std::vector<char>(mesh.point_count(), 0)};
  }
  if (on_sheet) {
    std::vector<char> inside;
    for (const char is_boundary : topology.boundary) inside.push_back(!is_boundary);
    constraints.slides.push_back({{"inside", inside},
                                  SlideOn::sphere,
                                  std::make_shared<SphereTrack>(Vec3(Vec3::Zero()), kSheetRadius)});
  }
  apply(mesh, topology, constraints, problem);
  if (of.start == Start::fig28 && !on_sheet) {
    // Free in space, which surface meshes are not by themselves, but volume meshes are.
    Orientation in_space;
    in_space.type = MeshType::volume;
    problem.motion = Motion(mesh, in_space, topology.boundary);
  }
}

Options options_of(const Case& of, Way way) {
  constexpr int kEnough = 2000;
  Options options;
  options.threads = 1;
  options.max_iterations = kEnough;
  if (way == Way::evenmesh || way == Way::cured_evenmesh) return options;
  options.solver = SolverKind::dense;
  if (way == Way::paper) {
    options.judge = Judge::nothing;
    options.eta = of.eps;
    // Of an exact mesh the count is the question, of the others the budget.
    if (!plate_of(of.start).exact && of.paper_iterations > 0) {
      options.max_iterations = of.paper_iterations;
    }
  } else {
    options.judge = Judge::inversion;
  }
  return options;
}

double total_size(const Mesh& mesh, const Orientation& orientation) {
  double sum = 0.0;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    sum += oriented_size(mesh, orientation, c);
  }
  return sum;
}

double farthest(Points a, Points b) {
  double most = 0.0;
  for (std::size_t v = 0; v < std::min(a.size(), b.size()); ++v) {
    most = std::max(most, (a[v] - b[v]).norm());
  }
  return most;
}

}  // namespace

std::string_view name(Way way) {
  constexpr std::array<std::string_view, 5> kNames{"paper's method", "with validity", "evenmesh",
                                                   "cure", "cure, evenmesh"};
  return kNames[static_cast<std::size_t>(way)];
}

Problem problem_of(const Case& of, Way way, const Mesh& mesh) {
  const Setup& setup = setup_of(of, way);
  Problem problem;
  problem.orientation = find_orientation(mesh);
  hold(of, way, mesh, problem);
  problem.validity.demanded = way != Way::paper;
  if (setup.keep_area) {
    problem.bounds.push_back(make_keep(mesh, problem.orientation, Keep::area));
  }
  add_terms(setup, mesh, of.tangled, problem);
  return problem;
}

Result run(const Case& of, Way way, const Mesh& mesh) {
  const Problem problem = problem_of(of, way, mesh);
  Mesh after = mesh;
  Result result;
  result.way = way;
  result.report = smooth(after, problem, options_of(of, way));
  result.points.assign(after.points().begin(), after.points().end());
  result.cost = result.report.cost_after;
  result.size = total_size(after, problem.orientation) / total_size(mesh, problem.orientation);
  result.error = farthest(after.points(), known_optimum(of));
  if (of.start == Start::fig28) {
    for (const Vec3& p : after.points()) {
      result.departure = std::max(result.departure, std::abs(p.norm() - kSheetRadius));
    }
  }
  return result;
}

std::vector<Result> run_all_ways(const Case& of) {
  const Mesh mesh = start_mesh(of);
  std::vector<Way> ways{Way::paper, Way::dense, Way::evenmesh};
  if (!of.cure.costs.empty()) ways.insert(ways.end(), {Way::cured_dense, Way::cured_evenmesh});
  std::vector<Result> results;
  for (const Way way : ways) results.push_back(run(of, way, mesh));
  return results;
}

Medians run_random_starts(const Case& of, Way way) {
  Case to_the_end = of;
  to_the_end.eps = kToTheEnd;
  std::vector<int> iterations;
  Medians medians;
  for (std::uint64_t seed = 1; seed <= kStarts; ++seed) {
    const KnownMesh mesh = known_mesh(of.start, seed);
    const Result result = run(of, way, mesh.start);
    iterations.push_back(result.iterations());
    medians.error_at_stop = std::max(medians.error_at_stop, result.error);
    medians.inverted += result.inverted();
    medians.error_at_end = std::max(medians.error_at_end, run(to_the_end, way, mesh.start).error);
  }
  std::sort(iterations.begin(), iterations.end());
  medians.least = iterations.front();
  medians.most = iterations.back();
  medians.median = 0.5 * (iterations[(kStarts - 1) / 2] + iterations[kStarts / 2]);
  return medians;
}

}  // namespace evenmesh::gallery
