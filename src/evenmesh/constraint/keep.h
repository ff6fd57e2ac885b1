// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "evenmesh/constraint/function.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// What the whole of a mesh or of a group may be kept at.
enum class Keep : std::uint8_t {
  area,   // of the surface cells
  volume  // of the volume cells, or what a closed surface encloses
};
std::string_view name(Keep what);

/// The total area or volume of a mesh, as a function of positions.
///
///   area, planar mesh:   sum over cells of the signed area about the orientation's normal, which
///                        is that within the boundary: it depends on boundary vertices alone
///   area, otherwise:     sum over surface cells of |1/2 sum_i x_i x x_i+1|, the area of each
///                        cell's largest shadow (exact where cells are flat)
///   volume, with volume cells:  sum of their signed volumes, which is that within their skin: it
///                        depends on skin vertices alone
///   volume, surface:     sum over cells of 1/6 c . sum_i x_i x x_i+1, c the mean of the corners:
///                        the cone from the origin to the cell, exact for triangles and bilinear
///                        quads; each piece as most of it is wound (a cavity counts negative if it
///                        is wound inward), and positive altogether in the input
///
/// vertices() ascend. One pass over cells (or boundary sides); the gradient is exact, and what a
/// cell without area adds to it is 0.
/// @param group  only the cells of this group; nothing: all
/// @throws InvalidOption  no such cells: none in the group, volume cells only for an area; the
///                        volume of a planar mesh, of a surface that is not closed, or of one that
///                        no windings make consistent
/// @pre  orientation is that of the mesh
std::shared_ptr<const Function> keep_function(const Mesh& mesh, const Orientation& orientation,
                                              Keep what, std::optional<std::uint32_t> group = {});

/// Keeps the total area or volume at that of the input, or brings it to a value.
/// @param value  > 0 and finite, square or cube of the mesh length unit; nothing: as in the input
/// @throws InvalidOption  as keep_function() does, or the value is out of range
Bound make_keep(const Mesh& mesh, const Orientation& orientation, Keep what,
                std::optional<std::uint32_t> group = {}, std::optional<double> value = {});

}  // namespace evenmesh
