// SPDX-License-Identifier: MIT
#include "evenmesh/solver/flips.h"

#include <algorithm>

#include "evenmesh/mesh/measure.h"

namespace evenmesh {

std::vector<Index> Flips::find(Workers& workers, Points x, Points x_new) const {
  std::vector<std::vector<Index>> found(layout_.chunks());
  layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
    const CellKind kind = block.cells.kind;
    const int n = block.cells.vertices_per_cell;
    const bool surface = traits(kind).dimension == 2;
    for (std::size_t i = 0; i < block.cells.size(); ++i) {
      const auto cell = block.cells.cell(i);
      const std::uint32_t number = block.numbers[i];
      const Vec3 up = orientation_.up(number);
      if (surface && up.isZero()) continue;
      const double sign = orientation_.sign(number);
      const auto least = [&](const auto& position) {
        return least_corner(kind, n, position, up, sign);
      };
      const double after = least([&](int k) -> const Vec3& { return x_new[cell[k]]; });
      if (after > 0.0) continue;
      const double before = least([&](int k) -> const Vec3& { return x[cell[k]]; });
      if (before <= 0.0) {
        const auto original = mesh_.cells().vertices(number);
        const auto at = [&](int k) -> const Vec3& { return mesh_.points()[original[k]]; };
        if (after >= std::min(before, least(at))) continue;
      }
      found[chunk].insert(found[chunk].end(), cell.begin(), cell.end());
    }
  });
  std::vector<Index> vertices;
  for (const auto& part : found) vertices.insert(vertices.end(), part.begin(), part.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace evenmesh
