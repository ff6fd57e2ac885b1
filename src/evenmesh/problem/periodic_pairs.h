// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// Two vertices that lie opposite: (of the first side, of the second).
using PeriodicPair = std::pair<Index, Index>;

/// What came of looking for every vertex's image.
struct PeriodicMatch {
  std::vector<PeriodicPair> pairs;  // by increasing first
  std::size_t unmatched = 0;        // of either side
  Index example = 0;                // the first of these
  double nearest = 0.0;             // from its image to the nearest vertex of the other side
};

/// Pairs each vertex of one side with that of the other which lies where a translation takes it.
/// A vertex that is on both sides and its own image is left out.
/// @param tolerance  how far from the image a vertex may lie, > 0
/// @return  in a tie the nearest; of equally near ones the least
PeriodicMatch match_periodic(Points points, std::span<const Index> first,
                             std::span<const Index> second, const Vec3& translation,
                             double tolerance);

}  // namespace evenmesh
