// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh::shapes {
namespace {

using Triangle = std::array<Index, 3>;

void icosahedron(std::vector<Vec3>& points, std::vector<Triangle>& triangles) {
  const double g = std::numbers::phi;
  points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
            {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& p : points) p.normalize();
  triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
}

}  // namespace

Mesh sphere_triangles(int levels) {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  icosahedron(points, triangles);
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [it, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<Index>(points.size()));
      if (is_new) points.push_back((points[a] + points[b]).normalized());
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  Cells cells;
  for (const Triangle& triangle : triangles) cells.add(CellKind::triangle, triangle);
  return Mesh(std::move(points), std::move(cells));
}

Mesh cube_surface(int n) {
  // Vertices are numbered by their place in the lattice, met for the first time.
  std::map<std::array<int, 3>, Index> numbers;
  std::vector<Vec3> points;
  const auto vertex = [&](const std::array<int, 3>& place) {
    const auto [it, is_new] = numbers.try_emplace(place, static_cast<Index>(points.size()));
    if (is_new) points.push_back(Vec3(place[0], place[1], place[2]) / n);
    return it->second;
  };
  Cells cells;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const int level : {0, n}) {
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> place{};
            place[axis] = level;
            place[u] = i + di;
            place[v] = j + dj;
            return vertex(place);
          };
          std::array<Index, 4> quad{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
          if (level == 0) std::swap(quad[1], quad[3]);
          cells.add(CellKind::quad, quad);
        }
      }
    }
  }
  return Mesh(std::move(points), std::move(cells));
}

Mesh cylinder_side(int around, int along) {
  assert(around >= 3 && along >= 1);
  std::vector<Vec3> points;
  for (int j = 0; j <= along; ++j) {
    for (int i = 0; i < around; ++i) {
      const double t = 2.0 * std::numbers::pi * i / around;
      points.emplace_back(std::cos(t), std::sin(t), 2.0 * j / along);
    }
  }
  Cells cells;
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < around; ++i) {
      const auto a = static_cast<Index>(j * around + i);
      const auto b = static_cast<Index>(j * around + (i + 1) % around);
      const auto up = static_cast<Index>(around);
      cells.add(CellKind::quad, {{a, b, b + up, a + up}});
    }
  }
  return Mesh(std::move(points), std::move(cells));
}

Mesh moebius_strip(int n) {
  assert(n >= 4);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const double t = 2.0 * std::numbers::pi * i / n;
    for (const double s : {-0.3, 0.3}) {
      const double r = 1.0 + s * std::cos(t / 2.0);
      points.emplace_back(r * std::cos(t), r * std::sin(t), s * std::sin(t / 2.0));
    }
  }
  Cells cells;
  for (int i = 0; i < n; ++i) {
    const auto a = static_cast<Index>(2 * i);
    const bool closing = i + 1 == n;  // where the edge of the strip changes sides
    const Index b = closing ? 1 : a + 2;
    const Index c = closing ? 0 : a + 3;
    cells.add(CellKind::quad, {{a, b, c, a + 1}});
  }
  return Mesh(std::move(points), std::move(cells));
}

Mesh fan_of_three() {
  Cells cells;
  cells.add(CellKind::triangle, {{0, 1, 2}});
  cells.add(CellKind::triangle, {{1, 0, 3}});
  cells.add(CellKind::triangle, {{0, 1, 4}});
  const double h = std::sqrt(3.0) / 2.0;
  return Mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-0.5, h, 0.5}, {-0.5, -h, 0.5}},
              std::move(cells));
}

Mesh mixed_surface(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      double x = static_cast<double>(i) / n;
      double y = static_cast<double>(j) / n;
      if (i > 0 && i < n && j > 0 && j < n) {
        x += 0.2 / n * random.signed_unit();
        y += 0.2 / n * random.signed_unit();
      }
      points.emplace_back(x, y, 0.2 * std::sin(3.0 * x) * std::cos(2.0 * y));
    }
  }
  Cells cells;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<Index>(j * (n + 1) + i);
      const Index d = a + static_cast<Index>(n + 1);
      if ((j * n + i) % 3 == 0) {
        cells.add(CellKind::triangle, {{a, a + 1, d + 1}});
        cells.add(CellKind::triangle, {{a, d + 1, d}});
      } else {
        cells.add(CellKind::quad, {{a, a + 1, d + 1, d}});
      }
    }
  }
  return Mesh(std::move(points), std::move(cells));
}

}  // namespace evenmesh::shapes
