// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/surface_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "evenmesh/base/parallel.h"
#include "evenmesh/mesh/mesh.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

std::vector<Vec3> points_of(const Mesh& mesh) {
  return {mesh.points().begin(), mesh.points().end()};
}

/// Quads are cut along their first diagonal.
std::vector<VertexTriple> triangles_of(const Mesh& mesh) {
  std::vector<VertexTriple> triangles;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const auto v = mesh.cells().vertices(c);
    for (std::size_t i = 2; i < v.size(); ++i) triangles.push_back({v[0], v[i - 1], v[i]});
  }
  return triangles;
}

/// z = f(x, y) on n x n squares over [-1, 1]^2.
struct Graph {
  std::vector<Vec3> points;
  std::vector<VertexTriple> triangles;

  Graph(int n, const std::function<double(double, double)>& f) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const double x = 2.0 * i / n - 1.0;
        const double y = 2.0 * j / n - 1.0;
        points.emplace_back(x, y, f(x, y));
      }
    }
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const auto a = static_cast<Index>(j * (n + 1) + i);
        const auto d = static_cast<Index>(a + static_cast<Index>(n) + 1);
        triangles.push_back({a, a + 1, d + 1});
        triangles.push_back({a, d + 1, d});
      }
    }
  }
};

/// Triangle and corner of a vertex.
TrackPoint at_vertex(const SurfaceTrack& track, Index vertex) {
  for (std::uint32_t t = 0; t < track.triangles(); ++t) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (track.vertices(t)[j] == vertex) return track.at(t, j);
    }
  }
  ADD_FAILURE() << "no triangle has vertex " << vertex;
  return {};
}

Vec3 random_vec(shapes::Random& random) {
  return {random.signed_unit(), random.signed_unit(), random.signed_unit()};
}

double distance_to_triangle(const SurfaceTrack& track, std::uint32_t t, const Vec3& p) {
  const auto [a, b, c] = track.vertices(t);
  const ClosestPoint found =
      closest_on_triangle(track.position(a), track.position(b), track.position(c), p);
  return std::sqrt(found.squared_distance);
}

/// Random steps in the tangent plane, each followed by nearest().
void expect_walk_without_jumps(const SurfaceTrack& track, TrackPoint at, double longest,
                               std::uint64_t seed,
                               const std::function<void(const TrackPoint&)>& check) {
  shapes::Random random(seed);
  for (int i = 0; i < 1000; ++i) {
    Vec3 step = longest * random_vec(random);
    step -= at.direction.dot(step) * at.direction;
    const TrackPoint to = track.nearest(at.position + step, at);
    EXPECT_LE((to.position - at.position).norm(), 2.0 * step.norm() * (1.0 + 1e-12));
    EXPECT_NEAR(to.direction.norm(), 1.0, 1e-14);
    EXPECT_LE(distance_to_triangle(track, to.piece, to.position), 1e-15);
    check(to);
    at = to;
  }
}

TEST(SurfaceTrack, FindsTheNearestPointOfASphere) {
  const Mesh mesh = shapes::sphere_triangles(3);
  const SurfaceTrack track(points_of(mesh), triangles_of(mesh));
  shapes::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const TrackPoint from = at_vertex(track, static_cast<Index>(random.below(mesh.point_count())));
    const Vec3 p = from.position + 0.3 * random_vec(random);
    const TrackPoint found = track.nearest(p, from);
    double least = 1e9;
    for (std::uint32_t t = 0; t < track.triangles(); ++t) {
      least = std::min(least, distance_to_triangle(track, t, p));
    }
    EXPECT_NEAR((found.position - p).norm(), least, 1e-14);
    EXPECT_LE((found.direction - found.position.normalized()).norm(), 0.05);
  }
}

TEST(SurfaceTrack, LeavesAVertexThatDoesNotMoveWhereItIs) {
  for (const double unit : {1e-140, 0.3, 1e140}) {
    const Mesh mesh = shapes::scaled(shapes::sphere_triangles(2), unit);
    const SurfaceTrack track(points_of(mesh), triangles_of(mesh));
    for (Index v = 0; v < mesh.point_count(); ++v) {
      const TrackPoint from = at_vertex(track, v);
      EXPECT_EQ(from.position, mesh.points()[v]);
      const TrackPoint again = track.nearest(from.position, from);
      EXPECT_EQ(again.position, from.position);
      EXPECT_EQ(again.piece, from.piece);
      EXPECT_EQ(again.direction, from.direction);
    }
  }
}

