// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

enum class Format : std::uint8_t {
  obj,
  stl_ascii,
  stl_binary,
  off,
  ply,
  msh,
  medit,
  meshb,
  su2,
  inp,
  vtk,
  vtu,
  vtp,
  nastran,
  exodus,
  ucd
};

/// One row of the table of formats.
struct FormatTraits {
  Format format;
  std::string_view name;      // in reports: "stl_ascii"
  std::string_view words;     // in messages: "an STL file"
  std::string_view suffixes;  // separated by blanks, the usual one first: ".vtu .vtp"
  /// @throws IoError  see read_mesh()
  MeshFile (*read)(std::shared_ptr<const InputFile> input, const ReadOptions& options);
};
std::span<const FormatTraits> all_formats();
const FormatTraits& format_traits(std::string_view name);
bool has_suffix(const FormatTraits& format, std::string_view suffix);

/// ".vtu" of "part.VTU".
std::string lower_suffix(const std::filesystem::path& path);

/// The format of a file, from its content; the suffix of its name decides only where the content
/// leaves it open.
/// @throws IoError  a format that is not read, or no mesh at all; the message says what it is and
///                  which formats are read
Format find_format(const InputFile& input);

/// Reads a file of a known format.
/// @throws IoError  see read_mesh()
MeshFile read_as(Format format, std::shared_ptr<const InputFile> input, const ReadOptions& options);

/// find_format(), then read_as(): read_mesh() for bytes that are in memory already.
MeshFile read_mesh(std::shared_ptr<const InputFile> input, const ReadOptions& options = {});

}  // namespace evenmesh
