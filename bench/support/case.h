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

/// The middle of the values by size.
/// @pre  not empty
double median(std::vector<double> values);

}  // namespace evenmesh::bench
