// SPDX-License-Identifier: MIT
#include "evenmesh/problem/problem.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include "evenmesh/base/error.h"
#include "evenmesh/cost/barycenter.h"
#include "evenmesh/cost/global.h"
#include "evenmesh/cost/local.h"
#include "evenmesh/cost/shape.h"
#include "evenmesh/geometry/parity_sets.h"
#include "evenmesh/mesh/measure.h"
#include "evenmesh/problem/constraints.h"

namespace evenmesh {
namespace {

// What a cost may want to know about the mesh when it is made.
struct Setting {
  const Mesh& mesh;
  const Orientation& orientation;
  const ProblemOptions& options;
};

// A mesh of which more than one cell in a hundred is turned over is tangled, its edges too long.
double default_global_length(const Setting& in) {
  const Cells& cells = in.mesh.cells();
  const int dimension = in.orientation.type == MeshType::volume ? 3 : 2;
  std::size_t judged = 0;
  std::size_t inverted = 0;
  for (std::size_t c = 0; c < cells.size() && in.orientation.type != MeshType::surface; ++c) {
    if (traits(cells.kind(c)).dimension != dimension) continue;
    ++judged;
    if (oriented_size(in.mesh, in.orientation, c) <= 0.0) ++inverted;
  }
  return inverted * 100 > judged ? length_from_size(in.mesh, in.orientation)
                                 : mean_edge_length(in.mesh);
}

struct Registered {
  const char* name;
  std::shared_ptr<const Cost> (*make)(const Setting&);
};

// A new cost is one line here.
constexpr Registered kCosts[] = {
    {"local",
     [](const Setting& in) -> std::shared_ptr<const Cost> {
       return std::make_shared<Local>(in.options.scaling);
     }},
    {"global",
     [](const Setting& in) -> std::shared_ptr<const Cost> {
       const double given = in.options.global_length;
       return std::make_shared<Global>(given != 0.0 ? given : default_global_length(in),
                                       in.options.scaling);
     }},
    {"barycenter",
     [](const Setting& in) -> std::shared_ptr<const Cost> {
       return std::make_shared<Barycenter>(in.options.scaling);
     }},
    {"shape",
     [](const Setting&) -> std::shared_ptr<const Cost> { return std::make_shared<Shape>(); }},
};

std::vector<CostChoice> edge_costs(const Mesh& mesh) {
  const auto kinds = mesh.cells().kinds();
  const bool stiff = std::all_of(kinds.begin(), kinds.end(), [](CellKind kind) {
    return kind == CellKind::triangle || kind == CellKind::tet;
  });
  if (stiff) return {{"local", 1.0}};
  return {{"local", 0.3}, {"barycenter", 0.3}};
}

Term make_term(const CostChoice& choice, const Setting& setting) {
  const auto known = std::find_if(std::begin(kCosts), std::end(kCosts),
                                  [&](const Registered& r) { return r.name == choice.name; });
  if (known == std::end(kCosts)) {
    throw InvalidOption(fmt::format("there is no cost named '{}'; known are {}", choice.name,
                                    fmt::join(cost_names(), ", ")));
  }
  if (!(choice.weight > 0.0) || !std::isfinite(choice.weight)) {
    throw InvalidOption(fmt::format("the weight of the cost {} must be positive, not {}",
                                    choice.name, choice.weight));
  }
  return {choice.weight, known->make(setting)};
}

// Whether there is a place that all vertices of a piece may move to: the least-squares solution of
// P_v (x - p_v) = 0, where P_v projects on what vertex v may not follow.
class CommonPoint {
 public:
  void add(const Motion& motion, Index v, const Vec3& p) {
    if (motion.freedom(v) == Motion::Freedom::free) return;
    if (!origin_) origin_ = p;
    const Vec3 at = p - *origin_;
    Eigen::Matrix3d barred;
    for (int i = 0; i < 3; ++i) barred.col(i) = Vec3::Unit(i) - motion.project(v, Vec3::Unit(i));
    matrix_ += barred;
    right_ += barred * at;
    square_ += at.dot(barred * at);
    size_ = std::max(size_, at.norm());
  }

