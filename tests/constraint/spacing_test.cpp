// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/spacing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

Chain chain_of(std::size_t count, bool closed = false) {
  Chain chain{{}, closed};
  for (std::size_t i = 0; i < count; ++i) chain.vertices.push_back(static_cast<Index>(i));
  return chain;
}

/// Distances between neighbours of the chain once the targets are reached.
std::vector<double> edges_after(std::vector<Vec3> points, const Chain& chain) {
  for (const Target& target : space_evenly(points, chain)) points[target.vertex] = target.position;
  std::vector<double> result;
  for (std::size_t i = 1; i < chain.vertices.size(); ++i) {
    result.push_back((points[chain.vertices[i]] - points[chain.vertices[i - 1]]).norm());
  }
  if (chain.closed) {
    result.push_back((points[chain.vertices.back()] - points[chain.vertices.front()]).norm());
  }
  return result;
}

void expect_even(const std::vector<double>& lengths, double tolerance) {
  const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
  EXPECT_GT(*least, 0.0);
  EXPECT_LT(*most / *least - 1.0, tolerance);
}

/// Points on the unit circle from angle 0 to the whole, unevenly spaced.
std::vector<Vec3> arc(std::size_t count, double whole, std::size_t steps) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(steps);
    const double angle = whole * (t + 0.1 * std::sin(2.0 * std::numbers::pi * t));
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  return points;
}

double distance_to(const std::vector<Vec3>& line, const Vec3& p) {
  double least = 1e300;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 along = line[i] - line[i - 1];
    const double t = std::clamp((p - line[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - line[i - 1] - t * along).norm());
  }
  return least;
}

TEST(SpaceEvenly, IsExactOnALine) {
  const std::vector<Vec3> points{{0, 0, 0}, {0.5, 0, 0}, {0.625, 0, 0}, {3.5, 0, 0}, {4, 0, 0}};
  const auto targets = space_evenly(points, chain_of(5));
  ASSERT_EQ(targets.size(), 5u);
  for (Index i = 0; i < 5; ++i) {
    EXPECT_EQ(targets[i].vertex, i);
    EXPECT_EQ(targets[i].position, Vec3(i, 0, 0));
  }
}

TEST(SpaceEvenly, MakesEqualDistancesOnACircle) {
  const std::vector<Vec3> points = arc(21, 2.0, 20);
  const auto before = arc(21, 2.0, 20);
  expect_even(edges_after(points, chain_of(21)), 1e-11);
  for (const Target& target : space_evenly(points, chain_of(21))) {
    EXPECT_LT(distance_to(before, target.position), 1e-14);
  }
}

TEST(SpaceEvenly, ClosesLoops) {
  const std::vector<Vec3> points = arc(16, 2.0 * std::numbers::pi, 16);
  const Chain chain = chain_of(16, true);
  const auto targets = space_evenly(points, chain);
  ASSERT_EQ(targets.size(), 16u);
  EXPECT_EQ(targets.front().vertex, 0u);
  EXPECT_EQ(targets.front().position, points[0]);
  expect_even(edges_after(points, chain), 1e-11);
}

TEST(SpaceEvenly, CopesWithUnevenCurves) {
  shapes::Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vec3> points{Vec3::Zero()};
    for (int i = 0; i < 40; ++i) {
      const double step = 1.0 + 0.9 * random.signed_unit();
      const double angle = 0.1 * i + 0.2 * random.signed_unit();
      points.emplace_back(points.back() + step * Vec3(std::cos(angle), std::sin(angle), 0.05 * i));
    }
    expect_even(edges_after(points, chain_of(points.size())), 1e-11);
  }
}

TEST(SpaceEvenly, KeepsWhatIsEven) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 8; ++i) points.emplace_back(std::cos(0.2 * i), std::sin(0.2 * i), 0.0);
  for (const Target& target : space_evenly(points, chain_of(9))) {
    EXPECT_LT((target.position - points[target.vertex]).norm(), 1e-14);
  }
}

TEST(SpaceEvenly, ToleratesRepeatedPointsAndNoLength) {
  const std::vector<Vec3> same(4, Vec3(1, 2, 3));
  for (const Target& target : space_evenly(same, chain_of(4))) {
    EXPECT_EQ(target.position, Vec3(1, 2, 3));
  }
  const std::vector<Vec3> twice{{0, 0, 0}, {3, 0, 0}, {3, 0, 0}, {3, 0, 0}};
  expect_even(edges_after(twice, chain_of(4)), 1e-11);
  EXPECT_EQ(space_evenly(same, chain_of(2)).size(), 2u);
}

// A zigzag that turns back on itself: no promise but finite places on it.
TEST(SpaceEvenly, StaysOnAZigzag) {
  std::vector<Vec3> points;
  for (int i = 0; i < 9; ++i) points.emplace_back(0.3 * i, i % 2, 0.0);
  for (const Target& target : space_evenly(points, chain_of(9))) {
    EXPECT_LT(distance_to(points, target.position), 1e-12);
  }
}

// ---- chains_of ----------------------------------------------------------------------------------

std::vector<Chain> find_chains(const Mesh& mesh, const std::function<bool(Index)>& chosen) {
  std::vector<char> mask(mesh.point_count());
  for (Index v = 0; v < mask.size(); ++v) mask[v] = chosen(v);
  return chains_of(mesh, find_topology(mesh, find_orientation(mesh)), mask);
}

bool all(Index) { return true; }

