// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>

#include "evenmesh/mesh/mesh.h"

int main() {
  evenmesh::Cells cells;
  cells.add(evenmesh::CellKind::triangle, std::array<evenmesh::Index, 3>{0, 1, 2});
  const evenmesh::Mesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, cells);
  std::printf("%zu points, %zu cells\n", mesh.point_count(), mesh.cells().size());
  return mesh.point_count() == 3 && mesh.cells().size() == 1 ? 0 : 1;
}
