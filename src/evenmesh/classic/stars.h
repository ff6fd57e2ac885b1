// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/motion.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// An edge as seen from a vertex.
struct Link {
  Index from = 0;  // the vertex, or one that is tied to it
  Index to = 0;
};

/// A cell as seen from a vertex.
struct StarCell {
  std::uint32_t cell = 0;
  Index at = 0;  // the vertex, or one that is tied to it
};

/// A vertex that moves, and what is around it and all that move with it.
struct Star {
  Index vertex = 0;                 // its own leader
  std::span<const Link> links;      // every neighbour once; edges between tied vertices left out
  std::span<const StarCell> cells;  // every cell once, or once per tied vertex it has
};

/// The stars of all vertices that move on their own, in colours: stars of one colour have no cell
/// in common, so their vertices can move at the same time, whatever the number of threads.
class Stars {
 public:
  Stars(const Mesh& mesh, const Motion& motion);

  /// Vertices by colour, ascending in each.
  const std::vector<std::vector<Index>>& colours() const { return colours_; }
  /// @pre  the vertex may move and is its own leader
  Star of(Index vertex) const {
    return {vertex,
            {links_.data() + link_start_[vertex], links_.data() + link_start_[vertex + 1]},
            {cells_.data() + cell_start_[vertex], cells_.data() + cell_start_[vertex + 1]}};
  }

 private:
  void gather_links(const Mesh& mesh, const Motion& motion);
  void gather_cells(const Mesh& mesh, const Motion& motion);
  void colour(const Mesh& mesh, const Motion& motion);

  std::vector<Link> links_;  // of one vertex after the other
  std::vector<std::size_t> link_start_;
  std::vector<StarCell> cells_;
  std::vector<std::size_t> cell_start_;
  std::vector<std::vector<Index>> colours_;
};

}  // namespace evenmesh
