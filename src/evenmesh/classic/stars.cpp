// SPDX-License-Identifier: MIT
#include "evenmesh/classic/stars.h"

#include <algorithm>
#include <tuple>

#include "evenmesh/mesh/cell_edges.h"

namespace evenmesh {
namespace {

bool moves(const Motion& motion, Index v) { return motion.freedom(v) != Motion::Freedom::fixed; }

// Turns counts at [v + 1] into where each vertex's items begin.
void add_up(std::vector<std::size_t>& start) {
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
}

}  // namespace

Stars::Stars(const Mesh& mesh, const Motion& motion) {
  gather_links(mesh, motion);
  gather_cells(mesh, motion);
  colour(mesh, motion);
}

void Stars::gather_links(const Mesh& mesh, const Motion& motion) {
  const auto for_links = [&](const auto& body) {
    for_each_cell_edge(mesh.cells(), [&](Index a, Index b) {
      if (motion.leader(a) == motion.leader(b)) return;
      if (moves(motion, a)) body(motion.leader(a), Link{a, b});
      if (moves(motion, b)) body(motion.leader(b), Link{b, a});
    });
  };
  std::vector<std::size_t> start(mesh.point_count() + 1, 0);
  for_links([&](Index v, Link) { ++start[v + 1]; });
  add_up(start);
  std::vector<Link> all(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for_links([&](Index v, Link link) { all[next[v]++] = link; });

  const auto order = [](const Link& a, const Link& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  };
  const auto same = [](const Link& a, const Link& b) { return a.from == b.from && a.to == b.to; };
  link_start_.assign(1, 0);
  for (std::size_t v = 0; v < mesh.point_count(); ++v) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(start[v]);
    const auto last = all.begin() + static_cast<std::ptrdiff_t>(start[v + 1]);
    std::sort(first, last, order);
    links_.insert(links_.end(), first, std::unique(first, last, same));
    link_start_.push_back(links_.size());
  }
}

void Stars::gather_cells(const Mesh& mesh, const Motion& motion) {
  const auto for_corners = [&](const auto& body) {
    for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
      const auto vertices = mesh.cells().vertices(c);
      for (auto v = vertices.begin(); v != vertices.end(); ++v) {
        const bool repeated = std::find(vertices.begin(), v, *v) != v;
        if (moves(motion, *v) && !repeated) body(c, *v);
      }
    }
  };
  cell_start_.assign(mesh.point_count() + 1, 0);
  for_corners([&](std::size_t, Index v) { ++cell_start_[motion.leader(v) + 1]; });
  add_up(cell_start_);
  cells_.resize(cell_start_.back());
  std::vector<std::size_t> next(cell_start_.begin(), cell_start_.end() - 1);
  for_corners([&](std::size_t c, Index v) {
    cells_[next[motion.leader(v)]++] = {static_cast<std::uint32_t>(c), v};
  });
}

// Greedy: the least colour that no vertex with a common cell has.
void Stars::colour(const Mesh& mesh, const Motion& motion) {
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::uint32_t> colour_of(mesh.point_count(), kNone);
  std::vector<Index> seen_by;  // per colour: the last vertex that may not have it
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (!moves(motion, v) || motion.leader(v) != v) continue;
    for (const StarCell& around : of(v).cells) {
      for (const Index u : mesh.cells().vertices(around.cell)) {
        const std::uint32_t taken = colour_of[motion.leader(u)];
        if (taken != kNone) seen_by[taken] = v;
      }
    }
    std::uint32_t own = 0;
    while (own < seen_by.size() && seen_by[own] == v) ++own;
    if (own == seen_by.size()) {
      seen_by.push_back(static_cast<Index>(mesh.point_count()));
      colours_.emplace_back();
    }
    colour_of[v] = own;
    colours_[own].push_back(v);
  }
}

}  // namespace evenmesh