TEST(SurfaceTrack, WalksOnASphereWithoutJumping) {
  const Mesh mesh = shapes::sphere_triangles(3);
  const SurfaceTrack track(points_of(mesh), triangles_of(mesh));
  for (const double step : {0.02, 0.1, 0.5}) {
    expect_walk_without_jumps(track, track.at(17, 1), step, 4, [](const TrackPoint& to) {
      EXPECT_NEAR(to.position.norm(), 1.0, 0.01);
      EXPECT_GT(to.direction.dot(to.position), 0.99);  // outward all the way
    });
  }
}

TEST(SurfaceTrack, WalksOnASaddleWithoutJumping) {
  const Graph g(24, [](double x, double y) { return x * x - y * y; });
  const SurfaceTrack track(g.points, g.triangles);
  expect_walk_without_jumps(track, track.at(600, 0), 0.2, 5, [](const TrackPoint& to) {
    const Vec3& p = to.position;
    EXPECT_NEAR(p.z(), p.x() * p.x() - p.y() * p.y(), 0.01);
    EXPECT_GT(to.direction.z(), 0.0);
  });
}

TEST(SurfaceTrack, TurnsItsNormalSmoothlyAcrossTriangles) {
  const Mesh mesh = shapes::sphere_triangles(2);
  const SurfaceTrack track(points_of(mesh), triangles_of(mesh));
  TrackPoint at = track.at(0, 0);
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.003 * i;
    const TrackPoint to = track.nearest({std::cos(t), std::sin(t), 0.1}, track.at(0, 0));
    const TrackPoint near = track.nearest(to.position, to);
    EXPECT_LE((near.direction - to.direction).norm(), 1e-9);
  }
  // Steps of 0.001 turn it by about 0.001; the triangles' own normals differ by 0.2 and more.
  at = track.nearest({1, 0, 0.1}, at_vertex(track, 0));
  for (int i = 0; i < 3000; ++i) {
    Vec3 along = Vec3(0.3, 0.2, 1.0).cross(at.direction).normalized();
    const TrackPoint to = track.nearest(at.position + 0.001 * along, at);
    EXPECT_LE((to.direction - at.direction).norm(), 0.004);
    at = to;
  }
}

TEST(SurfaceTrack, StaysOnItsSheetOfAThinWall) {
  // Two sheets 0.01 apart, facing either way or the same way; steps are 10 times as long.
  for (const bool same_way : {false, true}) {
    Graph g(20, [](double, double) { return 0.0; });
    const auto count = static_cast<Index>(g.points.size());
    const std::size_t sheet = g.triangles.size();
    for (Index v = 0; v < count; ++v) g.points.push_back(g.points[v] + Vec3(0, 0, 0.01));
    for (std::size_t t = 0; t < sheet; ++t) {
      auto [a, b, c] = g.triangles[t];
      if (!same_way) std::swap(b, c);
      g.triangles.push_back({a + count, b + count, c + count});
    }
    const SurfaceTrack track(g.points, g.triangles);
    EXPECT_NE(track.patch(0), track.patch(static_cast<std::uint32_t>(sheet)));
    shapes::Random random(6);
    for (int i = 0; i < 300; ++i) {
      const TrackPoint from = track.at(static_cast<std::uint32_t>(random.below(sheet)), 0);
      const TrackPoint to = track.nearest(from.position + 0.1 * random_vec(random), from);
      EXPECT_EQ(to.position.z(), 0.0);
      EXPECT_LT(to.piece, sheet);
    }
  }
}

/// A strip that goes along x, round a half circle of the radius and back above itself: one patch.
Graph rounded_plate(double radius) {
  Graph g(40, [](double, double) { return 0.0; });
  const double flat = 0.8;  // where x leaves the lower side
  for (Vec3& p : g.points) {
    const double s = p.x();  // length along the strip in units of its half
    if (s <= 0.0) {
      p.x() = flat * (1.0 + s);
    } else if (s <= 0.2) {
      const double angle = std::acos(-1.0) * s / 0.2;
      p = {flat + radius * std::sin(angle), p.y(), radius * (1.0 - std::cos(angle))};
    } else {
      p = {flat * (1.0 - (s - 0.2) / 0.8), p.y(), 2.0 * radius};
    }
  }
  return g;
}

