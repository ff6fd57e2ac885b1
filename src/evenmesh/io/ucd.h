// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Whether a text begins with the five counts of a UCD file, behind comments.
bool looks_like_ucd(std::string_view text);

/// Reads a UCD file of AVS in text, as deal.II and ParaView write it. Cells are in groups by their
/// material where it is not 0; of lines, and of surface cells in a volume, it is a boundary's.
/// @throws IoError  see read_mesh()
MeshFile read_ucd(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
