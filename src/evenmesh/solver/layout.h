// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/cost/cost.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// A mesh's cells rearranged for speed; the mesh itself stays as it is.
///
/// Vertices are cut into chunks of kChunkSize consecutive numbers. Each cell belongs to the chunk
/// of its least vertex, so in a mesh of good order a chunk's cells reach into few other chunks.
/// Chunks that reach a common vertex get different colours. Cells of one colour's chunks can then
/// add to per-vertex arrays in parallel without atomics and without a second copy, and every vertex
/// receives its contributions in the same order whatever the number of threads: same bits, at the
/// price of a plain serial scatter.
class Layout {
 public:
  static constexpr std::size_t kChunkSize = 2048;

  /// @param orientation  handed to costs; must outlive the layout; null: none
  Layout(const Cells& cells, std::size_t points, const Orientation* orientation = nullptr);

  /// The cells of a chunk that have the same kind and number of vertices.
  struct Block {
    CellBlock cells;
    std::size_t first;  // place of the first cell among all cells
  };

  std::size_t chunks() const { return chunk_start_.size() - 1; }
  std::size_t cells() const { return numbers_.size(); }

  /// Calls body(chunk, block) for every block: one chunk's blocks in order on one thread, chunks
  /// with a common vertex never at the same time and always in the same order.
  void for_blocks(Workers& workers,
                  const std::function<void(std::size_t chunk, const Block& block)>& body) const;

 private:
  struct Run {
    CellKind kind;
    int vertices_per_cell;
    std::size_t first_corner;
    std::size_t first_cell;
    std::size_t cells;
  };

  void sort_cells(const Cells& cells, std::size_t points);
  void colour_chunks();

  const Orientation* orientation_;
  std::vector<Index> corners_;
  std::vector<std::uint32_t> numbers_;
  std::vector<Run> runs_;
  std::vector<std::size_t> chunk_start_;             // runs of chunk c: [c, c + 1)
  std::vector<std::vector<std::uint32_t>> colours_;  // chunks of each colour
};

/// Greedy colouring: items that share a resource get different colours.
/// @param resources  of each item, in any order, repeats allowed
/// @param count      resources are numbered [0, count)
/// @return  per colour its items, ascending
std::vector<std::vector<std::uint32_t>> colour_items(
    std::span<const std::vector<std::uint32_t>> resources, std::size_t count);

}  // namespace evenmesh
