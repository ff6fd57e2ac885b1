// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// Tells pairs of cells on the same vertices, in whatever order: cells that a file lists twice.
///
/// Cells are first compared by a small hash each, which one array holds: on meshes in random order
/// looking at the cells themselves takes most of the time. Time stays linear even where polygons
/// have a million vertices; those are told by 64 bits of hash.
class Twins {
 public:
  explicit Twins(const Cells& cells);

  /// Says that a cell will be asked about soon.
  void expect(std::uint32_t cell) const { __builtin_prefetch(&hashes_[cell]); }

  bool are_twins(std::uint32_t a, std::uint32_t b) {
    return hashes_[a] == hashes_[b] && have_same_vertices(a, b);
  }

 private:
  bool have_same_vertices(std::uint32_t a, std::uint32_t b);
  std::uint64_t large_cell_hash(std::uint32_t cell);

  const Cells& cells_;
  std::vector<std::uint32_t> hashes_;
  std::unordered_map<std::uint32_t, std::uint64_t> large_cells_;
};

}  // namespace evenmesh
