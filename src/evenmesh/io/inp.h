// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads an Abaqus or CalculiX deck.
///
/// Vertices are the nodes of all *NODE blocks in the order of the file. Cells are the solid, shell,
/// membrane, plane and surface elements of first and second order; the nodes of all others (beams,
/// springs, masses, cohesive and user elements) are held, and so are those that *BOUNDARY, *CLOAD,
/// *EQUATION, *MPC and the like name. A cell's group is the ELSET of its section, or that of its
/// *ELEMENT; *NSET and *ELSET are sets. Parts have numbers of their own. Included files may hold
/// sets; where they hold nodes or elements, and where nodes are generated or in other coordinates
/// than Cartesian ones, the deck is refused.
///
/// A number that moves has 20 characters at most, as many as Abaqus and CalculiX read.
/// @throws IoError  see read_mesh()
MeshFile read_inp(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