TEST(SurfaceTrack, StaysOnItsSideOfAThinRoundedPlate) {
  const Graph g = rounded_plate(0.01);
  const SurfaceTrack track(g.points, g.triangles);
  shapes::Random random(8);
  int tried = 0;
  for (std::uint32_t t = 0; t < track.triangles(); ++t) {
    const TrackPoint from = track.at(t, 0);
    if (from.position.x() > 0.6) continue;  // the rim is in the ball there, so the way is open
    ++tried;
    const TrackPoint to = track.nearest(from.position + 0.1 * random_vec(random), from);
    EXPECT_EQ(to.position.z() > 0.01, from.position.z() > 0.01);
  }
  EXPECT_GT(tried, 1000);
  EXPECT_EQ(track.patch(0), track.patch(static_cast<std::uint32_t>(track.triangles() - 1)));
  expect_walk_without_jumps(track, track.at(0, 0), 0.05, 9, [](const TrackPoint&) {});
}

/// Names the edges on x = 0 as barriers, in every other triangle alone.
std::vector<std::uint8_t> middle_line(const Graph& g, std::size_t parity) {
  std::vector<std::uint8_t> barriers(g.triangles.size(), 0);
  for (std::size_t t = parity; t < g.triangles.size(); t += 2) {
    for (std::size_t j = 0; j < 3; ++j) {
      const bool is_middle = g.points[g.triangles[t][j]].x() == 0.0 &&
                             g.points[g.triangles[t][(j + 1) % 3]].x() == 0.0;
      if (is_middle) barriers[t] |= static_cast<std::uint8_t>(1u << j);
    }
  }
  return barriers;
}

TEST(SurfaceTrack, TakesABarrierThatOneSideNames) {
  const Graph g(8, [](double x, double) { return std::abs(x); });
  const auto right = static_cast<std::uint32_t>(g.triangles.size() - 1);
  EXPECT_EQ(SurfaceTrack(g.points, g.triangles).patch(right), 0u);
  for (const std::size_t parity : {0, 1}) {
    EXPECT_NE(SurfaceTrack(g.points, g.triangles, middle_line(g, parity)).patch(right), 0u);
  }
}

TEST(SurfaceTrack, DoesNotCrossABarrier) {
  // The plane's middle line x = 0 is a barrier: steps across it end on it.
  const Graph g(8, [](double x, double) { return std::abs(x); });
  const SurfaceTrack track(g.points, g.triangles, middle_line(g, 0));
  const TrackPoint right = track.nearest({0.1, 0.1, 0.1}, track.at(at_vertex(track, 42).piece, 0));
  EXPECT_GT(right.position.x(), 0.0);
  const TrackPoint to = track.nearest({-0.3, 0.1, 0.3}, right);
  EXPECT_EQ(to.position.x(), 0.0);
  // Up to the crease the normal is that of its own side.
  EXPECT_LE((to.direction - Vec3(-1, 0, 1).normalized()).norm(), 1e-15);

  // Without the barrier the same step goes on, and the normal at the crease is between.
  const SurfaceTrack open(g.points, g.triangles);
  EXPECT_LT(open.nearest({-0.3, 0.1, 0.3}, right).position.x(), -0.2);
  EXPECT_LE((open.nearest({0, 0.1, 0}, right).direction - Vec3(0, 0, 1)).norm(), 1e-14);
}

TEST(SurfaceTrack, HoldsAFoldThatIsMarkedOnBothItsSides) {
  // A sheet folded flat onto itself, 1e-3 apart at the far ends: the fold is in every ball.
  const std::vector<Vec3> points{{0, 0, 0}, {0, 1, 0},    {1, 0, 0},
                                 {1, 1, 0}, {1, 0, 1e-3}, {1, 1, 1e-3}};
  const std::vector<VertexTriple> triangles{{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}};
  const SurfaceTrack track(points, triangles, std::vector<std::uint8_t>{0b100, 0, 0b001, 0});
  EXPECT_EQ(track.patch(0), track.patch(1));
  EXPECT_NE(track.patch(0), track.patch(2));
  const TrackPoint found = track.nearest({0.2, 0.5, 1.0}, track.at(0, 0));
  EXPECT_EQ(found.position.z(), 0.0);
  const SurfaceTrack open(points, triangles);
  EXPECT_GT(open.nearest({0.2, 0.5, 1.0}, open.at(0, 0)).position.z(), 0.0);
}

TEST(SurfaceTrack, DoesNotCareHowTrianglesAreWound) {
  const Mesh mesh = shapes::sphere_triangles(2);
  const SurfaceTrack plain(points_of(mesh), triangles_of(mesh));
  std::vector<VertexTriple> mixed = triangles_of(mesh);
  shapes::Random random(10);
  for (std::size_t t = 1; t < mixed.size(); ++t) {
    if (random.below(2) == 0) std::swap(mixed[t][1], mixed[t][2]);
  }
  const SurfaceTrack other(points_of(mesh), mixed);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = random_vec(random).normalized();
    const TrackPoint a = plain.nearest(p, plain.at(0, 0));
    const TrackPoint b = other.nearest(p, other.at(0, 0));
    EXPECT_LE((a.direction - b.direction).norm(), 1e-12);
    EXPECT_LE((a.position - b.position).norm(), 1e-14);
  }
}

