// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/winding.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "evenmesh/mesh/sides.h"
#include "evenmesh/mesh/twins.h"

namespace evenmesh {
namespace {

/// Union-find in which every cell knows whether it is wound against its parent.
class Forest {
 public:
  explicit Forest(Winding& winding)
      : parent_(winding.piece), reversed_(winding.reversed), twisted_(winding.twisted) {}

  /// Says that a cell will be joined soon.
  void expect(std::uint32_t cell) const {
    __builtin_prefetch(&parent_[cell], 1);
    __builtin_prefetch(&reversed_[cell], 1);
  }

  void join(std::uint32_t a, std::uint32_t b, bool opposed) {
    const auto [root_a, reversed_a] = root(a);
    const auto [root_b, reversed_b] = root(b);
    const bool reversed = (reversed_a != reversed_b) != opposed;
    if (root_a == root_b) {
      if (reversed) twisted_[a] = 1;
      return;
    }
    const auto [low, high] = std::minmax(root_a, root_b);
    parent_[high] = low;
    reversed_[high] = reversed;
  }

  /// Makes every cell point at the root of its piece.
  void flatten() {
    // Parents have lower numbers, so they are done before their children.
    for (std::size_t cell = 0; cell < parent_.size(); ++cell) {
      const std::uint32_t parent = parent_[cell];
      if (parent == cell) continue;
      reversed_[cell] = reversed_[cell] != reversed_[parent];
      parent_[cell] = parent_[parent];
    }
    for (std::size_t cell = 0; cell < parent_.size(); ++cell) {
      if (twisted_[cell]) twisted_[parent_[cell]] = 1;
    }
    for (std::size_t cell = 0; cell < parent_.size(); ++cell) {
      twisted_[cell] = twisted_[parent_[cell]];
    }
  }

 private:
  std::pair<std::uint32_t, bool> root(std::uint32_t cell) {
    bool reversed = false;
    while (parent_[cell] != cell) {
      const std::uint32_t parent = parent_[cell];
      // Halves the path. A root is not reversed against itself, so this holds there too.
      reversed_[cell] = reversed_[cell] != reversed_[parent];
      parent_[cell] = parent_[parent];
      reversed = reversed != (reversed_[cell] != 0);
      cell = parent_[cell];
    }
    return {cell, reversed};
  }

  std::vector<std::uint32_t>& parent_;
  std::vector<char>& reversed_;
  std::vector<char>& twisted_;
};

}  // namespace

Winding find_winding(const Cells& cells, std::size_t vertex_count, int dimension,
                     std::span<const char> mute) {
  Winding winding;
  winding.piece.resize(cells.size());
  std::iota(winding.piece.begin(), winding.piece.end(), 0u);
  winding.reversed.assign(cells.size(), 0);
  winding.twisted.assign(cells.size(), 0);

  Forest forest(winding);
  Twins twins(cells);
  const auto expect = [&](std::uint32_t cell) {
    twins.expect(cell);
    forest.expect(cell);
  };
  const auto visit = [&](const Side& side) {
    if (!side.is_shared_by_two()) return;
    const SideUse& a = side.uses[0];
    const SideUse& b = side.uses[1];
    if (!mute.empty() && (mute[a.cell] || mute[b.cell])) return;
    if (twins.are_twins(a.cell, b.cell)) return;
    forest.join(a.cell, b.cell, a.forward == b.forward);
  };
  for_each_side(cells, vertex_count, dimension, visit, expect);
  forest.flatten();
  return winding;
}

}  // namespace evenmesh
