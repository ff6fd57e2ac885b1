// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// What kind of dataset a VTK file in XML says that it has: "UnstructuredGrid".
/// @param begin  of the file
/// @return  nothing if it is no such file
std::optional<std::string_view> vtk_xml_dataset(std::string_view begin);

/// Reads a VTK file in XML of the dataset UnstructuredGrid (.vtu) or PolyData (.vtp), with arrays
/// as text, in base64 or as raw bytes behind the tags, compressed with zlib or not, in either byte
/// order. Pieces become one mesh. Where the points are compressed, moved ones may take more or
/// fewer bytes, and the `offset` attributes of arrays behind them change with that.
/// @throws IoError  see read_mesh(); other datasets, other compressors
MeshFile read_vtu(std::shared_ptr<const InputFile> input);
MeshFile read_vtp(std::shared_ptr<const InputFile> input);

}  // namespace evenmesh
