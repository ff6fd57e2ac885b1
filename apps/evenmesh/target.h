// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh::app {

/// What --target asks of every cell's `shape`; nothing for an empty text.
/// @throws InvalidOption  the text is not "shape>=X" with X between 0 and 1
std::optional<double> parse_target(const std::string& text);

/// The cells whose `shape` is less than the target, ascending.
std::vector<std::size_t> cells_below(double target, const Mesh& mesh, Points points,
                                     const Orientation& orientation, int threads);

/// The vertices that are more than so many rings away from all of these cells: one flag each.
std::vector<char> vertices_far_from(const std::vector<std::size_t>& cells, const Mesh& mesh,
                                    int rings);

}  // namespace evenmesh::app
