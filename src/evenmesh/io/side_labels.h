// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// Finds where the boundary conditions of a file change: vertices at the rim of the sides that have
/// one label may not slide, even where the boundary is flat or straight, or an inlet would grow.
class SideLabels {
 public:
  /// @param vertices  of a side: one, two of a line, or in order around a face
  /// @param label     what the file calls the side by, above 0
  void add(std::span<const Index> vertices, std::uint32_t label);

  /// Vertices at rims, or on sides of several labels; sorted, each once.
  std::vector<Index> rims() const;

 private:
  static constexpr std::uint32_t kSeveral = ~std::uint32_t{0};
  std::vector<std::uint32_t> label_of_;  // per vertex
  /// What bounds a side, once for each: its label and one or two vertices.
  std::vector<std::array<std::uint32_t, 3>> bounds_;
};

/// Vertices of lines that a file draws within a surface, with the same group on either side: a
/// crack, a line that loads act on. Where groups meet the line is an interface anyway, and at the
/// boundary the boundary.
/// @param lines  pairs of vertices
/// @return  sorted, each once
std::vector<Index> on_lines_within(const Cells& cells, std::span<const Index> lines);

/// What a file with lines and cells in groups holds: in a volume the rims of its surface cells by
/// their groups, else those of its lines and what lies on lines within.
/// @param labels  of the lines, in the numbers of something; 0: none
/// @return  sorted, each once
std::vector<Index> held_by_groups(const Cells& cells, std::span<const Index> lines,
                                  std::span<const std::uint32_t> labels);

}  // namespace evenmesh
