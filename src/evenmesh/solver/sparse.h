// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace evenmesh {

/// A sparse matrix by rows, in single precision: it only ever preconditions.
struct SparseMatrix {
  struct Entry {
    std::uint32_t column;
    float value;
  };

  std::vector<std::uint64_t> start{0};  // entries of row i: [start[i], start[i + 1])
  std::vector<Entry> entries;

  std::size_t rows() const { return start.size() - 1; }
  std::span<const Entry> row(std::size_t i) const {
    return {entries.data() + start[i], entries.data() + start[i + 1]};
  }
};

}  // namespace evenmesh
