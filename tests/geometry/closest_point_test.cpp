// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/closest_point.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace evenmesh {
namespace {

Vec3 random_vec(shapes::Random& random) {
  return {random.signed_unit(), random.signed_unit(), random.signed_unit()};
}

TEST(ClosestPoint, OfATriangleIsNoFartherThanAnyPointOfIt) {
  shapes::Random random(1);
  for (int i = 0; i < 300; ++i) {
    Vec3 corners[3];
    for (Vec3& c : corners) c = random_vec(random);
    if (i % 3 == 0) corners[2] = 0.3 * corners[0] + 0.7 * corners[1];  // no area
    const Vec3 p = 2.0 * random_vec(random);
    const ClosestPoint found = closest_on_triangle(corners[0], corners[1], corners[2], p);
    const double distance = (found.position - p).norm();
    EXPECT_NEAR(std::sqrt(found.squared_distance), distance, 1e-14);
    EXPECT_GE(found.weights.minCoeff(), 0.0);
    EXPECT_NEAR(found.weights.sum(), 1.0, 1e-15);
    const Vec3 blend = found.weights[0] * corners[0] + found.weights[1] * corners[1] +
                       found.weights[2] * corners[2];
    EXPECT_LE((blend - found.position).norm(), 1e-15);
    const int n = 40;
    double least = 1e9;
    for (int a = 0; a <= n; ++a) {
      for (int b = 0; a + b <= n; ++b) {
        const Vec3 q = (a * corners[0] + b * corners[1] + (n - a - b) * corners[2]) / n;
        least = std::min(least, (q - p).norm());
      }
    }
    EXPECT_LE(distance, least + 1e-14);
    EXPECT_GE(distance, least - 2.0 / n);
  }
}

TEST(ClosestPoint, KeepsTheBitsOfCornersAndTheSideOfEdges) {
  const Vec3 a(0.1, 0.2, 0.3);
  const Vec3 b(1.1, 0.2, 0.3);
  const Vec3 c(0.1, 1.2, 0.3);
  EXPECT_EQ(closest_on_triangle(a, b, c, {-1, -1, 9}).position, a);
  EXPECT_EQ(closest_on_triangle(a, b, c, {9, 0, 9}).position, b);
  EXPECT_EQ(closest_on_triangle(a, b, c, {0, 9, 9}).position, c);
  EXPECT_EQ(closest_on_triangle(a, b, c, {0.5, -9, 9}).position.y(), 0.2);
  EXPECT_EQ(closest_on_segment(a, b, {9, 9, 9}).position, b);
  EXPECT_EQ(closest_on_segment(a, b, {0, 0, 0}).position, a);
  EXPECT_EQ(closest_on_segment(a, a, {0, 0, 0}).position, a);
}

}  // namespace
}  // namespace evenmesh
