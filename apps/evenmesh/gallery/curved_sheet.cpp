// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "apps/evenmesh/gallery/grid.h"
#include "apps/evenmesh/gallery/meshes.h"
#include "apps/evenmesh/gallery/random.h"

namespace evenmesh::gallery {
namespace {

constexpr double kHalfLength = 1.1;  // of the sheet seen from above
constexpr double kHalfWidth = 0.9;

// The triangles of a quad, cut so that none has both its sides on the boundary.
void add_triangles(const Grid& grid, int i, int j, Cells& cells) {
  const std::array<Index, 4> q = grid.quad(i, j);
  const bool left_low = (i == 0) == (j == 0);
  const bool corner = (i == 0 || i == grid.columns - 1) && (j == 0 || j == grid.rows - 1);
  const bool rising = corner ? left_low : (i + j) % 2 == 0;
  if (rising) {
    cells.add(CellKind::triangle, std::array<Index, 3>{q[0], q[1], q[2]});
    cells.add(CellKind::triangle, std::array<Index, 3>{q[0], q[2], q[3]});
  } else {
    cells.add(CellKind::triangle, std::array<Index, 3>{q[0], q[1], q[3]});
    cells.add(CellKind::triangle, std::array<Index, 3>{q[1], q[2], q[3]});
  }
}

}  // namespace

Mesh curved_sheet() {
  constexpr double kJitter = 0.3;
  const Grid grid{11, 9};
  const Vec3 h(2.0 * kHalfLength / grid.columns, 2.0 * kHalfWidth / grid.rows, 0.0);
  Random random(28);
  auto points = grid.points([&](int i, int j) {
    Vec3 p(i * h.x() - kHalfLength, j * h.y() - kHalfWidth, 0.0);
    if (!grid.on_boundary(i, j)) p += kJitter * h.cwiseProduct(random.in_square());
    p.z() = std::sqrt(kSheetRadius * kSheetRadius - p.squaredNorm());
    return p;
  });
  Cells cells;
  for (int j = 0; j < grid.rows; ++j) {
    for (int i = 0; i < grid.columns; ++i) {
      if (i == 0 || j == 0 || i == grid.columns - 1 || j == grid.rows - 1) {
        add_triangles(grid, i, j, cells);
      } else {
        cells.add(CellKind::quad, grid.quad(i, j));
      }
    }
  }
  return Mesh(std::move(points), std::move(cells));
}

}  // namespace evenmesh::gallery
