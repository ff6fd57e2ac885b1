// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads a Gmsh MSH file of version 2, 4.0 or 4.1, text or binary in either byte order.
///
/// Vertices are all of $Nodes, in the order of the file. Cells are the triangles, quads, tets,
/// hexes, wedges and pyramids of first and second order; points and lines are read over. A cell's
/// group is its physical group ("physical steel", "physical 7"), or that of its entity; several are
/// one combination, and where there is none, it is the entity ("entity 5"). All other sections are
/// left alone. Elements of third order and higher and nodes with parametric coordinates are
/// refused: something in them would have to move along.
///
/// One pass; beside the mesh it keeps 16 bytes per vertex and 8 per cell.
/// @throws IoError  see read_mesh()
MeshFile read_msh(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
