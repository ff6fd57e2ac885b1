// SPDX-License-Identifier: MIT
//
// Options::watch: positions on the way.
#include <gtest/gtest.h>

#include "evenmesh/mesh/topology.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/solver/smooth.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

struct Watched {
  std::vector<int> numbers;
  std::vector<std::vector<Vec3>> points;
  Report report;
};

Watched watch(Mesh mesh, Options options = {}) {
  const Orientation orientation = find_orientation(mesh);
  const Topology topology = find_topology(mesh, orientation);
  Problem problem;
  problem.orientation = orientation;
  problem.motion = Motion(mesh, orientation, topology.boundary);
  add_costs(mesh, {}, problem);
  Watched watched;
  options.watch = [&](const Iteration& iteration, Points points) {
    watched.numbers.push_back(iteration.number);
    watched.points.emplace_back(points.begin(), points.end());
  };
  watched.report = smooth(mesh, problem, options);
  return watched;
}

void expect_whole_history(const Watched& watched, const Mesh& mesh) {
  ASSERT_FALSE(watched.points.empty());
  for (std::size_t v = 0; v < mesh.point_count(); ++v) {
    ASSERT_LT((watched.points[0][v] - mesh.points()[v]).norm(), 1e-12) << v;
  }
  EXPECT_EQ(watched.numbers.back(), watched.report.history.back().number);
  EXPECT_GT((watched.points.back()[0] - watched.points.back()[1]).norm(), 0.0);
  bool moved = false;
  for (std::size_t v = 0; v < mesh.point_count(); ++v) {
    moved = moved || watched.points.back()[v] != mesh.points()[v];
  }
  EXPECT_TRUE(moved);
}

TEST(Watch, SeesEveryIterate) {
  const Mesh mesh = shapes::triangle_grid(10, 1.0, 0.3);
  const Watched watched = watch(mesh);
  expect_whole_history(watched, mesh);
  EXPECT_EQ(watched.numbers.size(), watched.report.history.size());
  for (std::size_t i = 0; i < watched.numbers.size(); ++i) {
    EXPECT_EQ(watched.numbers[i], static_cast<int>(i));
  }
}

TEST(Watch, SeesVerticesByTheirNumbersInTheMesh) {
  const Mesh mesh = shapes::shuffled(shapes::triangle_grid(150, 1.0, 0.3), 3);
  expect_whole_history(watch(mesh, {.max_iterations = 3}), mesh);
}

TEST(Watch, SeesClassicMethodsAndTheDenseOne) {
  const Mesh mesh = shapes::triangle_grid(6, 1.0, 0.3);
  expect_whole_history(watch(mesh, {.method = Method::laplacian}), mesh);
  expect_whole_history(watch(mesh, {.solver = SolverKind::dense}), mesh);
}

}  // namespace
}  // namespace evenmesh