TEST(SurfaceTrack, HasNormalsOnAMoebiusStrip) {
  const Mesh mesh = shapes::moebius_strip(40);
  const SurfaceTrack track(points_of(mesh), triangles_of(mesh));
  for (std::uint32_t t = 0; t < track.triangles(); ++t) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto [a, b, c] = track.vertices(t);
      const Vec3 own = (track.position(b) - track.position(a))
                           .cross(track.position(c) - track.position(a))
                           .normalized();
      EXPECT_GT(std::abs(track.at(t, j).direction.dot(own)), 0.9);
    }
  }
}

TEST(SurfaceTrack, TakesTheTrianglesNormalWhereTheBlendIsNone) {
  // Both sides of one triangle, glued along all three edges: corner normals cancel.
  const SurfaceTrack track({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_EQ(track.nearest({0.2, 0.2, 1}, track.at(0, 0)).direction, Vec3(0, 0, 1));
  EXPECT_EQ(track.nearest({0.2, 0.2, 1}, track.at(1, 0)).piece, 0u);  // equally near: the least
}

TEST(SurfaceTrack, SurvivesTrianglesWithoutArea) {
  // A square of which a collinear triangle is a part, and one that is a point.
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  const SurfaceTrack track(points,
                           {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}, {3, 3, 3}, {3, 2, 2}});
  for (std::uint32_t t = 0; t < 4; ++t) {
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(track.at(t, j).direction, Vec3(0, 0, 1)) << t;
  }
  EXPECT_EQ(track.nearest({0.2, 0.7, 0.1}, track.at(0, 0)).position, Vec3(0.2, 0.7, 0));
  const TrackPoint point = track.nearest({5, 5, 5}, track.at(4, 0));
  EXPECT_EQ(point.position, points[3]);
  EXPECT_EQ(point.direction, Vec3::Zero());
}

TEST(SurfaceTrack, OfOneTriangleIsThatTriangle) {
  const SurfaceTrack track({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{0, 1, 2}});
  EXPECT_EQ(track.nearest({0.25, 0.25, 3}, track.at(0, 0)).position, Vec3(0.25, 0.25, 1));
  EXPECT_EQ(track.nearest({9, -9, 3}, track.at(0, 0)).position, Vec3(1, 0, 1));
  EXPECT_EQ(track.nearest({-9, -9, 3}, track.at(0, 1)).position, Vec3(0, 0, 1));
  EXPECT_EQ(track.at(0, 0).direction, Vec3(0, 0, 1));
  EXPECT_EQ(track.curvature(track.at(0, 0), {1, 0, 0}), Vec3::Zero());
}

TEST(SurfaceTrack, FindsTheSameWithLargeBalls) {
  // More triangles than are searched one by one.
  const Graph g(30, [](double x, double y) { return 0.1 * std::sin(5.0 * x) * y; });
  const SurfaceTrack track(g.points, g.triangles);
  shapes::Random random(12);
  for (int i = 0; i < 20; ++i) {
    const Vec3 p = random_vec(random);
    const TrackPoint found = track.nearest(p, track.at(0, 0));
    double least = 1e9;
    for (std::uint32_t t = 0; t < track.triangles(); ++t) {
      least = std::min(least, distance_to_triangle(track, t, p));
    }
    EXPECT_NEAR((found.position - p).norm(), least, 1e-14);
  }
}

TEST(SurfaceTrack, FindsTheSameFromSeveralThreads) {
  const Mesh mesh = shapes::sphere_triangles(4);
  const SurfaceTrack track(points_of(mesh), triangles_of(mesh));
  const auto count = static_cast<std::uint32_t>(track.triangles());
  const auto walk = [&](int threads) {
    std::vector<Vec3> found(count);
    Workers workers(threads);
    workers.run(16, [&](std::size_t task) {
      for (auto t = static_cast<std::uint32_t>(task); t < count; t += 16) {
        shapes::Random random(t);
        const TrackPoint from = track.at(t, 0);
        found[t] = track.nearest(from.position + 0.2 * random_vec(random), from).position;
      }
    });
    return found;
  };
  EXPECT_EQ(walk(1), walk(4));
}

}  // namespace
}  // namespace evenmesh
