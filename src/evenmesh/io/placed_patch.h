// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/io/byte_patcher.h"
#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"

namespace evenmesh {

/// How the coordinates of a vertex are written: one behind the other, as words or as bytes.
struct CoordinateCode {
  enum class Kind : std::uint8_t { text, float32, float64 };
  Kind kind = Kind::text;
  int dimension = 3;       // 2: the file has no third coordinate, which is 0
  bool single = false;     // text: it is for floats, so more digits than theirs have no meaning
  std::size_t widest = 0;  // text: the most characters that a number may have; 0: any
  bool swap = false;       // bytes: in the order that is not this machine's

  /// Whether every position can be written as it is.
  bool is_exact() const;
  /// What a reader of the file makes of a coordinate that is written in this code.
  double representable(double coordinate) const;
  /// Replaces the coordinates at p that differ from those of `position`.
  /// @param end  where reading must end at the latest
  void patch(const char* p, const char* end, const Vec3& position, BytePatcher& out) const;
  /// The coordinates at p in bytes.
  Vec3 position_at(const char* p) const;
  std::size_t bytes_each() const { return kind == Kind::float32 ? 4 : 8; }
};

/// How messages name what is in a file, by the numbers that it has there.
struct FileNumbers {
  std::string_view vertex = "vertex";
  std::string_view cell = "cell";
  std::uint64_t first_vertex = 0;  // the number of the first, if they are counted
  std::uint64_t first_cell = 0;
  std::vector<std::uint64_t> vertices = {};     // of each; empty: they are counted
  std::vector<std::uint64_t> cells = {};        // likewise
  std::vector<std::uint64_t> cell_places = {};  // where each stands in a text; empty: unknown
  bool number_at_place = false;                 // a cell's place is where its number stands
};

/// The patch of a file in which every vertex has a place where its coordinates stand, in ascending
/// order. Cells are numbered in their order unless the file has their numbers.
class PlacedPatch : public FilePatch {
 public:
  /// @param places  per vertex where its first coordinate begins in the file, ascending
  PlacedPatch(std::string_view format, std::shared_ptr<const InputFile> input, CoordinateCode code,
              std::vector<std::uint64_t> places, FileNumbers numbers);

  std::string_view format() const override { return format_; }
  std::vector<Vec3> representable(Points points) const override;
  void write(Points points, const std::function<void(std::string_view)>& sink) const override;
  std::string cell_name(std::size_t cell) const override;
  std::uint64_t cell_number(std::size_t cell) const override;
  std::string vertex_name(Index vertex) const override;
  std::span<const std::uint64_t> vertex_numbers() const override { return numbers_.vertices; }
  std::uint64_t first_vertex_number() const override { return numbers_.first_vertex; }

 private:
  std::string_view format_;
  std::shared_ptr<const InputFile> input_;
  CoordinateCode code_;
  std::vector<std::uint64_t> places_;
  FileNumbers numbers_;
};

}  // namespace evenmesh
