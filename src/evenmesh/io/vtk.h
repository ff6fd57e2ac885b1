// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads a legacy VTK file of any version up to 5.1, text or binary: UNSTRUCTURED_GRID, POLYDATA
/// and STRUCTURED_GRID. Arrays of one number per point or cell can be selected by.
/// @throws IoError  see read_mesh(); a dataset whose points are not listed, triangle strips
MeshFile read_vtk(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
