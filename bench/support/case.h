// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"

namespace evenmesh::bench {

/// A mesh that benchmarks know by name, with about that many vertices:
///
///   triangles           the unit square, irregular triangles, vertices row by row
///   triangles_bent      the same displaced along a long wave by up to a tenth of the square: at a
///                       million vertices, a hundred cells
///   triangles_shuffled  triangles with vertices and cells in random order
///   tangled             triangles, a quarter of which noise has turned over
///   disk                the unit disk, irregular triangles, boundary vertices on the circle
///   disk_tangled        disk, of which noise has turned over 23 %
///   quads               the unit square, quads displaced by up to a quarter of their width
///
/// @throws InvalidOption  there is no such case
Mesh make_case_mesh(std::string_view name, std::size_t vertices);

/// Which vertices stay: the boundary.
std::vector<char> boundary_of(const Mesh& mesh, const Orientation& orientation);

/// The default costs: `local` for triangles, .3 local + .3 barycenter for quads; boundary fixed.
Problem make_case_problem(const Mesh& mesh);
/// The costs of a case: local for triangles, .3 local + .3 barycenter for quads.
ProblemOptions case_options(const Mesh& mesh);

/// The case that a tangled one was before noise was added; itself if it is not tangled.
std::string_view valid_case(std::string_view name);

/// Demands of the cases with limits.
struct Limits {
  double least_area = 0.0;  // of every triangle; 0: no limit, and none on inversion either
  bool slide = false;       // boundary vertices on the unit circle; else they are fixed
};

double mean_area(const Mesh& triangles);

/// The cost `local` under limits.
Problem make_limited_problem(const Mesh& mesh, const Limits& limits);

/// The middle of the values by size.
/// @pre  not empty
double median(std::vector<double> values);

}  // namespace evenmesh::bench
