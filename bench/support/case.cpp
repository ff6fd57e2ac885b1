// SPDX-License-Identifier: MIT
#include "bench/support/case.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "evenmesh/base/error.h"
#include "evenmesh/constraint/validity.h"
#include "evenmesh/geometry/analytic_tracks.h"
#include "evenmesh/mesh/topology.h"
#include "tests/support/shapes.h"

namespace evenmesh::bench {
namespace {

constexpr double kNoiseOfTangled = 0.95;
constexpr double kNoiseOfTangledDisk = 1.0;

/// The same mesh pushed to and fro in one long wave that leaves the boundary where it is.
Mesh bent(const Mesh& mesh) {
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  for (Vec3& p : points) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double wave = 0.1 * std::sin(kTurn * p.x()) * std::sin(kTurn * p.y());
    p.head<2>() += wave * Eigen::Vector2d(1.0, 0.7);
  }
  Mesh result = mesh;
  result.set_points(std::move(points));
  return result;
}

}  // namespace

Mesh make_case_mesh(std::string_view name, std::size_t vertices) {
  if (name == "triangles") return shapes::irregular_triangles(vertices);
  if (name == "triangles_bent") return bent(shapes::irregular_triangles(vertices));
  if (name == "triangles_shuffled") {
    return shapes::shuffled(shapes::irregular_triangles(vertices), 1);
  }
  if (name == "tangled") return shapes::irregular_triangles(vertices, 0.3, 1, kNoiseOfTangled);
  if (name == "disk") return shapes::disk_triangles(vertices);
  if (name == "disk_tangled") return shapes::disk_triangles(vertices, 1, kNoiseOfTangledDisk);
  if (name == "quads") {
    const auto n = std::lround(std::sqrt(static_cast<double>(vertices))) - 1;
    return shapes::quad_grid(static_cast<int>(std::max(n, 1L)), 1.0, 0.25);
  }
  throw InvalidOption("there is no case named '" + std::string(name) +
                      "'; known are triangles, triangles_bent, triangles_shuffled, tangled, disk, "
                      "disk_tangled, quads");
}

std::vector<char> boundary_of(const Mesh& mesh, const Orientation& orientation) {
  return find_topology(mesh, orientation).boundary;
}

ProblemOptions case_options(const Mesh& mesh) {
  ProblemOptions options;
  options.costs = {{"local", 1.0}};
  if (mesh.cells().kind(0) == CellKind::quad) {
    options.costs = {{"local", 0.3}, {"barycenter", 0.3}};
  }
  return options;
}

Problem make_case_problem(const Mesh& mesh) {
  Orientation orientation = find_orientation(mesh);
  const std::vector<char> fixed = boundary_of(mesh, orientation);
  return make_problem(mesh, std::move(orientation), fixed, case_options(mesh));
}

std::string_view valid_case(std::string_view name) {
  if (name == "tangled") return "triangles";
  return name == "disk_tangled" ? "disk" : name;
}

double mean_area(const Mesh& triangles) {
  return mean_size(triangles, find_orientation(triangles));
}

Problem make_limited_problem(const Mesh& mesh, const Limits& limits) {
  Orientation orientation = find_orientation(mesh);
  const std::vector<char> boundary = boundary_of(mesh, orientation);
  Problem problem = make_problem(mesh, std::move(orientation), boundary, case_options(mesh));
  problem.validity.demanded = limits.least_area > 0.0;
  problem.validity.min_size = limits.least_area;
  if (!limits.slide) return problem;
  const auto circle = std::make_shared<CircleTrack>(Vec3::Zero(), Vec3::UnitZ(), 1.0);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (!boundary[v]) continue;
    const TrackPoint here{mesh.points()[v], Vec3::Zero(), 0};
    problem.motion.put_on_track(v, circle, circle->nearest(here.position, here));
  }
  return problem;
}

double median(std::vector<double> values) {
  assert(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace evenmesh::bench
