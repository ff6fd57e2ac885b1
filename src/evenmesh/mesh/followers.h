// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// The nodes of second-order cells that are no corners, and the corners that each lies between: two
/// for the middle of an edge, four for that of a quad, eight for that of a hex. Meshes know linear
/// cells only, so these nodes are in no cell; they move by the mean of the moves of their leaders.
/// A straight edge stays straight, a curved one keeps its node on its place relative to its middle.
class Followers {
 public:
  /// The first call for a vertex counts: cells share their edges.
  void add(Index vertex, std::span<const Index> leaders);

  std::size_t size() const { return vertices_.size(); }
  bool empty() const { return vertices_.empty(); }
  Index vertex(std::size_t i) const { return vertices_[i]; }
  std::span<const Index> leaders(std::size_t i) const {
    return std::span(leaders_).subspan(offsets_[i], offsets_[i + 1] - offsets_[i]);
  }

  /// Puts them where they belong when corners have gone from `before` to `points`. One whose
  /// leaders all have the bits they had keeps its own.
  /// @pre  both have a place for every vertex
  void follow(Points before, std::span<Vec3> points) const;

  /// How many are off the middle of their leaders by more than 1e-6 of their distance.
  std::size_t curved(Points points) const;

 private:
  std::vector<Index> vertices_;
  std::vector<std::size_t> offsets_{0};
  std::vector<Index> leaders_;
  std::vector<char> known_;  // per vertex up to the highest
};

}  // namespace evenmesh
