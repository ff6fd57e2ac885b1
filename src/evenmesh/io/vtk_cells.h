// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "evenmesh/mesh/cell_kind.h"

namespace evenmesh {

/// What is to be known of a cell type of VTK, whose numbers SU2 uses too.
struct VtkCellType {
  CellKind kind = CellKind::triangle;  // where it makes a cell
  bool makes_cell = false;             // false: a point or a line
  std::size_t nodes = 0;               // 0: any number
  bool second_order = false;
  bool crossed = false;  // pixel, voxel: the last two of each quad are swapped
};

/// @return  nothing for types that are not read: strips, polyhedra, cells of other orders
std::optional<VtkCellType> vtk_cell_type(std::int64_t type);

}  // namespace evenmesh
