// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// One cell's use of a side: of an edge for surface cells, of a face for volume cells.
struct SideUse {
  Index second;  // the side's second smallest vertex
  std::uint32_t cell;
  std::uint16_t place;  // of the smallest vertex within its block; for the sorting alone
  std::uint8_t face;    // volume cells: the face's number within the cell; surface cells: 0
  /// Which way the cell goes along or round it. Two cells that are wound alike use their common
  /// side in opposite directions.
  bool forward;
};

/// The cells that share one side, by increasing cell number.
struct Side {
  Index first;                    // its smallest vertex; with uses[0].second an edge is complete
  std::span<const SideUse> uses;  // never empty
  std::size_t cells;              // how many cells that is: one may use a side twice

  /// Shared by two cells, once by each.
  bool is_shared_by_two() const { return cells == 2 && uses.size() == 2; }
};

/// The vertices of a face without repetitions, in the order of the cell. A cell that repeats a
/// vertex, such as a hex collapsed to a wedge, has quad faces with three, and faces with none:
/// those of which no triangle is left.
struct FaceVertices {
  std::array<Index, 4> vertices;
  std::size_t count = 0;  // 0, 3 or 4

  std::span<const Index> span() const { return {vertices.data(), count}; }
};

/// @pre  cell is a volume cell and face one of its faces
FaceVertices face_vertices(const Cells& cells, std::size_t cell, std::size_t face);

/// Calls visit for every side of the cells of that dimension, 2 or 3, in increasing order of the
/// smallest vertex; cells of the other dimension are passed over.
///
/// Sides are the same when they have the same vertices, whatever the order. Those that a repeated
/// vertex leaves without extent are passed over.
///
/// Time linear for any mesh whose vertices have a bounded number of sides, and no more than twice
/// as long for vertices numbered at random; 12 bytes per use of a side while it runs.
/// @param expect  if given, called for every use of a side some sides before visit gets it: what is
///                known of cells can be far apart in memory, and asked for here
/// @throws InvalidMesh  there are more than 2^32 - 2 cells
void for_each_side(const Cells& cells, std::size_t vertex_count, int dimension,
                   const std::function<void(const Side&)>& visit,
                   const std::function<void(std::uint32_t cell)>& expect = {});

}  // namespace evenmesh
