// SPDX-License-Identifier: MIT
#include "evenmesh/io/side_labels.h"

#include <algorithm>
#include <utility>

namespace evenmesh {
namespace {

void sort_and_join(std::vector<Index>& vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

}  // namespace

void SideLabels::add(std::span<const Index> vertices, std::uint32_t label) {
  for (const Index v : vertices) {
    if (v >= label_of_.size()) label_of_.resize(std::size_t{v} + 1 + label_of_.size(), 0);
    if (label_of_[v] == 0) label_of_[v] = label;
    if (label_of_[v] != label) label_of_[v] = kSeveral;
  }
  if (vertices.size() <= 2) {
    for (const Index v : vertices) bounds_.push_back({label, v, v});
    return;
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto [low, high] = std::minmax(vertices[i], vertices[(i + 1) % vertices.size()]);
    bounds_.push_back({label, low, high});
  }
}

std::vector<Index> SideLabels::rims() const {
  std::vector<Index> result;
  for (std::size_t v = 0; v < label_of_.size(); ++v) {
    if (label_of_[v] == kSeveral) result.push_back(static_cast<Index>(v));
  }
  std::vector<std::array<std::uint32_t, 3>> sorted = bounds_;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t next = i;
    while (next < sorted.size() && sorted[next] == sorted[i]) ++next;
    if (next == i + 1) result.insert(result.end(), {sorted[i][1], sorted[i][2]});
    i = next;
  }
  sort_and_join(result);
  return result;
}

std::vector<Index> on_lines_within(const Cells& cells, std::span<const Index> lines) {
  struct Line {
    Index low, high;
    std::uint32_t cells = 0;
    std::uint32_t group = 0;
    bool several_groups = false;
    bool operator<(const Line& other) const {
      return std::pair(low, high) < std::pair(other.low, other.high);
    }
  };
  std::vector<Line> sorted;
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    const auto [low, high] = std::minmax(lines[i], lines[i + 1]);
    sorted.push_back({low, high});
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> on_line;  // per vertex, so that few edges have to be looked for
  for (const Line& line : sorted) {
    if (line.high >= on_line.size()) on_line.resize(std::size_t{line.high} + 1, 0);
    on_line[line.low] = on_line[line.high] = 1;
  }
  for (std::size_t cell = 0; cell < cells.size() && !sorted.empty(); ++cell) {
    const auto corners = cells.vertices(cell);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
      if (high >= on_line.size() || !on_line[low] || !on_line[high]) continue;
      const auto at = std::lower_bound(sorted.begin(), sorted.end(), Line{low, high});
      if (at == sorted.end() || at->low != low || at->high != high) continue;
      if (at->cells++ == 0) at->group = cells.group(cell);
      at->several_groups = at->several_groups || at->group != cells.group(cell);
    }
  }
  std::vector<Index> result;
  for (const Line& line : sorted) {
    if (line.cells == 2 && !line.several_groups) {
      result.insert(result.end(), {line.low, line.high});
    }
  }
  sort_and_join(result);
  return result;
}

std::vector<Index> held_by_groups(const Cells& cells, std::span<const Index> lines,
                                  std::span<const std::uint32_t> labels) {
  const bool volume =
      std::ranges::any_of(cells.kinds(), [](CellKind kind) { return traits(kind).dimension == 3; });
  SideLabels sides;
  if (volume) {
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      const bool is_side = traits(cells.kind(cell)).dimension == 2 && cells.group(cell) != 0;
      if (is_side) sides.add(cells.vertices(cell), cells.group(cell));
    }
    return sides.rims();
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != 0) sides.add(lines.subspan(2 * i, 2), labels[i]);
  }
  std::vector<Index> held = sides.rims();
  const std::vector<Index> within = on_lines_within(cells, lines);
  held.insert(held.end(), within.begin(), within.end());
  sort_and_join(held);
  return held;
}

}  // namespace evenmesh
