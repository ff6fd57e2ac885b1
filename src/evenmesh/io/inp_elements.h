// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "evenmesh/mesh/cell_kind.h"

namespace evenmesh {

/// What is to be known of an element type of Abaqus or CalculiX that makes a cell.
struct InpElementType {
  CellKind kind;
  std::size_t nodes;
};

/// @param type  in capitals: "C3D10M", "S4R", "CPE8R"
/// @return  nothing for elements that make no cell, or one of no size: lines, points, springs,
///          cohesive elements and gaskets, user elements
std::optional<InpElementType> inp_element_type(std::string_view type);

}  // namespace evenmesh
