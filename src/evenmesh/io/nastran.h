// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads the bulk data of a Nastran deck: fields of 8 or 16 columns, between commas or tabs.
///
/// Vertices are the GRIDs in the order of the file, cells the shells and solids of first and second
/// order, in groups by their property. Grids that bars, rods, springs, masses, rigid elements,
/// supports, loads and coordinate systems name are held. Grids in other coordinate systems than the
/// basic one are refused, for their numbers would mean other places, and so are included files.
///
/// A coordinate that moves is as exact as its field allows: 8 characters, 16 in wide fields.
/// @throws IoError  see read_mesh()
MeshFile read_nastran(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
