// SPDX-License-Identifier: MIT
#include "evenmesh/io/mesh_file.h"

#include <algorithm>
#include <cstring>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/format.h"
#include "evenmesh/io/input_file.h"
#include "evenmesh/io/output_file.h"

namespace evenmesh {
namespace {

bool same_cells(const Cells& a, const Cells& b) {
  return std::ranges::equal(a.kinds(), b.kinds()) && std::ranges::equal(a.offsets(), b.offsets()) &&
         std::ranges::equal(a.corners(), b.corners());
}

Format format_of(const FilePatch& patch) {
  if (patch.format() == "obj") return Format::obj;
  if (patch.format() == "msh") return Format::msh;
  return patch.format() == "stl_ascii" ? Format::stl_ascii : Format::stl_binary;
}

std::string_view suffix_of(Format format) {
  if (format == Format::obj) return ".obj";
  return format == Format::msh ? ".msh" : ".stl";
}

std::string_view name_of(Format format) {
  if (format == Format::obj) return "an OBJ file";
  return format == Format::msh ? "a Gmsh file" : "an STL file";
}

/// Files are patched, not converted: the suffix of the output must not promise another format.
void check_suffix(const std::filesystem::path& path, Format format) {
  std::string suffix = path.extension().string();
  std::ranges::transform(suffix, suffix.begin(), [](char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  });
  const std::string_view own = suffix_of(format);
  if (suffix == own || (suffix != ".obj" && suffix != ".stl" && suffix != ".msh")) return;
  throw IoError(
      fmt::format("{}: the input is {} and evenmesh does not convert; name the output *{}",
                  path.string(), name_of(format), own));
}

Mesh read_back(const MeshFile& file, const std::filesystem::path& temporary,
               const std::filesystem::path& path, const ReadOptions& options) {
  try {
    return read_as(format_of(*file.patch), InputFile::open(temporary, path.string()), options).mesh;
  } catch (const IoError& error) {
    throw IoError(fmt::format("{} (while reading back what was to be written; nothing was written)",
                              error.what()));
  }
}

/// The first vertex that the file holds elsewhere than it should, or the number of vertices.
std::size_t first_difference(Points written, Points wanted) {
  std::size_t i = 0;
  while (i < wanted.size() && std::memcmp(&written[i], &wanted[i], sizeof(Vec3)) == 0) ++i;
  return i;
}

void check_same(const MeshFile& file, const Mesh& written, Points wanted,
                const std::filesystem::path& path) {
  if (written.point_count() < wanted.size()) {
    throw IoError(
        fmt::format("{}: vertices that are apart would be one when the file is read again, because "
                    "their new places are equal in the file's precision; nothing was written",
                    path.string()));
  }
  if (written.point_count() > wanted.size() || !same_cells(written.cells(), file.mesh.cells())) {
    throw IoError(
        fmt::format("{}: read back with other cells; nothing was written", path.string()));
  }
  const std::size_t i = first_difference(written.points(), wanted);
  if (i == wanted.size()) return;
  throw IoError(fmt::format("{}: {} did not read back as written; nothing was written",
                            path.string(), file.patch->vertex_name(static_cast<Index>(i))));
}

}  // namespace

MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  MeshFile file = read_mesh(InputFile::open(path), options);
  file.path = path;
  return file;
}

void write_mesh(const MeshFile& file, Points points, const std::filesystem::path& path,
                const ReadOptions& options, const std::function<void(const Mesh&)>& check) {
  check_suffix(path, format_of(*file.patch));
  OutputFile output(path);
  file.patch->write(points, [&](std::string_view bytes) { output.append(bytes); });
  output.close();

  const Mesh written = read_back(file, output.temporary_path(), path, options);
  check_same(file, written, file.patch->representable(points), path);
  if (check) check(written);
  output.commit();
}

}  // namespace evenmesh
