// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "evenmesh/mesh/cell_kind.h"
#include "evenmesh/mesh/followers.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// In which order a format lists the middles of edges.
enum class EdgeOrder : std::uint8_t {
  levels,  // bottom, top, then upright edges: Abaqus, CalculiX
  gmsh,    // by the lower of the two corners
  nastran  // bottom, upright, then top edges
};

/// Stands for a node that a format lets one leave out.
inline constexpr Index kNoNode = ~Index{0};

/// Notes the nodes of a cell of second order that are no corners.
/// @param nodes  corners first, then edges, quads, the middle of the whole; or kNoNode
/// @pre   has_node_count(kind, nodes.size())
void add_followers(CellKind kind, EdgeOrder order, std::span<const Index> nodes,
                   Followers& followers);

/// A vertex that is a corner of one cell and in the middle of an edge of another, where the mesh
/// would tear; none as it should be.
std::optional<Index> torn_vertex(const Followers& followers, const Cells& cells,
                                 std::size_t vertices);

/// What to say of it.
/// @param vertex  by the name that it has in the file: "node 17"
/// @param cell    what the format calls a cell
std::string torn_message(std::string_view vertex, std::string_view cell);

}  // namespace evenmesh
