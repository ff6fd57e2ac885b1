// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "evenmesh/mesh/mesh.h"

/// Meshes built in code, for tests and benchmarks. The same arguments give the same mesh
/// everywhere. Cells are positive by the conventions of cell_kind.h unless a jitter or noise turns
/// them over.
namespace evenmesh::shapes {

// ---- in the xy plane, at z = 0 ------------------------------------------------------------------

/// The unit square split into four triangles that meet in vertex 4, which lies (dx, dy) away from
/// the centre.
Mesh fig5(double dx, double dy);

/// n x n quads on [0, size]^2, vertices row by row. Interior vertices are displaced by up to jitter
/// times the width of a cell in x and in y.
Mesh quad_grid(int n, double size = 1.0, double jitter = 0.0, std::uint64_t seed = 1);

/// As quad_grid() with every quad cut in two, diagonals alternating like a chessboard.
Mesh triangle_grid(int n, double size = 1.0, double jitter = 0.0, std::uint64_t seed = 1);

/// About that many vertices on the unit square, unevenly spaced and of uneven valence: a hexagonal
/// lattice of spacing h, its interior vertices displaced within discs of radius jitter * h, made
/// Delaunay, all triangles positive. Vertices row by row. A million take 0.2 s and 120 MB.
/// @param jitter  in [0, 0.4]
/// @param noise   if > 0, interior vertices then move by up to noise * h in x and in y while the
///                triangles stay: a twentieth of them turn over at 0.5, a quarter at 0.95,
///                two fifths at 2
/// @pre  vertices >= 9
Mesh irregular_triangles(std::size_t vertices, double jitter = 0.3, std::uint64_t seed = 1,
                         double noise = 0.0);

/// About that many vertices in the unit disk: rings a width h apart, the outermost of them exactly
/// on the circle at equal angles, the others displaced within discs of radius 0.3 h, made Delaunay,
/// all triangles positive. Vertices ring by ring from the centre, counterclockwise: those on the
/// circle come last. 1,000 asked for give 1,027 and 1,944 triangles. A million take 0.2 s.
/// @param noise  if > 0, interior vertices then move by up to noise * h in x and in y, and those on
///               the circle along it by up to 0.4 h min(noise, 1), in their old order, while the
///               triangles stay: a tenth of them turn over at 0.7, a quarter at 1.1, two fifths at
///               2
/// @pre  vertices >= 19
Mesh disk_triangles(std::size_t vertices, std::uint64_t seed = 1, double noise = 0.0);

/// n x n regular hexagons of side 1, brick-like, as polygons.
Mesh hexagons(int n);

/// Two triangles that share one vertex and no side.
Mesh bowtie_vertex();

/// Two triangle_grid(n) side by side without a common vertex.
Mesh two_components(int n);

// ---- surfaces in space --------------------------------------------------------------------------

/// The unit sphere: an icosahedron with every triangle split in four, levels times.
Mesh sphere_triangles(int levels);

/// The surface of the unit cube, n x n quads per face, outward.
Mesh cube_surface(int n);

/// The open side of a cylinder of radius 1 and height 2: around x along quads, outward.
/// @pre  around >= 3, along >= 1
Mesh cylinder_side(int around, int along);

/// A strip of n quads closed with a half turn; no choice of windings agrees everywhere.
/// @pre  n >= 4
Mesh moebius_strip(int n);

/// Three triangles on the one edge {0, 1}.
Mesh fan_of_three();

/// A curved graph z = f(x, y) over the unit square: n x n quads, of which every third is cut into
/// two triangles, interior vertices shifted a little along the graph.
Mesh mixed_surface(int n, std::uint64_t seed = 1);

// ---- volumes: the unit cube of n x n x n blocks ------------------------------------------------

Mesh tet_grid(int n);  // six tets per block, around its main diagonal
Mesh hex_grid(int n, double jitter = 0.0, std::uint64_t seed = 1);
Mesh wedge_grid(int n);    // two wedges per block
Mesh pyramid_grid(int n);  // six pyramids per block, apex in the middle

// ---- made from another mesh --------------------------------------------------------------------

/// Where the vertices and cells of the original are in the shuffled mesh.
struct Renumbering {
  std::vector<Index> vertices;
  std::vector<std::size_t> cells;
};

/// The same mesh with vertices numbered and cells listed at random. Groups are kept.
Mesh shuffled(const Mesh& mesh, std::uint64_t seed, Renumbering* renumbering = nullptr);

/// Turned about an axis through the origin.
/// @pre  axis is not zero
Mesh rotated(const Mesh& mesh, const Vec3& axis, double angle_rad);
Mesh moved(const Mesh& mesh, const Vec3& by);
Mesh scaled(const Mesh& mesh, double factor);

/// The same cells, those that are chosen wound the other way. Points and groups are kept.
Mesh reversed(const Mesh& mesh, const std::function<bool(std::size_t cell)>& chosen);

/// The same cells with groups.
Mesh grouped(const Mesh& mesh, const std::function<std::uint32_t(std::size_t cell)>& group);

// ---- all of them -------------------------------------------------------------------------------

struct Named {
  std::string name;
  Mesh mesh;
};

/// A small specimen of every shape above, for tests of what holds for all meshes.
std::vector<Named> zoo();

}  // namespace evenmesh::shapes
