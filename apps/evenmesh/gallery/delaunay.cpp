// SPDX-License-Identifier: MIT
#include "apps/evenmesh/gallery/delaunay.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace evenmesh::gallery {
namespace {

double doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
}

// Whether d lies in the circle through a, b and c by more than rounding can make up.
bool in_circle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 p = a - d;
  const Vec3 q = b - d;
  const Vec3 r = c - d;
  const double det = p.squaredNorm() * (q.x() * r.y() - r.x() * q.y()) +
                     q.squaredNorm() * (r.x() * p.y() - p.x() * r.y()) +
                     r.squaredNorm() * (p.x() * q.y() - q.x() * p.y());
  const double size = p.squaredNorm() + q.squaredNorm() + r.squaredNorm();
  return det > 1e-10 * size * size;
}

// Cuts the triangle around a point in three.
void insert(Points points, Index v, std::vector<TriangleVertices>& triangles) {
  const auto around =
      std::find_if(triangles.begin(), triangles.end(), [&](const TriangleVertices& t) {
        return doubled_area(points[t[0]], points[t[1]], points[v]) > 0.0 &&
               doubled_area(points[t[1]], points[t[2]], points[v]) > 0.0 &&
               doubled_area(points[t[2]], points[t[0]], points[v]) > 0.0;
      });
  assert(around != triangles.end());
  const auto [a, b, c] = *around;
  *around = {a, b, v};
  triangles.push_back({b, c, v});
  triangles.push_back({c, a, v});
}

struct Half {
  std::size_t triangle;
  int corner;  // the one the side leaves
};

// Flips sides that are not Delaunay, each triangle at most once; whether there were any.
bool flip(Points points, std::vector<TriangleVertices>& triangles) {
  std::map<std::pair<Index, Index>, Half> half_of;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      half_of[{triangles[t][at], triangles[t][(at + 1) % 3]}] = {t, i};
    }
  }
  std::vector<char> touched(triangles.size(), 0);
  bool flipped = false;
  for (const auto& [side, half] : half_of) {
    const auto [a, b] = side;
    const auto other = half_of.find({b, a});
    if (a > b || other == half_of.end()) continue;
    const std::size_t t = half.triangle;
    const std::size_t u = other->second.triangle;
    if (touched[t] || touched[u]) continue;
    const Index c = triangles[t][static_cast<std::size_t>(half.corner + 2) % 3];
    const Index d = triangles[u][static_cast<std::size_t>(other->second.corner + 2) % 3];
    if (!in_circle(points[a], points[b], points[c], points[d])) continue;
    if (doubled_area(points[a], points[d], points[c]) <= 0.0) continue;
    if (doubled_area(points[d], points[b], points[c]) <= 0.0) continue;
    triangles[t] = {a, d, c};
    triangles[u] = {d, b, c};
    touched[t] = touched[u] = 1;
    flipped = true;
  }
  return flipped;
}

}  // namespace

std::vector<TriangleVertices> triangulate(Points points, std::size_t boundary) {
  assert(boundary >= 3 && points.size() > boundary);
  // A fan around the first point inside; the polygon is convex, so its triangles are positive.
  const auto hub = static_cast<Index>(boundary);
  std::vector<TriangleVertices> triangles;
  for (Index i = 0; i < hub; ++i) triangles.push_back({i, (i + 1) % hub, hub});
  for (Index v = hub + 1; v < points.size(); ++v) insert(points, v, triangles);
  while (flip(points, triangles)) {
  }
  return triangles;
}

}  // namespace evenmesh::gallery
