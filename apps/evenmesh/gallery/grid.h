// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>

#include "evenmesh/mesh/mesh.h"

namespace evenmesh::gallery {

/// A rectangular grid of quads while it is being made: columns x rows cells, vertices row by row.
struct Grid {
  int columns = 1;
  int rows = 1;

  Index vertex(int i, int j) const { return static_cast<Index>(j * (columns + 1) + i); }
  bool on_boundary(int i, int j) const { return i == 0 || j == 0 || i == columns || j == rows; }
  std::array<Index, 4> quad(int i, int j) const {
    return {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)};
  }

  /// The vertices by row and column.
  std::vector<Vec3> points(const std::function<Vec3(int i, int j)>& place) const {
    std::vector<Vec3> all;
    for (int j = 0; j <= rows; ++j) {
      for (int i = 0; i <= columns; ++i) all.push_back(place(i, j));
    }
    return all;
  }
  Cells quads() const {
    Cells cells;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) cells.add(CellKind::quad, quad(i, j));
    }
    return cells;
  }
};

}  // namespace evenmesh::gallery
