// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

inline constexpr std::size_t kBinaryStlHeader = 84;  // 80 bytes of anything, then the count
inline constexpr std::size_t kBinaryStlFacet = 50;   // 12 floats, then 2 attribute bytes

/// Whether the bytes are as many as a binary STL has whose count of facets is the one found there.
bool has_binary_stl_size(std::string_view bytes);

/// Reads a binary STL. Header, attribute bytes and whatever follows the facets are kept.
///
/// A count that is larger than the file is refused. Where the count is smaller, the rest of the
/// file is taken for facets if it has the size and the look of facets (some exporters never go
/// back to fill in the count), and is otherwise only kept; a note says which.
/// @throws IoError  see read_mesh()
MeshFile read_stl_binary(std::shared_ptr<const InputFile> input, const ReadOptions& options);

}  // namespace evenmesh
