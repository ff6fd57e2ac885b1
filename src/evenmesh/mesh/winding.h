// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// Which cells are wound alike, told by connectivity alone.
///
/// A side that exactly two cells share says whether these two are wound alike; cells joined by such
/// sides make a piece. Two cells on the same vertices (a face listed twice) say nothing.
struct Winding {
  std::vector<std::uint32_t> piece;  // per cell: the lowest-numbered cell of its piece
  std::vector<char> reversed;        // per cell: wound against that cell
  std::vector<char> twisted;         // per cell: in a piece that no winding makes consistent

  int sense(std::size_t cell) const { return reversed[cell] ? -1 : 1; }
};

/// O(corners) time. Cells of another dimension are pieces of their own.
/// @param mute  per cell: its sides tell nothing, so it is a piece of its own; empty: none
/// @throws InvalidMesh  there are more than 2^32 - 2 cells
Winding find_winding(const Cells& cells, std::size_t vertex_count, int dimension,
                     std::span<const char> mute = {});

}  // namespace evenmesh
