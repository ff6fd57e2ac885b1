// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/io/input_file.h"
#include "evenmesh/mesh/data_array.h"
#include "evenmesh/mesh/followers.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/named_sets.h"

namespace evenmesh {

/// What a reader remembers of a file, so that the file can be written again with other coordinates
/// and not one other byte changed. One subclass per format, in the format's own source file.
class FilePatch {
 public:
  virtual ~FilePatch() = default;

  /// The name of the format, see format_traits(): "obj", "stl_ascii", "msh".
  virtual std::string_view format() const = 0;

  /// The nearest positions that the file can hold (binary STL: floats). Those of the input may have
  /// more digits than moved ones get; see MeshFile::representable().
  virtual std::vector<Vec3> representable(Points points) const = 0;

  /// The input's bytes with new coordinates for the vertices that moved, handed to sink piece by
  /// piece in order. A vertex whose position has the same bits as in the input keeps its exact
  /// text; a moved one gets the shortest digits that read back as the same number.
  /// @pre  points.size() is that of the mesh; all finite
  virtual void write(Points points, const std::function<void(std::string_view)>& sink) const = 0;

  /// The name that a user finds in the file: "face 17 (line 203)", "facet 12".
  virtual std::string cell_name(std::size_t cell) const = 0;
  virtual std::string vertex_name(Index vertex) const = 0;

  /// The number in cell_name(), found at once: names of all cells of a large file take too long.
  virtual std::uint64_t cell_number(std::size_t cell) const { return cell + 1; }
  /// The number of each vertex in the file; empty where they are only counted, from the first
  /// one's.
  virtual std::span<const std::uint64_t> vertex_numbers() const { return {}; }
  virtual std::uint64_t first_vertex_number() const { return 1; }
};

/// Vertices that stay by default because something in the file hangs on their very places.
struct HeldVertices {
  std::vector<Index> vertices = {};  // ascending, each once
  std::string why = {};              // "in loads, supports and couplings"
};

struct MeshFile {
  std::filesystem::path path;
  Mesh mesh;
  std::unique_ptr<const FilePatch> patch;
  std::vector<std::string> group_names;  // [group number of a cell]; entry 0 is "no group"
  std::vector<NamedSet> sets = {};       // what else the file calls by a name
  std::vector<DataArray> arrays = {};    // numbers that it has for each vertex or cell
  Followers followers = {};              // nodes of second-order cells that are no corners
  HeldVertices held = {};
  std::vector<std::string> notes;  // what the reader wants the user to know, whole sentences
  std::uint64_t bytes = 0;         // size of the file
  std::shared_ptr<const InputFile> input = {};  // the bytes themselves

  /// What a reader of the output would see when the corners are at `points`: followers follow,
  /// coordinates that are as in the input keep their bits, others are what the file can hold.
  std::vector<Vec3> representable(Points points) const;
};

struct ReadOptions {
  /// STL: corners that are at most this far apart become one vertex (length unit of the file).
  /// 0 welds corners whose coordinates are equal as numbers, which is how exporters write them.
  double weld_tolerance = 0.0;
};

/// Reads a mesh; the format is found from the content, and from the suffix only where the content
/// leaves it open.
/// @throws IoError      cannot be opened, not a format evenmesh reads, or broken; the message names
///                      file, line (or byte or facet), what is wrong and what to try
/// @throws InvalidMesh  never: the reader's message says where in the file the fault is
MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// Finds out before the work what would keep write_mesh() from writing. Leaves nothing behind.
/// @throws IoError  the name promises another format or compression, no permission, no such folder
void check_output(const MeshFile& file, const std::filesystem::path& path);

/// Writes the file again with new positions: to a temporary file beside `path`, which is then read
/// back and compared (same connectivity, the positions of representable()), given to `check`, and
/// only then renamed to `path`. On any failure, or when check throws, the temporary file is removed
/// and whatever was at `path` is as before. A compressed input gives a compressed output.
/// @param check  called with the mesh as read back; throws to refuse
/// @throws IoError  no permission, disk full, or the file read back differs
void write_mesh(const MeshFile& file, Points points, const std::filesystem::path& path,
                const ReadOptions& options = {},
                const std::function<void(const Mesh& written)>& check = {});

}  // namespace evenmesh
