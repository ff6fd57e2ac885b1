// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/ordering.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace evenmesh {
namespace {

// Vertices whose numbers differ by less than this share cache lines of the second level.
constexpr Index kNear = 8192;

// Points that are closer together than this count as one place.
constexpr double kLeastSize = std::numeric_limits<double>::min();

// Connectivity alone, in any numbering.
struct Graph {
  std::vector<Offset> start;  // corners of cell c: [start[c], start[c + 1])
  std::vector<Index> corners;

  std::size_t cells() const { return start.size() - 1; }
  std::span<const Index> cell(std::size_t c) const {
    return {corners.data() + start[c], corners.data() + start[c + 1]};
  }
};

// The lower 21 bits, each moved to three times its place.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

std::vector<Index> along_a_space_filling_curve(Points points) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // Halves, because the difference of two large numbers may be infinite.
  const double half = std::max((high / 2.0 - low / 2.0).maxCoeff(), kLeastSize);
  std::vector<std::pair<std::uint64_t, Index>> keys(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Vec3 unit = (points[v] / 2.0 - low / 2.0) / half;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double scaled = std::clamp(unit[axis], 0.0, 1.0) * 0x1fffff;
      key |= spread_bits(static_cast<std::uint64_t>(scaled)) << axis;
    }
    keys[v] = {key, static_cast<Index>(v)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Index> order(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = keys[k].second;
  return order;
}

std::vector<Index> inverse(std::span<const Index> order) {
  std::vector<Index> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<Index>(k);
  return number;
}

// Cells by their least vertex in a numbering: a counting sort.
std::vector<std::uint32_t> sort_cells(const Cells& cells, std::span<const Index> number) {
  std::vector<Index> least(cells.size());
  std::vector<std::uint32_t> next(number.size() + 1, 0);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Index low = ~Index{0};
    for (const Index v : cells.vertices(c)) low = std::min(low, number[v]);
    least[c] = low;
    ++next[low + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> order(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    order[next[least[c]]++] = static_cast<std::uint32_t>(c);
  }
  return order;
}

Graph renumbered(const Cells& cells, std::span<const Index> number) {
  Graph graph;
  graph.start.reserve(cells.size() + 1);
  graph.start.push_back(0);
  graph.corners.reserve(cells.corners().size());
  for (const std::uint32_t c : sort_cells(cells, number)) {
    for (const Index v : cells.vertices(c)) graph.corners.push_back(number[v]);
    graph.start.push_back(graph.corners.size());
  }
  return graph;
}

// For every vertex the cells that use it.
struct Incidence {
  std::vector<Offset> start;
  std::vector<std::uint32_t> cells;

  Incidence(const Graph& graph, std::size_t points)
      : start(points + 1, 0), cells(graph.corners.size()) {
    for (const Index v : graph.corners) ++start[v + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<Offset> next(start.begin(), start.end() - 1);
    for (std::size_t c = 0; c < graph.cells(); ++c) {
      for (const Index v : graph.cell(c)) cells[next[v]++] = static_cast<std::uint32_t>(c);
    }
  }

  bool is_used(std::size_t v) const { return start[v] != start[v + 1]; }
};

// Appends to `order` what can be reached from `seed`, nearest first.
void visit_from(Index seed, const Graph& graph, const Incidence& incidence, std::vector<char>& seen,
                std::vector<Index>& order) {
  std::size_t head = order.size();
  order.push_back(seed);
  seen[seed] = 1;
  for (; head < order.size(); ++head) {
    const Index v = order[head];
    for (Offset i = incidence.start[v]; i < incidence.start[v + 1]; ++i) {
      for (const Index neighbour : graph.cell(incidence.cells[i])) {
        if (seen[neighbour]) continue;
        seen[neighbour] = 1;
        order.push_back(neighbour);
      }
    }
  }
}

std::vector<Index> breadth_first(const Graph& graph, std::size_t points) {
  const Incidence incidence(graph, points);
  std::vector<char> seen(points, 0);
  std::vector<Index> order;
  order.reserve(points);
  // The first unseen vertex is at the low end of the space-filling curve: a corner of its piece,
  // from where the fronts are short.
  for (std::size_t v = 0; v < points; ++v) {
    if (seen[v] || !incidence.is_used(v)) continue;
    visit_from(static_cast<Index>(v), graph, incidence, seen, order);
  }
  for (std::size_t v = 0; v < points; ++v) {
    if (!seen[v]) order.push_back(static_cast<Index>(v));
  }
  return order;
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

Ordering breadth_first_order(const Mesh& mesh) {
  const std::vector<Index> curve = along_a_space_filling_curve(mesh.points());
  Ordering result;
  {
    const Graph graph = renumbered(mesh.cells(), inverse(curve));
    result.vertices = breadth_first(graph, mesh.point_count());
  }
  for (Index& v : result.vertices) v = curve[v];
  result.cells = sort_cells(mesh.cells(), inverse(result.vertices));
  return result;
}

}  // namespace evenmesh
