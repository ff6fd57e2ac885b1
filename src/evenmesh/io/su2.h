// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads an SU2 mesh of one zone, planar or volume. Markers are sets; vertices on two of them
/// are held. Free-form deformation boxes and everything else are left alone.
/// @throws IoError  see read_mesh(); several zones
MeshFile read_su2(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
