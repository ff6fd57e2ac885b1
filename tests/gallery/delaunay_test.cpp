// SPDX-License-Identifier: MIT
#include "apps/evenmesh/gallery/delaunay.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "apps/evenmesh/gallery/random.h"

namespace evenmesh::gallery {
namespace {

// A regular polygon around points at random.
std::vector<Vec3> points_in_polygon(int corners, int inside, std::uint64_t seed) {
  std::vector<Vec3> points;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / corners;
    points.emplace_back(std::cos(angle_rad), std::sin(angle_rad), 0.0);
  }
  Random random(seed);
  for (int i = 0; i < inside; ++i) points.push_back(0.6 * random.in_square());
  return points;
}

double doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).z();
}

// The centre of the circle through three points, from the two equations |x - a| = |x - b|, ...
Vec3 circumcentre(const Vec3& a, const Vec3& b, const Vec3& c) {
  Eigen::Matrix2d m;
  m << (b - a).head<2>().transpose(), (c - a).head<2>().transpose();
  const Eigen::Vector2d right(0.5 * (b - a).squaredNorm(), 0.5 * (c - a).squaredNorm());
  const Eigen::Vector2d x = m.inverse() * right;
  return a + Vec3(x.x(), x.y(), 0.0);
}

TEST(Triangulate, FillsThePolygonWithPositiveTriangles) {
  const std::vector<Vec3> points = points_in_polygon(9, 40, 3);
  double area = 0.0;
  const auto triangles = triangulate(points, 9);
  for (const auto& [a, b, c] : triangles) {
    const double doubled = doubled_area(points[a], points[b], points[c]);
    EXPECT_GT(doubled, 0.0);
    area += 0.5 * doubled;
  }
  EXPECT_NEAR(area, 4.5 * std::sin(2.0 * std::numbers::pi / 9.0), 1e-12);
  EXPECT_EQ(triangles.size(), 2u * 40u + 9u - 2u);  // Euler
}

TEST(Triangulate, LeavesEveryCircleEmpty) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<Vec3> points = points_in_polygon(12, 60, seed);
    for (const auto& [a, b, c] : triangulate(points, 12)) {
      const Vec3 centre = circumcentre(points[a], points[b], points[c]);
      const double radius = (points[a] - centre).norm();
      for (const Vec3& p : points) EXPECT_GE((p - centre).norm(), radius * (1.0 - 1e-6)) << seed;
    }
  }
}

}  // namespace
}  // namespace evenmesh::gallery
