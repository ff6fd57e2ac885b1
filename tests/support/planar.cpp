// SPDX-License-Identifier: MIT
#include <array>
#include <cassert>
#include <cmath>

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh::shapes {
namespace {

/// (n + 1)^2 points row by row, the interior ones displaced.
std::vector<Vec3> grid_points(int n, double size, double jitter, std::uint64_t seed) {
  assert(n >= 1);
  Random random(seed);
  const double h = size / n;
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(n + 1) * static_cast<std::size_t>(n + 1));
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      // size * i / n rather than i * h: the far side must be exactly straight.
      Vec3 p(size * i / n, size * j / n, 0.0);
      const bool interior = i > 0 && i < n && j > 0 && j < n;
      if (interior && jitter != 0.0) {
        p.x() += jitter * h * random.signed_unit();
        p.y() += jitter * h * random.signed_unit();
      }
      points.push_back(p);
    }
  }
  return points;
}

void add_grid_triangles(Cells& cells, int n, Index first) {
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Index a = first + static_cast<Index>(j * (n + 1) + i);
      const Index b = a + 1;
      const Index d = a + static_cast<Index>(n + 1);
      const Index c = d + 1;
      if ((i + j) % 2 == 0) {
        cells.add(CellKind::triangle, {{a, b, c}});
        cells.add(CellKind::triangle, {{a, c, d}});
      } else {
        cells.add(CellKind::triangle, {{a, b, d}});
        cells.add(CellKind::triangle, {{b, c, d}});
      }
    }
  }
}

}  // namespace

Mesh fig5(double dx, double dy) {
  Cells cells;
  for (Index v = 0; v < 4; ++v) cells.add(CellKind::triangle, {{v, (v + 1) % 4, 4}});
  return Mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5 + dx, 0.5 + dy, 0}},
              std::move(cells));
}

Mesh quad_grid(int n, double size, double jitter, std::uint64_t seed) {
  Cells cells;
  const auto count = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  cells.reserve(count, 4 * count);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<Index>(j * (n + 1) + i);
      const auto d = a + static_cast<Index>(n + 1);
      cells.add(CellKind::quad, {{a, a + 1, d + 1, d}});
    }
  }
  return Mesh(grid_points(n, size, jitter, seed), std::move(cells));
}

Mesh triangle_grid(int n, double size, double jitter, std::uint64_t seed) {
  Cells cells;
  const auto count = 2 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  cells.reserve(count, 3 * count);
  add_grid_triangles(cells, n, 0);
  return Mesh(grid_points(n, size, jitter, seed), std::move(cells));
}

Mesh two_components(int n) {
  std::vector<Vec3> points = grid_points(n, 1.0, 0.0, 1);
  const std::size_t one = points.size();
  for (std::size_t i = 0; i < one; ++i) points.push_back(points[i] + Vec3(2, 0, 0));
  Cells cells;
  add_grid_triangles(cells, n, 0);
  add_grid_triangles(cells, n, static_cast<Index>(one));
  return Mesh(std::move(points), std::move(cells));
}

Mesh hexagons(int n) {
  // Rows of vertices zigzag; row r lies between hexagon rows r - 1 and r and has 2 n + 2 places,
  // of which the first (r = n) or the last (r = 0) may serve no hexagon and is left out.
  const double half_width = std::sqrt(3.0) / 2.0;
  const int places = 2 * n + 2;
  std::vector<Index> number(static_cast<std::size_t>(places * (n + 1)), 0);
  std::vector<Vec3> points;
  std::vector<char> used(number.size(), 0);
  const auto hexagon = [&](int i, int j) {
    const int shift = j % 2;  // odd rows stand half a hexagon further right
    const int low = j * places + 2 * i + shift;
    const int high = low + places;
    return std::array<int, 6>{low, low + 1, low + 2, high + 2, high + 1, high};
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      for (const int place : hexagon(i, j)) used[static_cast<std::size_t>(place)] = 1;
    }
  }
  for (int r = 0; r <= n; ++r) {
    for (int k = 0; k < places; ++k) {
      const auto place = static_cast<std::size_t>(r * places + k);
      if (!used[place]) continue;
      number[place] = static_cast<Index>(points.size());
      const double dip = (k + r) % 2 == 0 ? 0.0 : -0.5;
      points.emplace_back(k * half_width, 1.5 * r + dip, 0.0);
    }
  }
  Cells cells;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      std::array<Index, 6> vertices{};
      const auto places_of_it = hexagon(i, j);
      for (std::size_t k = 0; k < 6; ++k) {
        vertices[k] = number[static_cast<std::size_t>(places_of_it[k])];
      }
      cells.add(CellKind::polygon, vertices);
    }
  }
  return Mesh(std::move(points), std::move(cells));
}

Mesh bowtie_vertex() {
  Cells cells;
  cells.add(CellKind::triangle, {{0, 1, 2}});
  cells.add(CellKind::triangle, {{0, 3, 4}});
  return Mesh({{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}}, std::move(cells));
}

}  // namespace evenmesh::shapes
