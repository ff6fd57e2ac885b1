// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "evenmesh/constraint/selector.h"
#include "evenmesh/mesh/measure.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/problem/problem.h"
#include "tests/support/random.h"

/// What tests of the solver set up again and again.
namespace evenmesh::testing_setup {

/// The problem that the program makes of a mesh: found orientation, selected vertices fixed.
inline Problem problem_of(const Mesh& mesh, const ProblemOptions& options = {},
                          std::string_view fixed = "boundary+features") {
  const Orientation orientation = find_orientation(mesh);
  const Topology topology = find_topology(mesh, orientation);
  return make_problem(mesh, orientation, select_vertices(fixed, mesh, topology), options);
}

inline ProblemOptions only(std::string_view cost) {
  ProblemOptions options;
  options.costs = {{std::string(cost), 1.0}};
  return options;
}

/// The same problem with costs of edge lengths, whose slopes are small where cells are poor.
inline Problem with_edge_costs(const Mesh& mesh, Problem problem) {
  problem.terms = untangling_terms(mesh, problem);
  return problem;
}

inline std::vector<Vec3> copy_of(Points points) { return {points.begin(), points.end()}; }

inline Mesh with_points(const Mesh& mesh, std::vector<Vec3> points) {
  Mesh result = mesh;
  result.set_points(std::move(points));
  return result;
}

/// Every point displaced by up to `size` in each direction that its vertex may follow.
inline std::vector<Vec3> displaced(const Mesh& mesh, const Motion& motion, double size,
                                   std::uint64_t seed) {
  shapes::Random random(seed);
  std::vector<Vec3> points = copy_of(mesh.points());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Vec3 step(random.signed_unit(), random.signed_unit(), random.signed_unit());
    points[v] += motion.project(static_cast<Index>(v), size * step);
  }
  return points;
}

/// The greatest distance between points of the same number.
inline double farthest(Points a, Points b) {
  double most = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, (a[v] - b[v]).norm());
  return most;
}

/// The least corner of one cell, as least_corner() measures it.
inline double corner_of(const Mesh& mesh, const Orientation& orientation, std::size_t cell,
                        Points points) {
  const auto vertices = mesh.cells().vertices(cell);
  return least_corner(
      mesh.cells().kind(cell), static_cast<int>(vertices.size()),
      [&](int i) -> const Vec3& { return points[vertices[static_cast<std::size_t>(i)]]; },
      orientation.up(cell), orientation.sign(cell));
}

}  // namespace evenmesh::testing_setup
