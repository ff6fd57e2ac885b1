// SPDX-License-Identifier: MIT
#include "evenmesh/report/grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "evenmesh/mesh/cell_edges.h"

namespace evenmesh {
namespace {

constexpr double kMostPlaces = 268435456.0;  // 2^28: differences fit into 32 bits with their signs

// 0 where there is none.
double short_edge(const Cells& cells, Points points) {
  std::vector<double> lengths;
  for_each_cell_edge(cells, [&](Index a, Index b) {
    const double length = (points[a] - points[b]).stableNorm();
    if (length > 0.0) lengths.push_back(length);
  });
  if (lengths.empty()) return 0.0;
  const auto place = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 100);
  std::nth_element(lengths.begin(), place, lengths.end());
  return *place;
}

}  // namespace

std::array<std::int64_t, 3> Grid::place(const Vec3& position) const {
  std::array<std::int64_t, 3> result{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<int>(axis);
    result[axis] = std::llround(position[i] / step - origin[i] / step);
  }
  return result;
}

Grid choose_grid(const Cells& cells, std::span<const Points> states,
                 std::span<const Index> vertices, const Fineness& fineness) {
  if (vertices.empty()) return {};
  Vec3 low = states[0][vertices[0]];
  Vec3 high = low;
  for (const Points state : states) {
    for (const Index v : vertices) {
      low = low.cwiseMin(state[v]);
      high = high.cwiseMax(state[v]);
    }
  }
  // Halves: the difference of two large numbers may be infinite.
  const double half = (high / 2.0 - low / 2.0).maxCoeff();
  if (!(half > 0.0)) return {low, 1.0};
  const double of_box = half / (fineness.steps_per_box / 2.0);
  const double edge = short_edge(cells, states[0]) / fineness.steps_per_edge;
  const double wanted = edge > 0.0 ? std::min(edge, of_box) : of_box;
  return {low, std::max(wanted, half / (kMostPlaces / 2.0))};
}

}  // namespace evenmesh
