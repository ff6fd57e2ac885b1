// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Whether the bytes begin as a binary MEDIT file does, in either byte order.
bool looks_like_meshb(std::string_view begin);

/// Reads a binary MEDIT mesh (.meshb) of version 1 to 4, in either byte order; what is said of
/// read_medit() holds here.
/// @throws IoError  see read_mesh()
MeshFile read_meshb(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
