// SPDX-License-Identifier: MIT
#include "evenmesh/io/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace evenmesh {
namespace {

constexpr Index kFree = std::numeric_limits<Index>::max();

/// Mixes well enough that a lattice of points spreads over the table (the constants are those of
/// the finaliser of splitmix64).
std::uint64_t mix(std::uint64_t h) {
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
  return h ^ (h >> 31);
}

std::uint64_t hash(const Vec3& position) {
  std::uint64_t h = 0;
  for (int k = 0; k < 3; ++k) {
    h = mix(h + 0x9e3779b97f4a7c15U + std::bit_cast<std::uint64_t>(position[k] + 0.0));  // -0 -> 0
  }
  return h;
}

/// Sets of vertices, each named by its lowest member.
class Sets {
 public:
  explicit Sets(std::size_t n) : parents_(n) {
    for (std::size_t i = 0; i < n; ++i) parents_[i] = static_cast<Index>(i);
  }
  Index find(Index i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parents_;
};

/// A grid whose cells are so small that two points of one cell are at most the tolerance apart.
class Grid {
 public:
  Grid(Points points, double tolerance)
      : points_(points), squared_tolerance_(tolerance * tolerance), side_(tolerance / kDiagonal) {}

  void unite_close(Sets& sets) {
    fill(sets);
    for (const auto& cell : cells_) {
      for_each_neighbour(cell.first, [&](const std::vector<Index>& others) {
        unite_cells(cell.second, others, sets);
      });
    }
  }

 private:
  struct Hash {
    std::size_t operator()(const Vec3& cell) const { return hash(cell); }
  };
  static constexpr double kDiagonal = 1.7320508075688774;  // of a unit cube
  static constexpr int kReach = 2;  // in cells: the tolerance is less than two of their sides

  void fill(Sets& sets) {
    for (Index i = 0; i < points_.size(); ++i) {
      auto& members = cells_[(points_[i] / side_).array().floor()];
      if (!members.empty() && close(members[0], i)) sets.unite(members[0], i);
      members.push_back(i);
    }
  }

  /// Every pair of cells is met once: from the one that comes first in the order of (x, y, z).
  template <typename Visit>
  void for_each_neighbour(const Vec3& cell, const Visit& visit) const {
    for (int x = 0; x <= kReach; ++x) {
      for (int y = x == 0 ? 0 : -kReach; y <= kReach; ++y) {
        for (int z = x == 0 && y == 0 ? 1 : -kReach; z <= kReach; ++z) {
          const auto found = cells_.find(cell + Vec3(x, y, z));
          if (found != cells_.end()) visit(found->second);
        }
      }
    }
  }

  void unite_cells(const std::vector<Index>& a, const std::vector<Index>& b, Sets& sets) const {
    for (const Index i : a) {
      for (const Index j : b) {
        if (sets.find(i) == sets.find(j)) return;  // each cell is one set already
        if (close(i, j)) return sets.unite(i, j);
      }
    }
  }

  bool close(Index a, Index b) const {
    return (points_[a] - points_[b]).squaredNorm() <= squared_tolerance_;
  }

  Points points_;
  double squared_tolerance_;
  double side_;
  std::unordered_map<Vec3, std::vector<Index>, Hash> cells_;
};

}  // namespace

Index Welder::add(const Vec3& position) {
  if (2 * points_.size() >= slots_.size()) grow();
  Index& slot = slots_[slot_of(position)];
  if (slot == kFree) {
    slot = static_cast<Index>(points_.size());
    points_.push_back(position);
  }
  return slot;
}

void Welder::grow() {
  constexpr std::size_t kSmallest = 64;
  slots_.assign(std::max(kSmallest, 2 * slots_.size()), kFree);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    slots_[slot_of(points_[i])] = static_cast<Index>(i);
  }
}

std::size_t Welder::slot_of(const Vec3& position) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = hash(position) & mask;
  while (slots_[i] != kFree && points_[slots_[i]] != position) i = (i + 1) & mask;
  return i;
}

std::vector<Index> merge_close(std::vector<Vec3>& points, double tolerance) {
  Sets sets(points.size());
  Grid(points, tolerance).unite_close(sets);

  std::vector<Index> numbers(points.size());
  std::size_t kept = 0;
  for (Index i = 0; i < points.size(); ++i) {
    const Index first = sets.find(i);
    if (first == i) {
      points[kept] = points[i];
      numbers[i] = static_cast<Index>(kept++);
    } else {
      numbers[i] = numbers[first];
    }
  }
  points.resize(kept);
  return numbers;
}

}  // namespace evenmesh
