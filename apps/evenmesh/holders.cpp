// SPDX-License-Identifier: MIT
#include "apps/evenmesh/holders.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace evenmesh::app {
namespace {

// "is fixed", "slides"; empty for a vertex that goes where it likes.
std::string_view what_it_does(Motion::Freedom freedom, bool planar) {
  switch (freedom) {
    case Motion::Freedom::fixed:
      return "is fixed";
    case Motion::Freedom::line:
      return "slides on a line or curve";
    case Motion::Freedom::plane:
      return planar ? "" : "slides on a plane or surface";
    case Motion::Freedom::free:
      break;
  }
  return "";
}

// Adds to the constraint of a kind what one of its members holds.
void add(HoldingConstraint& constraint, double& greatest, double multiplier, std::string name) {
  if (multiplier == 0.0) return;
  ++constraint.count;
  constraint.multiplier += multiplier;
  if (multiplier <= greatest) return;
  greatest = multiplier;
  constraint.strongest = std::move(name);
}

}  // namespace

std::vector<std::string> Holders::of_cell(std::size_t cell, std::span<const Index> vertices) const {
  std::vector<std::pair<double, std::string>> found;
  for (const ActiveCell& active : holding_.cells) {
    if (active.cell != cell) continue;
    found.emplace_back(
        active.multiplier,
        active.excess > 0.0
            ? fmt::format("its least size is not met (multiplier {:.3g})", active.multiplier)
            : fmt::format("it is at its least size (multiplier {:.3g})", active.multiplier));
  }
  const bool planar = problem_.orientation.type == MeshType::planar;
  for (const Index v : vertices) {
    const double multiplier = holding_.of_vertex[v];
    const std::string_view doing = what_it_does(problem_.motion.freedom(v), planar);
    if (doing.empty() || !(multiplier > 0.0)) continue;
    found.emplace_back(multiplier, fmt::format("{} {} (multiplier {:.3g})", names_.vertex_name(v),
                                               doing, multiplier));
  }
  for (const ActiveBound& active : holding_.moves) {
    if (std::find(vertices.begin(), vertices.end(), active.number) == vertices.end()) continue;
    found.emplace_back(
        active.multiplier,
        fmt::format("{} has gone as far as it may (multiplier {:.3g})",
                    names_.vertex_name(static_cast<Index>(active.number)), active.multiplier));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> result;
  for (auto& [multiplier, text] : found) result.push_back(std::move(text));
  return result;
}

std::vector<HoldingConstraint> Holders::ranked() const {
  const bool planar = problem_.orientation.type == MeshType::planar;
  HoldingConstraint fixed{.kind = "fixed"};
  HoldingConstraint slide{.kind = "slide"};
  double most_fixed = 0.0;
  double most_sliding = 0.0;
  for (Index v = 0; v < holding_.of_vertex.size(); ++v) {
    const Motion::Freedom freedom = problem_.motion.freedom(v);
    if (what_it_does(freedom, planar).empty() || holding_.of_vertex[v] == 0.0f) continue;
    const bool stays = freedom == Motion::Freedom::fixed;
    double& most = stays ? most_fixed : most_sliding;
    const double multiplier = holding_.of_vertex[v];
    add(stays ? fixed : slide, most, multiplier, multiplier > most ? names_.vertex_name(v) : "");
  }
  HoldingConstraint validity{.kind = "validity"};
  double most = 0.0;
  for (const ActiveCell& active : holding_.cells) {
    add(validity, most, active.multiplier,
        active.multiplier > most ? names_.cell_name(active.cell) : "");
  }
  HoldingConstraint moves{.kind = "max_move"};
  most = 0.0;
  for (const ActiveBound& active : holding_.moves) {
    add(moves, most, active.multiplier, names_.vertex_name(static_cast<Index>(active.number)));
  }
  std::vector<HoldingConstraint> result = {fixed, slide, validity, moves};
  for (const ActiveBound& active : holding_.bounds) {
    HoldingConstraint one{.kind = std::string(problem_.bounds[active.number].function->name())};
    most = 0.0;
    add(one, most, std::abs(active.multiplier), one.kind);
    result.push_back(std::move(one));
  }
  std::erase_if(result, [](const HoldingConstraint& c) { return c.count == 0; });
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.multiplier > b.multiplier; });
  return result;
}

}  // namespace evenmesh::app
