// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/curves.h"

#include <cmath>

namespace evenmesh {
namespace {

/// From a to b, of length 1; zero if they coincide. Safe for any size of coordinates.
Vec3 direction(const Vec3& a, const Vec3& b) {
  const Vec3 half = b / 2.0 - a / 2.0;
  const double size = half.cwiseAbs().maxCoeff();
  if (!(size > 0.0)) return Vec3::Zero();
  return (half / size).normalized();
}

bool turns_sharply(const Vec3& before, const Vec3& at, const Vec3& after, double cosine) {
  const Vec3 arriving = direction(before, at);
  const Vec3 leaving = direction(at, after);
  if (arriving.isZero(0.0) || leaving.isZero(0.0)) return true;
  // An angle of exactly the limit is not beyond it, whatever rounding says.
  constexpr double kRounding = 1e-12;
  return arriving.dot(leaving) < cosine - kRounding;
}

}  // namespace

void mark_corners(Points points, std::span<const VertexPair> edges, double angle_rad,
                  std::vector<char>& corners) {
  if (edges.empty()) return;
  // Neighbours by vertex: ends[v - 1] to ends[v].
  std::vector<Offset> ends(points.size() + 1, 0);
  for (const auto& [a, b] : edges) {
    ++ends[a + 1];
    ++ends[b + 1];
  }
  for (std::size_t v = 1; v < ends.size(); ++v) ends[v] += ends[v - 1];
  std::vector<Index> neighbours(2 * edges.size());
  for (const auto& [a, b] : edges) {
    neighbours[ends[a]++] = b;
    neighbours[ends[b]++] = a;
  }
  const double cosine = std::cos(angle_rad);
  Offset begin = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const std::span<const Index> around(neighbours.data() + begin, neighbours.data() + ends[v]);
    begin = ends[v];
    if (around.empty()) continue;
    if (around.size() != 2 ||
        turns_sharply(points[around[0]], points[v], points[around[1]], cosine)) {
      corners[v] = 1;
    }
  }
}

}  // namespace evenmesh
