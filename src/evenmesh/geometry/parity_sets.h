// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace evenmesh {

/// Disjoint sets of numbered items, each item the same way round as its set's least item or the
/// other way round.
class ParitySets {
 public:
  struct Place {
    std::uint32_t root;  // the least item of the set
    bool reversed;       // against the root
  };

  explicit ParitySets(std::size_t count) : parent_(count), reversed_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  Place find(std::uint32_t item) {
    // Every item on the way is hung on its grandparent.
    bool reversed = false;
    while (parent_[item] != item) {
      const std::uint32_t parent = parent_[item];
      const bool to_grandparent = (reversed_[item] != 0) != (reversed_[parent] != 0);
      if (parent_[parent] != parent) {
        parent_[item] = parent_[parent];
        reversed_[item] = to_grandparent;
      }
      reversed = reversed != (reversed_[item] != 0);
      item = parent_[item];
    }
    return {item, reversed};
  }

  /// Puts both into one set. Where they are already, and say otherwise, the first word counts.
  void unite(std::uint32_t a, std::uint32_t b, bool opposite) {
    const Place at = find(a);
    const Place bt = find(b);
    if (at.root == bt.root) return;
    const auto [low, high] = std::minmax(at.root, bt.root);
    parent_[high] = low;
    reversed_[high] = (at.reversed != bt.reversed) != opposite;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<char> reversed_;  // against the parent
};

}  // namespace evenmesh
