// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// Places at equal distances in space; positions are rounded to the nearest.
struct Grid {
  Vec3 origin = Vec3::Zero();
  double step = 1.0;

  /// position = origin + step * place, to half a step
  std::array<std::int64_t, 3> place(const Vec3& position) const;
};

/// How fine a grid is: edges so short that only a hundredth is shorter have so many steps, and so
/// does the longest edge of the box around everything, whichever takes the finer grid.
struct Fineness {
  double steps_per_edge = 32.0;
  double steps_per_box = 65536.0;
};

/// A grid with at most 2^28 places along each axis.
/// @param states  positions of all vertices; the first has the edges that count
/// @param vertices  those that matter, in any order, perhaps repeated
Grid choose_grid(const Cells& cells, std::span<const Points> states,
                 std::span<const Index> vertices, const Fineness& fineness);

}  // namespace evenmesh
