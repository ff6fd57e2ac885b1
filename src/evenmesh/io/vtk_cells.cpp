// SPDX-License-Identifier: MIT
#include "evenmesh/io/vtk_cells.h"

namespace evenmesh {

std::optional<VtkCellType> vtk_cell_type(std::int64_t type) {
  const auto linear = [](CellKind kind, std::size_t nodes) {
    return VtkCellType{.kind = kind, .makes_cell = true, .nodes = nodes};
  };
  const auto second = [](CellKind kind, std::size_t nodes) {
    return VtkCellType{.kind = kind, .makes_cell = true, .nodes = nodes, .second_order = true};
  };
  const auto crossed = [](CellKind kind, std::size_t nodes) {
    return VtkCellType{.kind = kind, .makes_cell = true, .nodes = nodes, .crossed = true};
  };
  switch (type) {
    case 1:   // vertex
    case 2:   // several
    case 3:   // line
    case 4:   // several
    case 21:  // line of second order
    case 68:  // Lagrange line
      return VtkCellType{};
    case 5:
      return linear(CellKind::triangle, 3);
    case 7:
      return linear(CellKind::polygon, 0);
    case 8:
      return crossed(CellKind::quad, 4);
    case 9:
      return linear(CellKind::quad, 4);
    case 10:
      return linear(CellKind::tet, 4);
    case 11:
      return crossed(CellKind::hex, 8);
    case 12:
      return linear(CellKind::hex, 8);
    case 13:
      return linear(CellKind::wedge, 6);
    case 14:
      return linear(CellKind::pyramid, 5);
    case 22:
      return second(CellKind::triangle, 6);
    case 34:
      return second(CellKind::triangle, 7);
    case 23:
      return second(CellKind::quad, 8);
    case 28:
      return second(CellKind::quad, 9);
    case 24:
      return second(CellKind::tet, 10);
    case 25:
      return second(CellKind::hex, 20);
    case 29:
      return second(CellKind::hex, 27);
    case 26:
      return second(CellKind::wedge, 15);
    case 32:
      return second(CellKind::wedge, 18);
    case 27:
      return second(CellKind::pyramid, 13);
    default:
      return std::nullopt;
  }
}

}  // namespace evenmesh
