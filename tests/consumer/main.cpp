// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>

#include "evenmesh/solver/smooth.h"

int main() {
  using namespace evenmesh;
  Cells cells;
  for (Index i = 0; i < 4; ++i) {
    cells.add(CellKind::triangle, std::array<Index, 3>{i, (i + 1) % 4, 4});
  }
  Mesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.8, 0.3, 0}}, std::move(cells));
  const Problem problem =
      make_problem(mesh, find_orientation(mesh), std::vector<char>{1, 1, 1, 1, 0});
  const Report report = smooth(mesh, problem);
  std::printf("%s\n", name(report.stop).data());
  return (mesh.points()[4] - Vec3(0.5, 0.5, 0)).norm() < 1e-6 ? 0 : 1;
}
