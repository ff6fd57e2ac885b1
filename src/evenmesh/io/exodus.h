// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Reads Exodus II in netCDF's classic formats (CDF-1, CDF-2, CDF-5). Element blocks become groups,
/// node sets `nset:`, side sets `marker:`; elements and nodes go by their maps.
/// Source: Sandia report SAND92-2137 and its later revisions.
/// @throws IoError  broken, no mesh, polyhedra, elements of higher order than the second
MeshFile read_exodus(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