TEST(ChainsOf, SplitsTheBoundaryAtCorners) {
  const Mesh mesh = shapes::quad_grid(3);
  const Topology topology = find_topology(mesh, find_orientation(mesh));
  const auto chains = find_chains(mesh, [&](Index v) { return topology.boundary[v] != 0; });
  ASSERT_EQ(chains.size(), 4u);
  EXPECT_EQ(chains[0].vertices, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(chains[1].vertices, (std::vector<Index>{0, 4, 8, 12}));
  EXPECT_EQ(chains[2].vertices, (std::vector<Index>{3, 7, 11, 15}));
  EXPECT_EQ(chains[3].vertices, (std::vector<Index>{12, 13, 14, 15}));
  EXPECT_FALSE(chains[0].closed);
}

TEST(ChainsOf, EndsWhereTheSelectionEnds) {
  const auto chains = find_chains(shapes::quad_grid(5), [](Index v) { return v >= 1 && v <= 3; });
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].vertices, (std::vector<Index>{1, 2, 3}));
  EXPECT_TRUE(find_chains(shapes::quad_grid(5), [](Index v) { return v == 14; }).empty());
}

TEST(ChainsOf, FindsClosedCurves) {
  const Mesh tube = shapes::cylinder_side(8, 2);
  const Topology topology = find_topology(tube, find_orientation(tube), {.feature_angle = 60.0});
  const std::vector<Chain> chains = chains_of(tube, topology, topology.boundary);
  ASSERT_EQ(chains.size(), 2u);
  for (const Chain& chain : chains) {
    EXPECT_TRUE(chain.closed);
    EXPECT_EQ(chain.vertices.size(), 8u);
    EXPECT_EQ(chain.vertices.front(),
              *std::min_element(chain.vertices.begin(), chain.vertices.end()));
  }
}

TEST(ChainsOf, FollowsLinesInside) {
  // The middle column of a grid, from boundary to boundary.
  const auto chains = find_chains(shapes::quad_grid(4), [](Index v) { return v % 5 == 2; });
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].vertices, (std::vector<Index>{2, 7, 12, 17, 22}));
}

TEST(ChainsOf, CutsCurvesWhereALineMeetsThem) {
  const auto chains =
      find_chains(shapes::quad_grid(4), [](Index v) { return v < 5 || v % 5 == 2; });
  ASSERT_EQ(chains.size(), 3u);
  EXPECT_EQ(chains[0].vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(chains[1].vertices, (std::vector<Index>{2, 3, 4}));
  EXPECT_EQ(chains[2].vertices, (std::vector<Index>{2, 7, 12, 17, 22}));
}

// Two boundary vertices of a corner triangle are joined by an edge inside, which is no curve.
TEST(ChainsOf, LeavesOutChordsOfTheBoundary) {
  const Mesh mesh = shapes::triangle_grid(4);
  const Topology topology = find_topology(mesh, find_orientation(mesh));
  std::size_t vertices = 0;
  for (const Chain& chain : chains_of(mesh, topology, topology.boundary)) {
    EXPECT_EQ(chain.vertices.size(), 5u);
    vertices += chain.vertices.size();
  }
  EXPECT_EQ(vertices, 20u);
}

TEST(ChainsOf, FindsFeaturesOfSurfacesAndBlocks) {
  for (const Mesh& mesh : {shapes::cube_surface(4), shapes::hex_grid(4)}) {
    const Topology topology = find_topology(mesh, find_orientation(mesh));
    const auto chains = chains_of(mesh, topology, topology.features);
    EXPECT_EQ(chains.size(), 12u);
    for (const Chain& chain : chains) EXPECT_EQ(chain.vertices.size(), 5u);
  }
}

// Eight corners and flat diagonals between them, which are no features, however cells are wound.
TEST(ChainsOf, LeavesOutFlatEdgesBetweenFeatures) {
  const Mesh cube = shapes::cube_surface(1);
  Cells triangles;
  for (std::size_t c = 0; c < cube.cells().size(); ++c) {
    const auto v = cube.cells().vertices(c);
    triangles.add(CellKind::triangle, std::array<Index, 3>{v[0], v[1], v[2]});
    triangles.add(CellKind::triangle, std::array<Index, 3>{v[0], v[2], v[3]});
  }
  const Mesh mesh({cube.points().begin(), cube.points().end()}, triangles);
  const auto third = [](std::size_t cell) { return cell % 3 == 0; };
  for (const Mesh& same : {mesh, shapes::reversed(mesh, third)}) {
    EXPECT_EQ(find_chains(same, all).size(), 12u);
  }
}

TEST(ChainsOf, FollowsInterfaces) {
  const Mesh mesh = shapes::grouped(shapes::quad_grid(4), [](std::size_t c) { return c >= 8; });
  const Topology topology = find_topology(mesh, find_orientation(mesh));
  const auto chains = chains_of(mesh, topology, topology.interface);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].vertices, (std::vector<Index>{10, 11, 12, 13, 14}));
}

TEST(ChainsOf, RejectsAreas) {
  try {
    find_chains(shapes::quad_grid(4), all);
    FAIL();
  } catch (const InvalidOption& error) {
    EXPECT_NE(std::string(error.what()).find("4 selected edges meet at vertex 6"),
              std::string::npos)
        << error.what();
  }
  EXPECT_THROW(find_chains(shapes::sphere_triangles(1), all), InvalidOption);
}

}  // namespace
}  // namespace evenmesh
