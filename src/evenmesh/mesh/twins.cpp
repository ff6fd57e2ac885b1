// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/twins.h"

#include <algorithm>

namespace evenmesh {
namespace {

/// The same for the vertices in any order.
std::uint64_t hash(std::span<const Index> vertices) {
  std::uint64_t sum = 0;
  for (const Index v : vertices) {
    std::uint64_t h = (v + std::uint64_t{1}) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u;
    sum += h ^ (h >> 32);
  }
  return sum;
}

}  // namespace

Twins::Twins(const Cells& cells) : cells_(cells), hashes_(cells.size()) {
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    hashes_[cell] = static_cast<std::uint32_t>(hash(cells.vertices(cell)));
  }
}

bool Twins::have_same_vertices(std::uint32_t a, std::uint32_t b) {
  const auto va = cells_.vertices(a);
  const auto vb = cells_.vertices(b);
  if (va.size() != vb.size()) return false;
  if (va.size() > 8) return large_cell_hash(a) == large_cell_hash(b);
  return std::is_permutation(va.begin(), va.end(), vb.begin());
}

std::uint64_t Twins::large_cell_hash(std::uint32_t cell) {
  const auto [it, is_new] = large_cells_.try_emplace(cell, 0);
  if (is_new) it->second = hash(cells_.vertices(cell));
  return it->second;
}

}  // namespace evenmesh
