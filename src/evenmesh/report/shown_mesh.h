// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/curves.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/quality/quality.h"

namespace evenmesh {

/// What a vertex may do, in the numbers of the report's data.
enum class Hold : char { free = 0, fixed = 1, line = 2, plane = 3, tied = 4 };

/// Positions on the way.
struct StoredIterate {
  int iteration = 0;
  std::vector<Vec3> points = {};
};

/// A mesh as a report shows it, with what is known of its vertices and cells. What it refers to
/// must outlive it.
struct ShownMesh {
  const Mesh& before;
  const Orientation& orientation;
  const CellQuality& quality_before;
  Points after = {};                           // empty: there is no second state
  const CellQuality* quality_after = nullptr;  // null: likewise
  std::vector<Hold> hold = {};                 // per vertex; empty: not known
  std::vector<char> wall_layers = {};          // per cell; empty: none
  std::span<const VertexPair> feature_edges = {};
  std::vector<std::string> group_names = {};  // by number; entry 0 is no group
  /// As a user finds them in the file; null: not known.
  std::function<std::uint64_t(std::size_t cell)> cell_number = {};
  std::function<std::uint64_t(Index vertex)> vertex_number = {};
  std::span<const StoredIterate> iterates = {};

  bool has_after() const { return quality_after != nullptr; }
  /// That which counts: afterwards, if there is such a thing.
  const CellQuality& quality() const { return has_after() ? *quality_after : quality_before; }
};

}  // namespace evenmesh
