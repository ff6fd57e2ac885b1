// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace evenmesh {

/// The kinds of cell. Vertex order is that of VTK and of most finite-element codes: counter-
/// clockwise for surface cells, bottom then top for volume cells. A wedge's bottom triangle is
/// counter-clockwise seen from its top (the finite-element order, not the one of the VTK manual).
enum class CellKind : std::uint8_t { triangle, quad, polygon, tet, hex, wedge, pyramid };

inline constexpr int kCellKinds = 7;

/// What is the same for every cell of one kind. All numbers are local: vertex 0 is the cell's
/// first. A polygon has as many vertices and edges as its cell says, so its lists are empty; use
/// edge_count() and edge(), which know.
struct CellTraits {
  struct Edge {
    std::uint8_t a, b;
  };
  struct Face {
    std::uint8_t count;                    // 3 or 4
    std::array<std::uint8_t, 4> vertices;  // counter-clockwise seen from outside
  };
  /// A vertex and the ends of the edges that leave it, right-handed in a cell that is not
  /// inverted: det(x_n0 - x_v, x_n1 - x_v, x_n2 - x_v) > 0. For surface cells only n0 (the next
  /// vertex) and n1 (the previous one) are used. A pyramid's apex has four edges and no entry.
  struct Corner {
    std::uint8_t vertex;
    std::array<std::uint8_t, 3> neighbours;
  };

  std::string_view name;  // the word in reports and messages
  int dimension;          // 2: surface cell, 3: volume cell
  int vertices;           // 0: the cell says (polygon)
  std::span<const Edge> edges;
  std::span<const Face> faces;  // empty for surface cells
  std::span<const Corner> corners;
  std::span<const std::array<double, 3>> ideal;  // positions of the ideal cell, all edges 1
};

/// The table's row for a kind.
const CellTraits& traits(CellKind kind);

/// The number of edges of a cell with that many vertices.
/// @pre  vertices matches the kind.
inline int edge_count(CellKind kind, int vertices) {
  return kind == CellKind::polygon ? vertices : static_cast<int>(traits(kind).edges.size());
}

/// The j-th edge of a cell, as local vertex numbers.
/// @pre  0 <= j < edge_count(kind, vertices)
struct LocalEdge {
  int a, b;
};
inline LocalEdge edge(CellKind kind, int vertices, int j) {
  if (kind == CellKind::polygon) return {j, j + 1 == vertices ? 0 : j + 1};
  const CellTraits::Edge e = traits(kind).edges[static_cast<std::size_t>(j)];
  return {e.a, e.b};
}

}  // namespace evenmesh
