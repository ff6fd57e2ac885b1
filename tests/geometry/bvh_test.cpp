// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/bvh.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace evenmesh {
namespace {

Vec3 random_vec(shapes::Random& random) {
  return {random.signed_unit(), random.signed_unit(), random.signed_unit()};
}

struct Soup {
  std::vector<Vec3> points;
  std::vector<VertexTriple> triangles;
};

/// Small triangles, needles, segments, points and some that are there twice.
Soup random_soup(std::size_t count, std::uint64_t seed, double unit = 1.0) {
  shapes::Random random(seed);
  Soup soup;
  for (Index i = 0; i < count; ++i) {
    const Vec3 centre = random_vec(random);
    for (int j = 0; j < 3; ++j) soup.points.push_back(unit * (centre + 0.1 * random_vec(random)));
    VertexTriple t{3 * i, 3 * i + 1, 3 * i + 2};
    if (i % 7 == 1) t[2] = t[1];
    if (i % 7 == 2) t[0] = t[1] = t[2];
    if (i % 7 == 3 && i > 7) t = soup.triangles[i - 7];
    if (i % 7 == 4) soup.points.back() = 0.5 * (soup.points[3 * i] + soup.points[3 * i + 1]);
    soup.triangles.push_back(t);
  }
  return soup;
}

/// The answer without a tree.
template <class Accept>
Bvh::Hit by_search(const Soup& soup, const Vec3& p, const Accept& accept) {
  Bvh::Hit best;
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    const auto [a, b, c] = soup.triangles[t];
    const ClosestPoint found =
        closest_on_triangle(soup.points[a], soup.points[b], soup.points[c], p);
    const double distance = std::sqrt(found.squared_distance);
    if (distance < best.distance && accept(t)) best = {t, found.position, distance};
  }
  return best;
}

TEST(Bvh, FindsWhatASearchOfAllTrianglesFinds) {
  for (const std::size_t count : {1u, 2u, 5u, 30u, 400u}) {
    const Soup soup = random_soup(count, count);
    const Bvh tree(soup.points, soup.triangles);
    EXPECT_EQ(tree.triangles(), count);
    shapes::Random random(9);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = (i % 10 == 0 ? 20.0 : 1.2) * random_vec(random);
      const Bvh::Hit found = tree.closest(p);
      const Bvh::Hit wanted = by_search(soup, p, [](std::uint32_t) { return true; });
      EXPECT_EQ(found.triangle, wanted.triangle);
      EXPECT_NEAR(found.distance, wanted.distance, 1e-15 * (1.0 + wanted.distance));
      EXPECT_NEAR((found.position - p).norm(), wanted.distance, 1e-14 * (1.0 + wanted.distance));
      EXPECT_EQ(tree.closest_on(found.triangle, p).distance, found.distance);
    }
  }
}

TEST(Bvh, LooksNoFartherThanTheBound) {
  const Soup soup = random_soup(200, 3);
  const Bvh tree(soup.points, soup.triangles);
  shapes::Random random(4);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = 1.5 * random_vec(random);
    const Bvh::Hit all = tree.closest(p);
    EXPECT_EQ(tree.closest(p, 1.001 * all.distance).triangle, all.triangle);
    const Bvh::Hit none = tree.closest(p, 0.999 * all.distance);
    EXPECT_FALSE(none.found());
    EXPECT_EQ(none.distance, std::numeric_limits<double>::infinity());
  }
}

TEST(Bvh, FindsFacingTriangles) {
  const Soup soup = random_soup(300, 5);
  const Bvh tree(soup.points, soup.triangles);
  shapes::Random random(6);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = 1.2 * random_vec(random);
    const Vec3 normal = 5.0 * random_vec(random);
    const double cosine = i % 2 == 0 ? 0.0 : 0.7;
    const Bvh::Hit found = tree.closest_facing(p, normal, cosine);
    const Bvh::Hit wanted = by_search(soup, p, [&](std::uint32_t t) {
      const auto [a, b, c] = soup.triangles[t];
      const Vec3 n = (soup.points[b] - soup.points[a]).cross(soup.points[c] - soup.points[a]);
      return n.norm() > 0.0 && n.normalized().dot(normal.normalized()) >= cosine;
    });
    EXPECT_EQ(found.triangle, wanted.triangle);
    EXPECT_NEAR(found.distance, wanted.distance, 1e-15);
  }
}

TEST(Bvh, FindsItsSideOfAThinWall) {
  const std::vector<Vec3> points{{0, 0, 0},    {1, 0, 0},    {0, 1, 0},
                                 {0, 0, 0.01}, {1, 0, 0.01}, {0, 1, 0.01}};
  const Bvh tree(points, std::vector<VertexTriple>{{0, 2, 1}, {3, 4, 5}});
  EXPECT_EQ(tree.closest({0.2, 0.2, -1}).triangle, 0u);
  EXPECT_EQ(tree.closest_facing({0.2, 0.2, -1}, {0, 0, 1}).triangle, 1u);
  EXPECT_FALSE(tree.closest_facing({0.2, 0.2, -1}, {0, 0, 1}, 0.0, 1.0).found());
  EXPECT_FALSE(tree.closest_facing({0.2, 0.2, -1}, {1, 0, 0}, 0.5).found());
}

TEST(Bvh, TakesTheLeastOfEquallyNearTriangles) {
  // Many times the same triangle: no way to divide them.
  Soup soup = random_soup(1, 1);
  soup.triangles.assign(1000, soup.triangles[0]);
  const Bvh tree(soup.points, soup.triangles);
  EXPECT_EQ(tree.closest({1, 2, 3}).triangle, 0u);
}

TEST(Bvh, WorksInAnyUnitOfLength) {
  const Soup plain = random_soup(100, 8);
  const Bvh plain_tree(plain.points, plain.triangles);
  for (const double unit : {0x1p-500, 0x1p-60, 0x1p60, 0x1p500}) {
    const Soup soup = random_soup(100, 8, unit);
    const Bvh tree(soup.points, soup.triangles);
    shapes::Random random(2);
    for (int i = 0; i < 50; ++i) {
      const Vec3 p = random_vec(random);
      const Bvh::Hit a = plain_tree.closest(p);
      const Bvh::Hit b = tree.closest(unit * p);
      EXPECT_EQ(a.triangle, b.triangle);
      EXPECT_EQ(unit * a.position, b.position);
      EXPECT_EQ(unit * a.distance, b.distance);
    }
  }
}

TEST(Bvh, StaysShallowForTrianglesOfEverySize) {
  // Each half as far from the origin as the one before: bins leave all but one on one side.
  Soup soup;
  for (Index i = 0; i < 600; ++i) {
    for (int j = 0; j < 3; ++j) {
      soup.points.push_back(std::ldexp(1.0, -static_cast<int>(i)) *
                            Vec3(1.0, 0.1 * j, 0.01 * j * j));
    }
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Bvh tree(soup.points, soup.triangles);
  for (Index i = 0; i < 600; i += 7) {
    EXPECT_EQ(tree.closest(soup.points[3 * i]).distance, 0.0);
  }
}

TEST(Bvh, OfNothingFindsNothing) {
  const Bvh tree({}, {});
  EXPECT_FALSE(tree.closest({0, 0, 0}).found());
}

}  // namespace
}  // namespace evenmesh
