// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

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

/// Notes the nodes of a cell of second order that are no corners.
/// @param nodes  corners first, then edges, quads, the middle of the whole; kNoNode where the
/// format
///               lets one leave one out
/// @pre   has_node_count(kind, nodes.size())
inline constexpr Index kNoNode = ~Index{0};
void add_followers(CellKind kind, EdgeOrder order, std::span<const Index> nodes,
                   Followers& followers);

/// Fails where a vertex is a corner of one cell and in the middle of an edge of another: the mesh
/// would tear there.
/// @return  a follower that is a corner of some cell; its number, or followers.size() if there is
/// none
std::size_t find_torn(const Followers& followers, const Cells& cells, std::size_t vertices);

}  // namespace evenmesh
