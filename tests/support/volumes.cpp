// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh::shapes {
namespace {

/// The vertices of one block, in the order of a hex.
using Block = std::array<Index, 8>;

std::vector<Vec3> lattice(int n) {
  std::vector<Vec3> points;
  for (int k = 0; k <= n; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) points.push_back(Vec3(i, j, k) / n);
    }
  }
  return points;
}

template <class Body>
void for_blocks(int n, Body body) {
  const auto at = [n](int i, int j, int k) {
    return static_cast<Index>((k * (n + 1) + j) * (n + 1) + i);
  };
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        body(Block{at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
                   at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1),
                   at(i, j + 1, k + 1)});
      }
    }
  }
}

}  // namespace

Mesh hex_grid(int n, double jitter, std::uint64_t seed) {
  std::vector<Vec3> points = lattice(n);
  Random random(seed);
  for (Vec3& p : points) {
    const bool interior = p.minCoeff() > 0.0 && p.maxCoeff() < 1.0;
    if (!interior || jitter == 0.0) continue;
    for (int axis = 0; axis < 3; ++axis) p[axis] += jitter / n * random.signed_unit();
  }
  Cells cells;
  for_blocks(n, [&](const Block& block) { cells.add(CellKind::hex, block); });
  return Mesh(std::move(points), std::move(cells));
}

Mesh tet_grid(int n) {
  // All six share the diagonal 0-6; the other two vertices are neighbours on the ring around it.
  constexpr std::array<std::size_t, 6> kRing{1, 2, 3, 7, 4, 5};
  Cells cells;
  for_blocks(n, [&](const Block& block) {
    for (std::size_t i = 0; i < 6; ++i) {
      cells.add(CellKind::tet, {{block[0], block[kRing[i]], block[kRing[(i + 1) % 6]], block[6]}});
    }
  });
  return Mesh(lattice(n), std::move(cells));
}

Mesh wedge_grid(int n) {
  Cells cells;
  for_blocks(n, [&](const Block& b) {
    cells.add(CellKind::wedge, {{b[0], b[1], b[2], b[4], b[5], b[6]}});
    cells.add(CellKind::wedge, {{b[0], b[2], b[3], b[4], b[6], b[7]}});
  });
  return Mesh(lattice(n), std::move(cells));
}

Mesh pyramid_grid(int n) {
  std::vector<Vec3> points = lattice(n);
  Cells cells;
  for_blocks(n, [&](const Block& block) {
    const auto apex = static_cast<Index>(points.size());
    points.push_back((points[block[0]] + points[block[6]]) / 2.0);
    for (const CellTraits::Face& face : traits(CellKind::hex).faces) {
      // Counter-clockwise from outside, so clockwise from the apex.
      const auto& f = face.vertices;
      cells.add(CellKind::pyramid, {{block[f[0]], block[f[3]], block[f[2]], block[f[1]], apex}});
    }
  });
  return Mesh(std::move(points), std::move(cells));
}

}  // namespace evenmesh::shapes
