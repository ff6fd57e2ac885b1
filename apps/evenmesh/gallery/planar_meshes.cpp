// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/evenmesh/gallery/grid.h"
#include "apps/evenmesh/gallery/meshes.h"
#include "apps/evenmesh/gallery/random.h"

namespace evenmesh::gallery {
namespace {

constexpr double kDisplacement = 0.4;

std::vector<Vec3> unit_square(const Grid& grid) {
  return grid.points([&](int i, int j) {
    return Vec3(static_cast<double>(i) / grid.columns, static_cast<double>(j) / grid.rows, 0.0);
  });
}

}  // namespace

KnownMesh four_triangles(std::uint64_t seed) {
  const std::vector<Vec3> optimum{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  Cells cells;
  for (Index i = 0; i < 4; ++i) {
    cells.add(CellKind::triangle, std::array<Index, 3>{i, (i + 1) % 4, 4});
  }
  std::vector<Vec3> start = optimum;
  start[4] += kDisplacement * Random(seed).direction();
  return {Mesh(std::move(start), std::move(cells)), optimum};
}

KnownMesh four_quads(std::uint64_t seed) {
  const Grid grid{2, 2};
  const std::vector<Vec3> optimum = unit_square(grid);
  std::vector<Vec3> start = optimum;
  start[grid.vertex(1, 1)] += kDisplacement / 2.0 * Random(seed).direction();
  return {Mesh(std::move(start), grid.quads()), optimum};
}

KnownMesh square_of_quads(std::uint64_t seed) {
  const Grid grid{6, 6};
  const std::vector<Vec3> optimum = unit_square(grid);
  std::vector<Vec3> start = optimum;
  Random random(seed);
  for (int j = 1; j < grid.rows; ++j) {
    for (int i = 1; i < grid.columns; ++i) {
      start[grid.vertex(i, j)] += kDisplacement / grid.columns * random.in_square();
    }
  }
  return {Mesh(std::move(start), grid.quads()), optimum};
}

Mesh quad_block() {
  constexpr double kWave = 0.4;   // of the sides, in cells
  constexpr double kShift = 0.6;  // by which vertices crowd, at the left below, at the right above
  constexpr double kJitter = 0.25;  // of the vertices inside, in cells
  const Grid grid{14, 10};
  Random random(1);
  auto points = grid.points([&](int i, int j) {
    const double u = static_cast<double>(i) / grid.columns;
    const double v = static_cast<double>(j) / grid.rows;
    const Vec3 wave(std::sin(2.0 * std::numbers::pi * v), std::sin(3.0 * std::numbers::pi * u), 0);
    const double shifted = u + kShift * u * (1.0 - u) * (2.0 * v - 1.0);
    const Vec3 p = Vec3(grid.columns * shifted, j, 0.0) + kWave * wave;
    return grid.on_boundary(i, j) ? p : Vec3(p + kJitter * random.in_square());
  });
  return Mesh(std::move(points), grid.quads());
}

Mesh trapezoid_and_annulus() {
  constexpr int kStraight = 12;  // columns of the trapezoid
  constexpr int kTurning = 24;   // of the half annulus
  constexpr double kLength = 2.6;
  constexpr double kInner = 1.1;  // radii
  constexpr double kOuter = 2.2;
  constexpr double kWider = 0.2;  // by which the far end of the trapezoid exceeds both
  constexpr double kBulge = 0.3;  // of the line where the blocks meet, into the annulus
  const Grid grid{kStraight + kTurning, 6};
  auto points = grid.points([&](int i, int j) {
    // Row 0 is the outer side, so that cells are counterclockwise.
    const double v = static_cast<double>(j) / grid.rows;
    const double bulge = kBulge * 4.0 * v * (1.0 - v);
    const double radius = kOuter + (kInner - kOuter) * v;
    if (i < kStraight) {
      const double away = 1.0 - static_cast<double>(i) / kStraight;
      const double wider = kWider * away * (1.0 - 2.0 * v);
      return Vec3(-kLength * away + bulge * (1.0 - away), -radius - wider, 0.0);
    }
    const double way = static_cast<double>(i - kStraight) / kTurning;
    const double angle_rad = std::numbers::pi * way + bulge / radius * (1.0 - way);
    return Vec3(radius * std::sin(angle_rad), -radius * std::cos(angle_rad), 0.0);
  });
  return Mesh(std::move(points), grid.quads());
}

Mesh tangled(const Mesh& mesh, const std::vector<char>& fixed, double size, std::uint64_t seed) {
  Mesh result = mesh;
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  Random random(seed);
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!fixed[v]) points[v] += size * random.in_square();
  }
  result.set_points(std::move(points));
  return result;
}

}  // namespace evenmesh::gallery
