// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "apps/evenmesh/gallery/delaunay.h"
#include "apps/evenmesh/gallery/meshes.h"
#include "apps/evenmesh/gallery/random.h"

namespace evenmesh::gallery {
namespace {

constexpr double kHalfLength = 1.8;
constexpr double kHeight = 1.3;
constexpr int kBoundaryVertices = 38;
constexpr double kSpacing = 0.25;   // of the vertices inside, before they are displaced
constexpr double kJitter = 0.42;    // of that
constexpr double kClearance = 0.5;  // of that, from the outline
constexpr std::uint64_t kSeed = 5;

// The outline, t from 0 (the tip) to 2 pi, counterclockwise; strictly convex.
Vec3 on_outline(double t) {
  return {kHalfLength * std::cos(t), kHeight * std::sin(t) * std::abs(std::sin(t / 2.0)), 0.0};
}

// Vertices on the outline, evenly spaced along it, the first at the tip.
std::vector<Vec3> boundary() {
  constexpr int kFine = 4096;
  std::vector<double> way{0.0};
  const auto at = [](int i) { return on_outline(2.0 * std::numbers::pi * i / kFine); };
  for (int i = 1; i <= kFine; ++i) way.push_back(way.back() + (at(i) - at(i - 1)).norm());
  std::vector<Vec3> points;
  for (int k = 0; k < kBoundaryVertices; ++k) {
    const auto reached =
        std::lower_bound(way.begin(), way.end(), way.back() * k / kBoundaryVertices);
    points.push_back(at(static_cast<int>(reached - way.begin())));
  }
  return points;
}

// The distance from the outline's polygon, negative outside.
double depth(const std::vector<Vec3>& polygon, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& a = polygon[i];
    const Vec3 side = polygon[(i + 1) % polygon.size()] - a;
    const Vec3 d = p - a;
    least = std::min(least, (side.x() * d.y() - side.y() * d.x()) / side.norm());
  }
  return least;
}

}  // namespace

Mesh teardrop() {
  std::vector<Vec3> points = boundary();
  const std::vector<Vec3> polygon = points;
  Random random(kSeed);
  const double row_height = kSpacing * std::sqrt(0.75);
  for (double y = -kHeight, shift = 0.0; y < kHeight; y += row_height, shift = 0.5 - shift) {
    for (double x = -kHalfLength; x < kHalfLength; x += kSpacing) {
      const Vec3 p = Vec3(x + shift * kSpacing, y, 0.0) + kJitter * kSpacing * random.in_square();
      if (depth(polygon, p) > kClearance * kSpacing) points.push_back(p);
    }
  }
  Cells cells;
  for (const TriangleVertices& t : triangulate(points, polygon.size())) {
    cells.add(CellKind::triangle, t);
  }
  return Mesh(std::move(points), std::move(cells));
}

}  // namespace evenmesh::gallery
