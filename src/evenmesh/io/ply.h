// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads a PLY, text or binary in either byte order.
///
/// Vertices are those of the element `vertex` by its properties x, y and z, which must follow each
/// other and be of one type; cells are the lists `vertex_indices` (or `vertex_index`) of the
/// element `face`. All other elements and properties are left alone, in whatever order they come.
/// Coordinates of type float are written with a float's digits. Triangle strips are refused.
/// @throws IoError  see read_mesh()
MeshFile read_ply(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
