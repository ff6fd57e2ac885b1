// SPDX-License-Identifier: MIT
#include "evenmesh/io/inp_elements.h"

#include <array>
#include <charconv>

namespace evenmesh {
namespace {

struct Family {
  std::string_view prefix;
  int dimension;
};

/// Longer names first where one begins with another.
constexpr std::array kFamilies{
    Family{"DCC3D", 3}, Family{"DC3D", 3},  Family{"AC3D", 3}, Family{"EC3D", 3},
    Family{"FC3D", 3},  Family{"Q3D", 3},   Family{"C3D", 3},  Family{"CSS", 3},
    Family{"SC", 3},    Family{"DCC2D", 2}, Family{"DC2D", 2}, Family{"AC2D", 2},
    Family{"DCCAX", 2}, Family{"DCAX", 2},  Family{"ACAX", 2}, Family{"CGAX", 2},
    Family{"CPEG", 2},  Family{"CPE", 2},   Family{"CPS", 2},  Family{"CAX", 2},
    Family{"SFM3D", 2}, Family{"M3D", 2},   Family{"R3D", 2},  Family{"STRI", 2},
    Family{"DS", 2},    Family{"S", 2},
};

constexpr std::array kSolids{
    InpElementType{CellKind::tet, 4},    InpElementType{CellKind::pyramid, 5},
    InpElementType{CellKind::wedge, 6},  InpElementType{CellKind::hex, 8},
    InpElementType{CellKind::tet, 10},   InpElementType{CellKind::pyramid, 13},
    InpElementType{CellKind::wedge, 15}, InpElementType{CellKind::hex, 20},
    InpElementType{CellKind::hex, 27}};
constexpr std::array kSurfaces{
    InpElementType{CellKind::triangle, 3}, InpElementType{CellKind::quad, 4},
    InpElementType{CellKind::triangle, 6}, InpElementType{CellKind::quad, 8},
    InpElementType{CellKind::quad, 9}};

template <std::size_t n>
std::optional<InpElementType> with_nodes(const std::array<InpElementType, n>& list,
                                         std::size_t nodes) {
  for (const InpElementType& type : list) {
    if (type.nodes == nodes) return type;
  }
  return std::nullopt;
}

}  // namespace

std::optional<InpElementType> inp_element_type(std::string_view type) {
  if (type == "STRI65") return InpElementType{CellKind::triangle, 6};
  for (const Family& family : kFamilies) {
    if (!type.starts_with(family.prefix)) continue;
    const std::string_view rest = type.substr(family.prefix.size());
    std::size_t nodes = 0;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), nodes);
    if (error != std::errc() || stop == rest.data()) continue;  // "SPRINGA" is no "S"
    return family.dimension == 3 ? with_nodes(kSolids, nodes) : with_nodes(kSurfaces, nodes);
  }
  return std::nullopt;
}

}  // namespace evenmesh
