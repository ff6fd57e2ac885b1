// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads a MEDIT mesh (.mesh) in text, as Mmg, FreeFEM and Gamma tools write it.
///
/// Cells are triangles, quadrilaterals, tetrahedra, hexahedra, prisms and pyramids; a cell's group
/// is its reference ("ref 3"). The surface cells of a volume are its sides and make markers by
/// their references, and so do edges of a surface; vertices with a reference make node sets.
/// Corners, ridges and whatever is required is held. All other sections are left alone; cells of
/// second order are refused.
/// @throws IoError  see read_mesh()
MeshFile read_medit(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
