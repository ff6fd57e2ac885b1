// SPDX-License-Identifier: MIT
#include "evenmesh/classic/angle_based.h"

#include <cmath>

#include <Eigen/Geometry>

namespace evenmesh {
namespace {

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

// The turn of the edge about its far end, as axis times angle. False unless two cells are beside
// it.
bool AngleBased::turn_at(const Link& link, const Star& star, Points x, Vec3& turn) const {
  const Vec3 edge = x[link.from] - x[link.to];
  turn = Vec3::Zero();
  int sides = 0;
  for (const StarCell& around : star.cells) {
    if (around.at != link.from) continue;
    const auto cell = mesh_.cells().vertices(around.cell);
    const std::size_t n = cell.size();
    for (std::size_t k = 0; k < n; ++k) {
      if (cell[k] != link.to) continue;
      const Index next = cell[(k + 1) % n];
      const Index previous = cell[(k + n - 1) % n];
      if (next != link.from && previous != link.from) continue;
      // Seen from above, the cell lies to the left of the way from `to` to its next vertex.
      const bool left = next == link.from;
      const Index other = left ? previous : next;
      const double half = 0.5 * angle_between(edge, x[other] - x[link.to]);
      turn += (left ? half : -half) * orientation_.up(around.cell);
      ++sides;
      break;
    }
  }
  return sides == 2;
}

Vec3 AngleBased::move(const Star& star, Points x) const {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  Vec3 turn;
  for (const Link& link : star.links) {
    if (!turn_at(link, star, x, turn)) continue;
    ++count;
    const double angle = turn.norm();
    if (angle == 0.0) continue;
    const Vec3 edge = x[link.from] - x[link.to];
    sum += Eigen::AngleAxisd(angle, turn / angle) * edge - edge;
  }
  return count == 0 ? Vec3(Vec3::Zero()) : Vec3(sum / count);
}

}  // namespace evenmesh
