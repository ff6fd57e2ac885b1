// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/ordering.h"

#include <algorithm>

namespace evenmesh {
namespace {

// Vertices whose numbers differ by less than this share cache lines of the second level.
constexpr Index kNear = 8192;

// For every vertex the cells that use it.
struct Incidence {
  std::vector<Offset> start;
  std::vector<std::uint32_t> cells;
};

Incidence cells_of_vertices(const Cells& cells, std::size_t points) {
  Incidence incidence;
  incidence.start.assign(points + 1, 0);
  for (const Index v : cells.corners()) ++incidence.start[v + 1];
  for (std::size_t v = 0; v < points; ++v) incidence.start[v + 1] += incidence.start[v];
  incidence.cells.resize(cells.corners().size());
  std::vector<Offset> next(incidence.start.begin(), incidence.start.end() - 1);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const Index v : cells.vertices(c)) {
      incidence.cells[next[v]++] = static_cast<std::uint32_t>(c);
    }
  }
  return incidence;
}

// Appends to `order` what can be reached from `seed`, nearest first.
void visit_from(Index seed, const Cells& cells, const Incidence& incidence, std::vector<char>& seen,
                std::vector<Index>& order) {
  std::size_t head = order.size();
  order.push_back(seed);
  seen[seed] = 1;
  for (; head < order.size(); ++head) {
    const Index v = order[head];
    for (Offset i = incidence.start[v]; i < incidence.start[v + 1]; ++i) {
      for (const Index neighbour : cells.vertices(incidence.cells[i])) {
        if (seen[neighbour]) continue;
        seen[neighbour] = 1;
        order.push_back(neighbour);
      }
    }
  }
}

}  // namespace

bool has_good_order(const Cells& cells) {
  std::size_t far = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto cell = cells.vertices(c);
    const auto [least, greatest] = std::minmax_element(cell.begin(), cell.end());
    if (*greatest - *least >= kNear) ++far;
  }
  return far * 20 <= cells.size();
}

std::vector<Index> breadth_first_order(const Cells& cells, std::size_t points) {
  const Incidence incidence = cells_of_vertices(cells, points);
  std::vector<char> seen(points, 0);
  std::vector<Index> order;
  order.reserve(points);
  for (std::size_t v = 0; v < points; ++v) {
    if (seen[v] || incidence.start[v] == incidence.start[v + 1]) continue;
    // The vertex reached last is an outermost one; starting there makes the fronts short.
    const std::size_t first = order.size();
    visit_from(static_cast<Index>(v), cells, incidence, seen, order);
    const Index outermost = order.back();
    for (std::size_t k = first; k < order.size(); ++k) seen[order[k]] = 0;
    order.resize(first);
    visit_from(outermost, cells, incidence, seen, order);
  }
  for (std::size_t v = 0; v < points; ++v) {
    if (!seen[v]) order.push_back(static_cast<Index>(v));
  }
  return order;
}

}  // namespace evenmesh
