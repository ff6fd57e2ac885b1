// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/prescribe.h"

namespace evenmesh {

/// The vertices that are to be brought somewhere, each with who asked for it.
class TargetList {
 public:
  explicit TargetList(Points points) : points_(points), target_of_(points.size(), kNone) {}

  bool has(Index vertex) const { return target_of_[vertex] != kNone; }
  /// @pre  has(vertex), as for all that follows
  const Vec3& position(Index vertex) const { return targets_[target_of_[vertex]].position; }
  Vec3 displacement(Index vertex) const { return position(vertex) - points_[vertex]; }
  const std::string& text(Index vertex) const { return texts_[target_of_[vertex]]; }

  /// @pre  !has(vertex)
  void set(Index vertex, const Vec3& position, std::string text) {
    target_of_[vertex] = static_cast<std::uint32_t>(targets_.size());
    targets_.push_back({vertex, position});
    texts_.push_back(std::move(text));
  }

  /// Those that differ from where the vertex is, by increasing vertex.
  std::vector<Target> moves() const {
    std::vector<Target> result;
    for (Index v = 0; v < target_of_.size(); ++v) {
      if (has(v) && position(v) != points_[v]) result.push_back(targets_[target_of_[v]]);
    }
    return result;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  Points points_;
  std::vector<std::uint32_t> target_of_;  // per vertex: its entry in targets, or kNone
  std::vector<Target> targets_;
  std::vector<std::string> texts_;  // per target
};

}  // namespace evenmesh
