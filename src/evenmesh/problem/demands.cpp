// SPDX-License-Identifier: MIT
#include "evenmesh/problem/demands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/core.h>

#include "evenmesh/mesh/measure.h"

namespace evenmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string_view least_size_option(MeshType type) {
  return type == MeshType::volume ? "--min-volume" : "--min-area";
}

void check_length(std::string_view text, const Length& length, Length::Unit unit) {
  if (!(length.value > 0.0) || !std::isfinite(length.value)) {
    fail(text, fmt::format("it must be positive and finite, not {}", length.value));
  }
  if (length.unit == Length::Unit::absolute || length.unit == unit) return;
  fail(text, "it is in a unit that has no meaning for it");
}

void check_limit(const Scene& scene, const TargetList& targets, Index v, double limit,
                 const std::string& text) {
  constexpr double kRounding = 1e-6;
  if (!targets.has(v)) return;
  const double way = targets.displacement(v).norm();
  if (way <= limit * (1.0 + kRounding)) return;
  contradict(text, targets.text(v),
             fmt::format("{} has to move by {:.3g}, but may only by {:.3g}", scene.name_of(v), way,
                         limit));
}

std::vector<double> limits_of_moves(const Scene& scene, const TargetList& targets) {
  if (scene.constraints.move_limits.empty()) return {};
  std::vector<double> limits(scene.points.size(), kInfinity);
  std::vector<double> sides;
  for (const MoveLimit& limit : scene.constraints.move_limits) {
    const bool relative = limit.distance.unit == Length::Unit::of_edges;
    if (relative && sides.empty()) sides = local_edge_lengths(scene.mesh);
    for (Index v = 0; v < limits.size(); ++v) {
      if (!limit.selection.vertices[v]) continue;
      limits[v] = std::min(limits[v], limit.distance.value * (relative ? sides[v] : 1.0));
      check_limit(scene, targets, v, limits[v], limit.selection.text);
    }
  }
  return limits;
}

double greatest_deviation(const Scene& scene) {
  std::optional<Length> deviation = scene.constraints.max_deviation;
  if (!deviation && scene.type == MeshType::surface) {
    deviation = Length{Constraints::kDefaultDeviation, Length::Unit::of_diagonal};
  }
  if (!deviation) return kInfinity;
  const bool relative = deviation->unit == Length::Unit::of_diagonal;
  return deviation->value * (relative ? scene.size : 1.0);
}

// Vertices on tracks that are not figures: those of the input, or of another surface.
std::size_t count_on_free_forms(const Scene& scene, const Arrangement& arrangement) {
  std::size_t number = 0;
  for (Index v = 0; v < scene.points.size(); ++v) {
    if (!arrangement.moves(v) || arrangement.motion.track(v) == nullptr) continue;
    const bool on_figure =
        arrangement.slides(v) && is_figure(scene.constraints.slides[arrangement.slide_of[v]].on);
    if (!on_figure) ++number;
  }
  return number;
}

ConstraintSummary summarize_validity(const Scene& scene, const Validity& validity) {
  const Constraints& constraints = scene.constraints;
  const int dimension = scene.type == MeshType::volume ? 3 : 2;
  const auto kinds = scene.mesh.cells().kinds();
  const auto number = std::count_if(kinds.begin(), kinds.end(), [&](CellKind kind) {
    return traits(kind).dimension == dimension;
  });
  std::string note = "no cell is turned over";
  if (validity.min_size > 0.0) note += fmt::format("; none smaller than {:.4g}", validity.min_size);
  if (validity.min_jacobian > 0.0) {
    note += fmt::format("; none with a Jacobian under {:.4g}", validity.min_jacobian);
  }
  const std::string_view text = constraints.min_jacobian ? "--min-jacobian"
                                : constraints.min_size   ? least_size_option(scene.type)
                                                         : "default";
  return {"validity",        std::string(text),
          Entry::inequality, static_cast<std::size_t>(number),
          "cells",           note};
}

}  // namespace

void check_lengths(const Scene& scene) {
  const Constraints& constraints = scene.constraints;
  for (const MoveLimit& limit : constraints.move_limits) {
    if (limit.distance.value == 0.0) {
      fail(limit.selection.text, "vertices that may not move at all are better fixed (--fix)");
    }
    check_length(limit.selection.text, limit.distance, Length::Unit::of_edges);
  }
  if (const auto& deviation = constraints.max_deviation) {
    check_length("--max-deviation", *deviation, Length::Unit::of_diagonal);
  }
  if (const auto& least = constraints.min_size) {
    check_length(least_size_option(scene.type), *least, Length::Unit::of_mean_size);
  }
  if (const auto& least = constraints.min_jacobian; least && !(*least > 0.0 && *least < 1.0)) {
    fail("--min-jacobian", fmt::format("must lie between 0 and 1, not {}", *least));
  }
}

void demand(const Scene& scene, const Arrangement& arrangement, Problem& problem) {
  problem.max_move = limits_of_moves(scene, arrangement.targets);
  problem.bounds.clear();
  for (const NamedBound& named : scene.constraints.bounds) problem.bounds.push_back(named.bound);
  problem.validity.min_size = 0.0;
  if (const auto& least = scene.constraints.min_size) {
    const bool relative = least->unit == Length::Unit::of_mean_size;
    const double unit = relative ? mean_size(scene.mesh, scene.orientation) : 1.0;
    problem.validity.min_size = least->value * unit;
  }
  problem.validity.min_jacobian = scene.constraints.min_jacobian.value_or(0.0);
  problem.max_deviation = greatest_deviation(scene);
}

std::vector<ConstraintSummary> summarize_demands(const Scene& scene, const Arrangement& arrangement,
                                                 const Problem& problem) {
  std::vector<ConstraintSummary> lines;
  for (const MoveLimit& limit : scene.constraints.move_limits) {
    lines.push_back({"max_move", limit.selection.text, Entry::inequality,
                     count(limit.selection.vertices), "vertices"});
  }
  for (const NamedBound& named : scene.constraints.bounds) {
    lines.push_back({std::string(named.bound.function->name()), named.text,
                     named.bound.is_equation() ? Entry::bordered : Entry::inequality,
                     named.bound.function->vertices().size(), "vertices"});
  }
  const std::size_t number = count_on_free_forms(scene, arrangement);
  if (number > 0 && std::isfinite(problem.max_deviation)) {
    const bool in_place = problem.targets.empty();
    lines.push_back({"max_deviation",
                     scene.constraints.max_deviation ? "--max-deviation" : "default",
                     Entry::inequality, number, "vertices",
                     fmt::format("at most {:.4g} {}", problem.max_deviation,
                                 in_place ? "from the input" : "of where it was brought")});
  }
  if (problem.validity.demanded) lines.push_back(summarize_validity(scene, problem.validity));
  return lines;
}

}  // namespace evenmesh
