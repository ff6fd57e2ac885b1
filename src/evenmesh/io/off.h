// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// Length of the keyword at the beginning of an OFF file: OFF behind any of ST, C, N, 4 and n, in
/// this order. A digit may follow at once, as some exporters write "OFF8 6 0".
/// @return  0 if the word does not begin with one
std::size_t off_keyword_length(std::string_view word);

/// Reads an OFF in ASCII: OFF, and with normals, colours or texture coordinates NOFF, COFF, CNOFF,
/// STOFF and so on. Each vertex and each face stands on a line of its own; what follows the
/// coordinates or the vertices there, and comments, are kept. Binary files and those whose vertices
/// have other than three coordinates (4OFF, nOFF) are refused.
/// @throws IoError  see read_mesh()
MeshFile read_off(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
