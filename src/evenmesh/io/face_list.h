// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// Makes cells of the faces of a file. Faces of fewer than three vertices, which some programs
/// write for points and edges, become none.
class FaceList {
 public:
  void reserve(std::size_t faces);
  /// @param place  where the face stands in the file
  void add(std::span<const Index> vertices, std::uint64_t place, std::uint32_t group = 0);

  Cells take_cells() { return std::move(cells_); }
  /// The face of each cell, counted from 0; empty where every face is a cell.
  std::vector<std::uint64_t> take_numbers();
  std::vector<std::uint64_t> take_places() { return std::move(places_); }
  /// Appends what the user should know about faces that are no cells.
  void append_notes(std::vector<std::string>& notes) const;

 private:
  Cells cells_;
  std::vector<std::uint64_t> numbers_;  // once a face was skipped
  std::vector<std::uint64_t> places_;
  std::size_t count_ = 0;  // of all faces
  std::size_t first_skipped_ = 0;
};

}  // namespace evenmesh
