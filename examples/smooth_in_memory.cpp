// SPDX-License-Identifier: MIT
//
// Smooths a mesh that is already in memory: the whole use of the library.
#include <cstdio>

#include "evenmesh/solver/smooth.h"

int main() {
  using namespace evenmesh;

  // Four triangles around a vertex that is far from the middle.
  Cells cells;
  for (Index i = 0; i < 4; ++i) {
    cells.add(CellKind::triangle, std::array<Index, 3>{i, (i + 1) % 4, 4});
  }
  Mesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.8, 0.3, 0}}, std::move(cells));

  const std::vector<char> fixed{1, 1, 1, 1, 0};
  const Problem problem = make_problem(mesh, find_orientation(mesh), fixed);
  const Report report = smooth(mesh, problem);

  const Vec3 middle = mesh.points()[4];
  std::printf("%s after %zu iterations; the middle is at (%.6f, %.6f)\n", name(report.stop).data(),
              report.history.size() - 1, middle.x(), middle.y());
  return (middle - Vec3(0.5, 0.5, 0)).norm() < 1e-6 ? 0 : 1;
}
