// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/rings.h"

#include <algorithm>

namespace evenmesh {

std::vector<char> with_rings(const Cells& cells, std::vector<char> vertices, int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<char> before = vertices;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto cell = cells.vertices(c);
      if (std::none_of(cell.begin(), cell.end(), [&](Index v) { return before[v] != 0; })) continue;
      for (const Index v : cell) vertices[v] = 1;
    }
  }
  return vertices;
}

}  // namespace evenmesh
