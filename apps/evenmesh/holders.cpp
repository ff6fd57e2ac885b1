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

// What is active for a cell or vertex, in a list sorted by its number; null if nothing is.
template <typename Active, typename Number>
const Active* find(const std::vector<Active>& sorted, Number Active::*number, std::size_t wanted) {
  const auto found = std::ranges::lower_bound(sorted, wanted, {}, number);
  return found != sorted.end() && (*found).*number == wanted ? &*found : nullptr;
}

}  // namespace

std::vector<std::string> Holders::of_cell(std::size_t cell, std::span<const Index> vertices) const {
  std::vector<std::pair<double, std::string>> found;
  const auto note = [&found](double multiplier, std::string_view what) {
    found.emplace_back(multiplier, fmt::format("{} (multiplier {:.3g})", what, multiplier));
  };
  if (const ActiveCell* active = find(holding_.cells, &ActiveCell::cell, cell)) {
    note(active->multiplier,
         active->excess > 0.0 ? "its least size is not met" : "it is at its least size");
  }
  const bool planar = problem_.orientation.type == MeshType::planar;
  for (const Index v : vertices) {
    const double multiplier = holding_.of_vertex.empty() ? 0.0 : holding_.of_vertex[v];
    const std::string_view doing = what_it_does(problem_.motion.freedom(v), planar);
    if (!doing.empty() && multiplier > 0.0) {
      note(multiplier, fmt::format("{} {}", names_.vertex_name(v), doing));
    }
    if (const ActiveBound* active = find(holding_.moves, &ActiveBound::number, v)) {
      note(active->multiplier, fmt::format("{} has gone as far as it may", names_.vertex_name(v)));
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> result;
  for (auto& [multiplier, text] : found) result.push_back(std::move(text));
  const auto stays = [&](Index v) { return problem_.motion.freedom(v) == Motion::Freedom::fixed; };
  // Such a cell is in no optimisation, and where nothing moves there was none.
  if (result.empty() && std::ranges::all_of(vertices, stays)) {
    result.push_back("all its vertices are fixed");
  }
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
