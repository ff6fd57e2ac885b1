// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"
#include "evenmesh/io/placed_patch.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// VTK's number for some types of cell, which a file may mean without writing it.
enum VtkCellNumber : std::uint8_t {
  kVtkPolyVertex = 2,
  kVtkPolyLine = 4,
  kVtkPolygon = 7,
  kVtkQuad = 9,
  kVtkHex = 12
};

/// The cells of a file, or of a piece of it, as VTK lists them.
struct VtkCells {
  std::vector<std::uint8_t> types;    // VTK's number of each cell's type
  std::vector<Offset> ends;           // where each one's points end in the list of all
  std::vector<Index> points;          // of all cells, one behind the other
  std::vector<std::uint64_t> places;  // where each stands in a text; empty: unknown
};

/// The quads or hexes of a grid of points, x fastest; none in a line of points.
/// @param dimensions  numbers of points along x, y and z
VtkCells structured_cells(const std::array<std::uint64_t, 3>& dimensions);

/// An array of a file, over all of its points or all of its cells.
struct VtkArray {
  std::string name;
  bool on_cells = false;
  bool whole = false;  // of a type for whole numbers
  /// One number per point or cell of the file.
  std::function<std::vector<double>()> values;
};

/// What the formats of VTK have in common: points, cells by numbers of types, arrays.
class VtkContent {
 public:
  explicit VtkContent(std::shared_ptr<const InputFile> input) : input_(std::move(input)) {}

  void reserve_points(std::size_t count) { points_.reserve(count); }
  /// @return  false if the position is not finite
  bool add_point(const Vec3& position);
  std::size_t points() const { return points_.size(); }

  /// Takes cells; vertices and lines become none.
  /// @param first_point  what number 0 of these cells means
  /// @throws IoError  a type that is not read, with the wrong number of points, or with a point
  ///                  that is not there
  void add_cells(const VtkCells& cells, std::size_t first_point);
  void add_array(VtkArray array) { arrays_.push_back(std::move(array)); }
  void add_note(std::string note) { notes_.push_back(std::move(note)); }

  /// Everything but the patch. Cells get their groups from the first array over cells that has a
  /// name for materials.
  MeshFile take_file();
  /// How messages name points and cells. To be called once, after take_file().
  FileNumbers take_numbers();

 private:
  using Numbers = std::shared_ptr<const std::vector<std::uint64_t>>;

  void add_cell(std::size_t cell, std::uint8_t type, std::span<Index> points);
  [[noreturn]] void fail(std::size_t cell, std::string_view message) const;
  void check_not_torn() const;
  CellKind kind_of(std::size_t cell, std::uint8_t type, std::size_t points) const;
  void add_line(std::uint8_t type, std::span<const Index> points, std::size_t number);
  void set_groups(std::vector<std::string>& names);
  DataArray data_array(const VtkArray& array, const Numbers& numbers) const;

  std::shared_ptr<const InputFile> input_;
  std::vector<Vec3> points_;
  Cells cells_;
  Followers followers_;
  bool counted_ = true;                     // every cell of the file is one of the mesh
  std::vector<std::uint64_t> numbers_;      // else: in the file, of each cell
  std::vector<std::uint64_t> places_;       // of each cell in a text
  std::vector<Index> lines_;                // pairs
  std::vector<std::size_t> line_numbers_;   // in the file, of the cell that each is of
  std::vector<std::uint32_t> line_labels_;  // by their groups; 0: none
  std::size_t in_file_ = 0;                 // cells, vertices and lines
  std::size_t before_ = 0;                  // of these in the pieces before the one at hand
  const VtkCells* piece_ = nullptr;         // at hand
  std::vector<VtkArray> arrays_;
  std::vector<std::string> notes_;
};

}  // namespace evenmesh
