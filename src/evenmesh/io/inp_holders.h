// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "evenmesh/io/deck_lines.h"
#include "evenmesh/io/inp_sets.h"

namespace evenmesh {

/// What a deck names because something hangs on its place: nodes and node sets in loads, supports,
/// equations, couplings and reference nodes.
class InpHolders {
 public:
  /// Takes notice of what a keyword, its parameters and its data lines name, if it is such a one.
  void note(const DeckKeyword& keyword, DeckLines& lines, std::size_t scope);

  /// @param vertices  of the mesh
  /// @return  ascending
  std::vector<Index> vertices(const InpSets& sets, const Cells& cells, std::size_t vertices) const;

 private:
  void note_equations(DeckLines& lines, std::size_t scope);

  std::set<std::pair<std::size_t, std::string>> words_;  // scope and word
};

}  // namespace evenmesh