  bool exists() const {
    constexpr double kRank = 1e-9;
    constexpr double kRounding = 1e-9;  // of sums over many vertices
    if (!(size_ > 0.0)) return true;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrix_);
    const Vec3 rotated = eigen.eigenvectors().transpose() * right_;
    double residual = square_;
    for (int i = 0; i < 3; ++i) {
      const double value = eigen.eigenvalues()[i];
      if (value > kRank * matrix_.trace()) residual -= rotated[i] * rotated[i] / value;
    }
    return !(residual > kRounding * size_ * size_);
  }

 private:
  std::optional<Vec3> origin_;
  Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Zero();
  Vec3 right_ = Vec3::Zero();
  double square_ = 0.0;
  double size_ = 0.0;
};

}  // namespace

std::vector<std::string> cost_names() {
  std::vector<std::string> names;
  for (const Registered& cost : kCosts) names.emplace_back(cost.name);
  return names;
}

void add_costs(const Mesh& mesh, const ProblemOptions& options, Problem& problem) {
  if (problem.motion.moving() > 0) {
    const Setting setting{mesh, problem.orientation, options};
    const auto choices =
        options.costs.empty() ? std::vector<CostChoice>{{"shape", 1.0}} : options.costs;
    for (const CostChoice& choice : choices) problem.terms.push_back(make_term(choice, setting));
  }
  check_for_collapse(mesh, problem);
}

std::vector<Term> untangling_terms(const Mesh& mesh, const Problem& problem) {
  ProblemOptions options;
  if (find_loose_vertex(mesh, problem)) options.scaling = Scaling::scale_free;
  const Setting setting{mesh, problem.orientation, options};
  std::vector<Term> terms;
  for (const CostChoice& choice : edge_costs(mesh)) terms.push_back(make_term(choice, setting));
  return terms;
}

Problem make_problem(const Mesh& mesh, Orientation orientation, std::span<const char> fixed,
                     const ProblemOptions& options) {
  Problem problem;
  problem.orientation = std::move(orientation);
  Constraints constraints;
  constraints.fixed = Selection{"fixed", {fixed.begin(), fixed.end()}};
  // Only what slides on the surface has to know its edges.
  const bool slides = problem.orientation.type == MeshType::surface;
  apply(mesh, slides ? find_topology(mesh, problem.orientation) : Topology{}, constraints, problem);
  add_costs(mesh, options, problem);
  return problem;
}

std::optional<Index> find_loose_vertex(const Mesh& mesh, const Problem& problem) {
  if (problem.orientation.type == MeshType::surface) return {};
  ParitySets pieces(mesh.point_count());
  const Cells& cells = mesh.cells();
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const Index v : cells.vertices(c)) pieces.unite(cells.vertices(c)[0], v, false);
  }
  // By vertices rather than by cells: in their order, and each once. One that no cell uses is a
  // piece of its own, and fixed.
  std::vector<CommonPoint> common(mesh.point_count());  // per piece
  for (Index v = 0; v < mesh.point_count(); ++v) {
    common[pieces.find(v).root].add(problem.motion, v, mesh.points()[v]);
  }
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (problem.motion.freedom(v) == Motion::Freedom::fixed) continue;
    if (common[pieces.find(v).root].exists()) return v;
  }
  return {};
}

void check_for_collapse(const Mesh& mesh, const Problem& problem) {
  const bool all_can = std::all_of(problem.terms.begin(), problem.terms.end(),
                                   [](const Term& term) { return term.cost->can_collapse(); });
  if (!all_can || problem.validity.min_size > 0.0 || !problem.bounds.empty()) return;
  if (const std::optional<Index> v = find_loose_vertex(mesh, problem)) {
    throw InvalidOption(fmt::format(
        "nothing keeps the piece of the mesh around vertex {} from shrinking to a point: its "
        "costs are least at size 0 and all its vertices may move to one place; fix some (--fix "
        "boundary), "
        "add the cost global, or make the costs scale-free (--scale-free)",
        *v));
  }
}

}  // namespace evenmesh
