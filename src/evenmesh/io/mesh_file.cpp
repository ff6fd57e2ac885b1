// SPDX-License-Identifier: MIT
#include "evenmesh/io/mesh_file.h"

#include <algorithm>
#include <cstring>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/format.h"
#include "evenmesh/io/gzip.h"
#include "evenmesh/io/input_file.h"
#include "evenmesh/io/output_file.h"

namespace evenmesh {
namespace {

bool same_cells(const Cells& a, const Cells& b) {
  return std::ranges::equal(a.kinds(), b.kinds()) && std::ranges::equal(a.offsets(), b.offsets()) &&
         std::ranges::equal(a.corners(), b.corners());
}

/// Files are patched, not converted: the suffix of the output must not promise another format.
void check_suffix(const std::filesystem::path& path, const FormatTraits& format) {
  std::string suffix = lower_suffix(path);
  if (suffix == ".gz") suffix = lower_suffix(path.stem());
  const std::string_view own = format.suffixes;
  if (suffix.empty() || has_suffix(format, suffix)) return;
  const auto all = all_formats();
  if (std::ranges::none_of(all, [&](const FormatTraits& f) { return has_suffix(f, suffix); })) {
    return;
  }
  throw IoError(
      fmt::format("{}: the input is {} and evenmesh does not convert; name the output *{}",
                  path.string(), format.words, own.substr(0, own.find(' '))));
}

void check_compression(const std::filesystem::path& path, const MeshFile& file) {
  const bool zipped = lower_suffix(path) == ".gz";
  if (zipped == file.input->is_compressed()) return;
  if (!zipped && path.extension().empty()) return;
  throw IoError(fmt::format(
      "{}: the input is {}compressed and the output is written like it; {} .gz in its name",
      path.string(), zipped ? "not " : "", zipped ? "leave out" : "put"));
}

void check_name(const MeshFile& file, const std::filesystem::path& path) {
  check_suffix(path, format_traits(file.patch->format()));
  check_compression(path, file);
}

Mesh read_back(const MeshFile& file, const std::filesystem::path& temporary,
               const std::filesystem::path& path, const ReadOptions& options) {
  try {
    const FormatTraits& format = format_traits(file.patch->format());
    return read_as(format.format, InputFile::open(temporary, path.string()), options).mesh;
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

/// A compressed file in which nothing moves keeps its very bytes, which another compressor would
/// not give again.
void write_bytes(const MeshFile& file, Points points, OutputFile& output) {
  const auto append = [&output](std::string_view bytes) { output.append(bytes); };
  if (!file.input->is_compressed()) {
    file.patch->write(points, append);
  } else if (first_difference(file.mesh.points(), points) == points.size()) {
    output.append(file.input->compressed_bytes());
  } else {
    GzipWriter writer(append);
    file.patch->write(points, [&writer](std::string_view bytes) { writer.append(bytes); });
    writer.finish();
  }
}

}  // namespace

std::vector<Vec3> MeshFile::representable(Points points) const {
  std::vector<Vec3> moved(points.begin(), points.end());
  followers.follow(mesh.points(), moved);
  std::vector<Vec3> result = patch->representable(moved);
  for (std::size_t v = 0; v < result.size(); ++v) {
    for (int k = 0; k < 3; ++k) {
      const double before = mesh.points()[v][k];
      const bool same = std::memcmp(&before, &moved[v][k], sizeof(double)) == 0;
      if (same) result[v][k] = before;
    }
  }
  return result;
}

MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  MeshFile file = read_mesh(InputFile::open(path), options);
  file.path = path;
  return file;
}

void check_output(const MeshFile& file, const std::filesystem::path& path) {
  check_name(file, path);
  const OutputFile probe(path);
}

void write_mesh(const MeshFile& file, Points points, const std::filesystem::path& path,
                const ReadOptions& options, const std::function<void(const Mesh&)>& check) {
  check_name(file, path);
  OutputFile output(path);
  const std::vector<Vec3> wanted = file.representable(points);
  write_bytes(file, wanted, output);
  output.close();

  const Mesh written = read_back(file, output.temporary_path(), path, options);
  check_same(file, written, wanted, path);
  if (check) check(written);
  output.commit();
}

}  // namespace evenmesh
