// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// Finds things by the numbers that a file gives them, which may have gaps and come in any order.
class NodeNumbers {
 public:
  static constexpr Index kNone = ~Index{0};

  /// Makes find() ready.
  /// @param numbers  of the first, second ... thing; fewer than 2^32 - 1
  /// @return  the place of a number that is there a second time, or numbers.size() if none is
  std::size_t index(std::span<const std::uint64_t> numbers);

  /// @return  the place of the number in what was given to index(), or kNone
  Index find(std::uint64_t number) const;

  /// Whether the numbers are 1, 2, 3 ...
  bool counts_from_one() const { return table_.empty() && sorted_.empty(); }

 private:
  std::size_t count_ = 0;
  std::vector<Index> table_;  // [number], where the numbers are not much larger than their count
  std::vector<std::pair<std::uint64_t, Index>> sorted_;  // by number, where they are
};

}  // namespace evenmesh
