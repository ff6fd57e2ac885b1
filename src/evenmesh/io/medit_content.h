// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/io/mesh_file.h"
#include "evenmesh/io/side_labels.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// What a section of a MEDIT file holds.
enum class MeditRole : std::uint8_t {
  cells,
  edges,      // pairs of vertices with a reference
  vertices,   // corners and required vertices: numbers of vertices that stay
  edge_list,  // required edges and ridges: numbers of edges whose vertices stay
  cell_list,  // required triangles, quads: numbers of cells whose vertices stay
  too_high    // cells of second order or higher
};

struct MeditSection {
  std::string_view name;  // in the text; the binary file has the code
  int code;
  MeditRole role;
  CellKind kind = CellKind::triangle;
  std::size_t corners = 0;
};
/// @return  null for a section that is left alone, or the vertices
const MeditSection* medit_section(std::string_view name);
const MeditSection* medit_section(int code);

inline constexpr int kMeditDimension = 3;
inline constexpr int kMeditVertices = 4;
inline constexpr int kMeditEnd = 54;

/// Everything that is taken out of a MEDIT file, text or binary.
class MeditContent {
 public:
  void reserve_vertices(std::size_t count) { points_.reserve(count); }
  /// Before `count` entries of that section are added.
  void reserve_entries(const MeditSection& section, std::size_t count);
  void add_vertex(const Vec3& position, std::int64_t reference);
  /// Takes one entry of a section that is not too high.
  /// @param number   of (what, how many there are): reads a number of one of these, made to count
  ///                 from 0
  /// @param integer  of nothing: reads a reference
  template <typename Number, typename Integer>
  void add_entry(const MeditSection& section, const Number& number, const Integer& integer) {
    if (section.role == MeditRole::vertices) {
      held_.push_back(static_cast<Index>(number("a vertex", vertices())));
    } else if (section.role == MeditRole::edge_list) {
      hold_edge(number("an edge", edges()));
    } else if (section.role == MeditRole::cell_list) {
      hold_cell(section.kind, number("a cell", cells_of(section.kind)));
    } else {
      corners_.clear();
      for (std::size_t k = 0; k < section.corners; ++k) {
        corners_.push_back(static_cast<Index>(number("a vertex", vertices())));
      }
      add_cell_or_edge(section, integer());
    }
  }

  std::size_t vertices() const { return points_.size(); }

  /// All but the patch.
  MeshFile take_file();

 private:
  std::size_t edges() const { return edges_.size() / 2; }
  std::size_t cells_of(CellKind kind) const {
    return cells_of_[static_cast<std::size_t>(kind)].size();
  }
  void add_cell_or_edge(const MeditSection& section, std::int64_t reference);
  void hold_edge(std::size_t edge);
  /// Cells of a kind count from 0 each.
  void hold_cell(CellKind kind, std::size_t number);

  std::vector<Vec3> points_;
  std::map<std::int64_t, std::vector<Index>> vertices_by_reference_;
  Cells cells_;
  std::vector<std::size_t> cells_of_[kCellKinds];  // numbers of cells, by kind
  std::vector<std::int64_t> references_;           // of cells
  std::vector<Index> edges_;                       // pairs
  std::vector<std::int64_t> edge_references_;
  std::vector<Index> held_;
  std::vector<Index> corners_;  // of the entry at hand
};

}  // namespace evenmesh
