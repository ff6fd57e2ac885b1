// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/topology.h"

namespace evenmesh {

/// The vertices that a selector names.
///
///   selector = term { ("+" | "-" | "&") term }          read from left to right
///   term     = "all" | "none" | "boundary" | "features" | "corners" | "interface"
///            | "non_manifold" | "id:1,5-9" | "box:x0,y0,z0,x1,y1,z1"
///
/// `+` joins, `-` takes away, `&` keeps what both have; spaces are ignored around terms. `features`
/// includes non-manifold edges, which no smooth surface has. Vertex numbers in `id:` are those of
/// the file, counted from first_id. A box includes its faces.
/// @param first_id  the number the file gives its first vertex (1 for OBJ, 0 for numbered-by-place)
/// @return  one flag per vertex
/// @throws InvalidOption  the text does not parse (the message shows where and what is known), or
///                        an id is not in the mesh.
std::vector<char> select_vertices(std::string_view text, const Mesh& mesh, const Topology& topology,
                                  Index first_id = 1);

}  // namespace evenmesh
