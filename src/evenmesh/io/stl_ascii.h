// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads an ASCII STL. Upper and lower case, any white space, several solids and a missing last
/// `endsolid` are fine. Where several solids have facets, each is a group, "solid NAME".
///
/// Coordinates are read, and written where they move, in double precision. Normals in the file are
/// not looked at; those of facets that move are computed anew, with the digits of a float.
/// @throws IoError  see read_mesh()
MeshFile read_stl_ascii(std::shared_ptr<const InputFile> input, const ReadOptions& options);

}  // namespace evenmesh
