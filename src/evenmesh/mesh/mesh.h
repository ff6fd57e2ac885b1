// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"

namespace evenmesh {

/// A list of cells of any kind: one array of vertex numbers and where each cell starts in it.
class Cells {
 public:
  /// Appends a cell.
  /// @param group  number of the group it belongs to (a material, a part); 0 if there is none
  /// @pre   the number of vertices is that of the kind (at least 3 for a polygon)
  void add(CellKind kind, std::span<const Index> vertices, std::uint32_t group = 0);
  void reserve(std::size_t cells, std::size_t corners);
  /// For readers of files that name the groups of cells behind the cells.
  void set_group(std::size_t cell, std::uint32_t group);

  std::size_t size() const { return kinds_.size(); }
  bool empty() const { return kinds_.empty(); }
  CellKind kind(std::size_t cell) const { return kinds_[cell]; }
  std::span<const Index> vertices(std::size_t cell) const {
    return {corners_.data() + offsets_[cell], corners_.data() + offsets_[cell + 1]};
  }
  /// 0 for every cell of a mesh without groups.
  std::uint32_t group(std::size_t cell) const { return groups_.empty() ? 0 : groups_[cell]; }
  bool has_groups() const { return !groups_.empty(); }

  /// All cells' vertices one after the other; cell i takes [offsets()[i], offsets()[i + 1]).
  std::span<const Index> corners() const { return corners_; }
  std::span<const Offset> offsets() const { return offsets_; }
  std::span<const CellKind> kinds() const { return kinds_; }

 private:
  std::vector<Index> corners_;
  std::vector<Offset> offsets_{0};
  std::vector<CellKind> kinds_;
  std::vector<std::uint32_t> groups_;  // empty while every cell is in group 0
};

/// Positions plus connectivity, and nothing that can be derived from them.
///
/// Connectivity is checked once, here, and never changes afterwards: smoothing moves points. Code
/// that holds a Mesh may therefore index without checking. A cell may repeat a vertex and vertices
/// may coincide or belong to no cell: real files have all of that. Copies share the connectivity.
class Mesh {
 public:
  Mesh() : cells_(std::make_shared<const Cells>()) {}

  /// @throws InvalidMesh  an index is outside [0, points.size()), there are more than 2^32 - 2
  ///                      points, or a coordinate is not finite.
  Mesh(std::vector<Vec3> points, Cells cells);

  Points points() const { return points_; }
  const Cells& cells() const { return *cells_; }
  std::size_t point_count() const { return points_.size(); }

  /// @pre same count, all finite
  void set_points(std::vector<Vec3> points);

 private:
  std::vector<Vec3> points_;  // length unit of the input file
  std::shared_ptr<const Cells> cells_;
};

}  // namespace evenmesh
