// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/followers.h"

#include <algorithm>
#include <cstring>

namespace evenmesh {

void Followers::add(Index vertex, std::span<const Index> leaders) {
  if (vertex >= known_.size()) known_.resize(std::max<std::size_t>(vertex + 1, 2 * known_.size()));
  if (known_[vertex]) return;
  known_[vertex] = 1;
  vertices_.push_back(vertex);
  leaders_.insert(leaders_.end(), leaders.begin(), leaders.end());
  offsets_.push_back(leaders_.size());
}

void Followers::follow(Points before, std::span<Vec3> points) const {
  for (std::size_t i = 0; i < size(); ++i) {
    const auto corners = leaders(i);
    const bool moved = std::any_of(corners.begin(), corners.end(), [&](Index v) {
      return std::memcmp(&before[v], &points[v], sizeof(Vec3)) != 0;
    });
    points[vertices_[i]] = before[vertices_[i]];
    if (!moved) continue;
    Vec3 move = Vec3::Zero();
    for (const Index v : corners) move += points[v] - before[v];
    points[vertices_[i]] += move / static_cast<double>(corners.size());
  }
}

std::size_t Followers::curved(Points points) const {
  constexpr double kStraight = 1e-6;
  std::size_t count = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const auto corners = leaders(i);
    Vec3 middle = Vec3::Zero();
    for (const Index v : corners) middle += points[v] / static_cast<double>(corners.size());
    double size = 0.0;
    for (const Index v : corners) size = std::max(size, (points[v] - middle).norm());
    count += (points[vertices_[i]] - middle).norm() > kStraight * size;
  }
  return count;
}

}  // namespace evenmesh
