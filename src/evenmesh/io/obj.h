// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads a Wavefront OBJ: vertices from `v`, cells from `f`, groups from `o`, `g` and `usemtl`.
///
/// Three corners make a triangle, four a quad, more a polygon. A cell's group is the combination
/// of object, group and material in force, for example "g wing, usemtl steel". Every other
/// statement is left alone, and so are texture and normal references, w and colours.
///
/// One pass; beside the mesh it keeps 8 bytes per vertex.
/// @throws IoError  see read_mesh()
MeshFile read_obj(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
