// SPDX-License-Identifier: MIT
#include "evenmesh/io/vtk.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/text.h"
#include "evenmesh/io/vtk_content.h"
#include "evenmesh/io/vtk_scanner.h"

namespace evenmesh {
namespace {

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), scanner_(*input_), content_(input_) {}

  MeshFile read() {
    read_header();
    while (!stopped_ && scanner_.next()) read_section();
    if (dataset_.empty()) input_->fail("has no DATASET; it was cut off, copy or export it again");
    if (!has_points_) input_->fail("has no POINTS; it was cut off, copy or export it again");
    add_cells();
    MeshFile file = content_.take_file();
    file.patch = std::make_unique<PlacedPatch>("vtk", input_, code_, std::move(places_),
                                               content_.take_numbers());
    return file;
  }

 private:
  // ---- sections ----
  void read_header() {
    const char* const first = scanner_.place();
    for (const std::string_view word : {"#", "vtk", "DataFile", "Version"}) {
      if (!equal_but_for_case(scanner_.word(), word)) {
        scanner_.fail(first, "a VTK file begins with '# vtk DataFile Version 3.0'");
      }
    }
    const char* const place = scanner_.place();
    const std::string_view version = scanner_.word();
    std::from_chars(version.data(), version.data() + version.size(), version_);
    if (version_ < 1 || version_ > 5) {
      scanner_.fail(place,
                    fmt::format("version '{}' of VTK's files is not read; those up to 5.1 are",
                                shown(version)));
    }
    scanner_.pass_line();
    scanner_.pass_line();  // the title, which may be empty
    const std::string_view code = scanner_.word();
    scanner_.set_binary(equal_but_for_case(code, "BINARY"));
    if (!scanner_.is_binary() && !equal_but_for_case(code, "ASCII")) {
      scanner_.fail("ASCII or BINARY is expected in the third line");
    }
  }

  void read_section() {
    const char* const place = scanner_.place();
    const std::string key = lower(scanner_.word());
    if (key == "dataset") return read_dataset();
    if (key == "metadata") return skip_metadata();
    if (key == "field") return read_field();
    if (key == "dimensions") return read_dimensions();
    if (key == "points") return read_points(place);
    if (key == "cells") return read_cell_list(cells_);
    if (key == "cell_types") return read_cell_types(place);
    if (key == "vertices") return read_cell_list(vertices_, kVtkPolyVertex);
    if (key == "lines") return read_cell_list(lines_, kVtkPolyLine);
    if (key == "polygons") return read_cell_list(cells_, kVtkPolygon);
    if (key == "triangle_strips") {
      scanner_.fail(place,
                    "triangle strips are not read; make triangles of them "
                    "(vtkTriangleFilter)");
    }
    if (key == "cell_data" || key == "point_data")
      return read_data_count(place, key == "cell_data");
    if (data_count_ && read_attribute(key)) return;
    if (!data_count_) {
      scanner_.fail(place, fmt::format("{} is not known here; was the file cut off or edited?",
                                       quoted_word(place, scanner_.end())));
    }
    stop(place);
  }

  /// Leaves alone what follows.
  void stop(const char* place) {
    stopped_ = true;
    content_.add_note(fmt::format("What follows line {} is kept but not read: {} is not known.",
                                  input_->line_of(scanner_.offset(place)),
                                  quoted_word(place, scanner_.end())));
  }

  void read_dataset() {
    scanner_.next();
    const char* const place = scanner_.place();
    dataset_ = lower(scanner_.word());
    if (dataset_ == "structured_points" || dataset_ == "rectilinear_grid") {
      scanner_.fail(place,
                    "the points of this dataset lie on a grid and cannot move; save it as "
                    "UNSTRUCTURED_GRID");
    }
    if (dataset_ != "unstructured_grid" && dataset_ != "polydata" &&
        dataset_ != "structured_grid") {
      scanner_.fail(place, fmt::format("{} is no dataset with a mesh; UNSTRUCTURED_GRID, POLYDATA "
                                       "and STRUCTURED_GRID are read",
                                       quoted_word(place, scanner_.end())));
    }
  }

  /// It ends with an empty line.
  void skip_metadata() {
    for (;;) {
      scanner_.pass_line();
      if (scanner_.place() == scanner_.end() || !scanner_.has_word()) return;
    }
  }

  void read_dimensions() {
    for (std::uint64_t& size : dimensions_) size = scanner_.count("a number of points");
  }

  void read_points(const char* place) {
    if (has_points_) scanner_.fail(place, "POINTS again; there is one list of them");
    has_points_ = true;
    const std::uint64_t count = scanner_.count("the number of points");
    scanner_.next();
    const char* const type_place = scanner_.place();
    const NumberType type = scanner_.take_type();
    if (!is_real(type)) scanner_.fail(type_place, "points must be float or double");
    code_.single = type == NumberType::float32;
    if (scanner_.is_binary()) return read_binary_points(count, type);
    constexpr std::size_t kLeast = 6;  // "0 0 0" and what ends it
    scanner_.check_room(count, kLeast, "points");
    content_.reserve_points(count);
    places_.resize(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      content_.add_point(scanner_.position(3, i, places_[i]));
    }
  }

  void read_binary_points(std::uint64_t count, NumberType type) {
    code_.kind = code_.single ? CoordinateCode::Kind::float32 : CoordinateCode::Kind::float64;
    code_.swap = VtkScanner::kSwap;
    const std::size_t each = 3 * size_of(type);
    const std::string_view bytes = scanner_.take_bytes(count, each, "points");
    content_.reserve_points(count);
    places_.resize(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      const char* const p = bytes.data() + i * each;
      places_[i] = scanner_.offset(p);
      if (!content_.add_point(code_.position_at(p))) {
        scanner_.fail(p, fmt::format("point {} has a coordinate that is no finite number; "
                                     "repair the file or write it again",
                                     i));
      }
    }
  }

  // ---- cells ----
  /// @param type  of all of them; 0: CELL_TYPES has them
  void read_cell_list(VtkCells& cells, std::uint8_t type = 0) {
    if (!cells.ends.empty()) scanner_.fail("a second list of the same kind of cells");
    const std::uint64_t first = scanner_.count("the number of cells");
    const std::uint64_t second = scanner_.count("the size of their list");
    if (version_ >= 5) {
      read_offsets(cells, first, second);
    } else {
      read_counted(cells, first, second);
    }
    if (type != 0) cells.types.assign(cells.ends.size(), type);
  }

  /// Each cell with its number of points before them.
  void read_counted(VtkCells& cells, std::uint64_t count, std::uint64_t size) {
    const char* const list = scanner_.place();
    const std::size_t least = scanner_.is_binary() ? 2 * sizeof(std::int32_t) : 4;
    scanner_.check_room(count, least, "cells");
    scanner_.check_room(size, scanner_.is_binary() ? sizeof(std::int32_t) : 2, "numbers of cells");
    if (size < count) scanner_.fail("the size of the list of cells is less than their number");
    cells.ends.reserve(count);
    cells.points.reserve(size - count);
    if (!scanner_.is_binary()) cells.places.reserve(count);
    std::uint64_t points_left = 0;
    scanner_.take_whole_numbers(size, NumberType::int32, "a number of the cells",
                                [&](auto value, const char* place) {
                                  if (points_left > 0) {
                                    cells.points.push_back(scanner_.index(value, place));
                                    --points_left;
                                  } else {
                                    begin_cell(cells, count, size, value, place);
                                    points_left = static_cast<std::uint64_t>(value);
                                    if (points_left == 0) return;
                                  }
                                  if (points_left == 0) cells.ends.push_back(cells.points.size());
                                });
    if (points_left == 0 && cells.ends.size() == count) return;
    scanner_.fail(list, fmt::format("{} cells do not fill a list of {} numbers", count, size));
  }

  template <typename Number>
  void begin_cell(VtkCells& cells, std::uint64_t count, std::uint64_t size, Number points,
                  const char* place) {
    const std::size_t cell = cells.ends.size();
    if (cell == count) {
      scanner_.fail(place, fmt::format("the list of {} cells is shorter than its size, {} numbers",
                                       count, size));
    }
    if (points < 0) scanner_.fail(place, fmt::format("cell {} has {} points", cell, points));
    if (!scanner_.is_binary()) cells.places.push_back(scanner_.offset(place));
    if (points == 0) cells.ends.push_back(cells.points.size());
  }

  /// Where each cell begins, then the points of all; since version 5.
  void read_offsets(VtkCells& cells, std::uint64_t offsets, std::uint64_t points) {
    scanner_.expect("OFFSETS");
    const NumberType offset_type = scanner_.take_type();
    std::uint64_t last = 0;
    bool is_first = true;
    scanner_.check_room(offsets, 2, "offsets of cells");
    cells.ends.reserve(offsets);
    scanner_.take_whole_numbers(
        offsets, offset_type, "an offset of a cell", [&](auto value, const char* place) {
          const auto offset = static_cast<std::uint64_t>(value);
          if (value < 0 || offset < last || offset > points || (is_first && offset != 0)) {
            scanner_.fail(place, fmt::format("offset {} of a cell follows {}; the "
                                             "list has {} points",
                                             value, last, points));
          }
          last = offset;
          if (!is_first) cells.ends.push_back(offset);
          is_first = false;
        });
    scanner_.expect("CONNECTIVITY");
    const NumberType type = scanner_.take_type();
    scanner_.check_room(points, 2, "points of cells");
    cells.points.reserve(points);
    scanner_.take_whole_numbers(points, type, "a point of a cell",
                                [&](auto value, const char* place) {
                                  cells.points.push_back(scanner_.index(value, place));
                                });
  }

  void read_cell_types(const char* place) {
    const std::uint64_t count = scanner_.count("the number of cells");
    if (count != cells_.ends.size()) {
      scanner_.fail(place, fmt::format("{} types for {} cells", count, cells_.ends.size()));
    }
    cells_.types.clear();
    cells_.types.reserve(count);
    scanner_.take_whole_numbers(
        count, NumberType::int32, "the type of a cell", [&](auto value, const char* at) {
          constexpr int kMost = 255;
          if (value < 0 || static_cast<std::uint64_t>(value) > kMost) {
            scanner_.fail(at, fmt::format("there is no type {} of cell", value));
          }
          cells_.types.push_back(static_cast<std::uint8_t>(value));
        });
  }

  /// The cells of a structured grid are not in the file.
  void make_structured_cells() {
    std::uint64_t points = 1;
    for (const std::uint64_t size : dimensions_) {
      points = size > content_.points() ? content_.points() + 1 : points * size;
      points = std::min<std::uint64_t>(points, content_.points() + 1);
    }
    if (points != content_.points()) {
      input_->fail(fmt::format("DIMENSIONS {} {} {} do not give the {} points that there are",
                               dimensions_[0], dimensions_[1], dimensions_[2], content_.points()));
    }
    cells_ = structured_cells(dimensions_);
  }

  std::uint64_t cell_count() {
    if (dataset_ == "structured_grid" && cells_.ends.empty()) make_structured_cells();
    return vertices_.ends.size() + lines_.ends.size() + cells_.ends.size();
  }

  void add_cells() {
    cell_count();
    if (cells_.types.size() != cells_.ends.size()) {
      input_->fail("has CELLS but no CELL_TYPES; it was cut off, copy or export it again");
    }
    for (const VtkCells* cells : {&vertices_, &lines_, &cells_}) content_.add_cells(*cells, 0);
  }

  // ---- arrays ----
  void read_data_count(const char* place, bool on_cells) {
    const std::uint64_t count = scanner_.count("the number of values");
    const std::uint64_t things = on_cells ? cell_count() : content_.points();
    if (count != things) {
      scanner_.fail(place, fmt::format("data for {0} {2}, but there are {1} {2}", count, things,
                                       on_cells ? "cells" : "points"));
    }
    data_count_ = count;
    on_cells_ = on_cells;
  }

  /// @return  false if it is none that is known
  bool read_attribute(std::string_view key) {
    struct Attribute {
      std::string_view key;
      std::uint64_t components;
    };
    constexpr std::array kAttributes{
        Attribute{"scalars", 1},
        Attribute{"vectors", 3},
        Attribute{"normals", 3},
        Attribute{"tensors", 9},
        Attribute{"tensors6", 6},
        Attribute{"global_ids", 1},
        Attribute{"edge_flags", 1},
        Attribute{"pedigree_ids", 1},
        Attribute{"texture_coordinates", 2},
    };
    if (key == "lookup_table") {
      scanner_.word();
      constexpr std::uint64_t kColours = 4;
      return skip_colours(scanner_.count("the size of a table"), kColours);
    }
    if (key == "color_scalars") {
      scanner_.word();
      return skip_colours(*data_count_, scanner_.count("the number of colours"));
    }
    const auto* const found = std::find_if(kAttributes.begin(), kAttributes.end(),
                                           [key](const Attribute& a) { return a.key == key; });
    if (found == kAttributes.end()) return false;
    const std::string name = decoded_vtk_name(scanner_.word());
    std::uint64_t components = found->components;
    if (key == "texture_coordinates") components = scanner_.count("the number of coordinates");
    const std::string_view type = scanner_.word();
    if (key == "scalars") {
      if (scanner_.has_word()) components = scanner_.count("the number of components");
      const char* const line = scanner_.place();
      if (equal_but_for_case(scanner_.word(), "lookup_table")) {
        scanner_.word();
      } else {
        scanner_.set_place(line);
      }
    }
    return read_array(name, *data_count_, components, type);
  }

  /// Colours are numbers from 0 to 1 in a text, and bytes else.
  bool skip_colours(std::uint64_t count, std::uint64_t each) {
    return read_array("", count, each, "unsigned_char");
  }

  void read_field() {
    scanner_.word();
    const std::uint64_t arrays = scanner_.count("the number of arrays");
    for (std::uint64_t i = 0; i < arrays; ++i) {
      if (!scanner_.next())
        scanner_.fail(fmt::format("the file ends after {} of {} arrays", i, arrays));
      const char* const place = scanner_.place();
      const std::string_view word = scanner_.word();
      if (equal_but_for_case(word, "metadata")) {  // of the array before
        skip_metadata();
        --i;
        continue;
      }
      const std::uint64_t components = scanner_.count("the number of components");
      const std::uint64_t count = scanner_.count("the number of values");
      if (!read_array(decoded_vtk_name(word), count, components, scanner_.word()))
        return stop(place);
    }
  }

  /// Passes over an array, and offers it for selection if it has one number per point or cell.
  /// @return  false if its size is unknown
  bool read_array(std::string name, std::uint64_t count, std::uint64_t components,
                  std::string_view type_name) {
    const std::uint64_t most = input_->bytes().size();  // even bits are fewer than 8 times as many
    if (components > most || (components > 0 && count > 8 * most / components)) {
      scanner_.fail(
          fmt::format("an array of {} times {} numbers; the file is shorter", count, components));
    }
    const std::uint64_t numbers = count * components;
    const auto type = vtk_number_type(type_name);
    if (equal_but_for_case(type_name, "bit")) {
      constexpr std::uint64_t kBits = 8;
      scanner_.skip_numbers(numbers, scanner_.is_binary() ? (numbers + kBits - 1) / kBits : 0);
    } else if (equal_but_for_case(type_name, "string") ||
               equal_but_for_case(type_name, "utf8_string")) {
      scanner_.skip_strings(numbers);
    } else if (type) {
      std::uint64_t offset = 0;
      if (scanner_.is_binary()) {
        const std::string_view bytes = scanner_.take_bytes(numbers, size_of(*type), "numbers");
        offset = scanner_.offset(bytes.data());
      } else {
        offset = scanner_.skip_numbers(numbers, 0);
      }
      if (data_count_ && components == 1 && count == *data_count_ && !name.empty()) {
        const VtkNumbers place{offset, count, *type, scanner_.is_binary()};
        content_.add_array(
            {.name = std::move(name),
             .on_cells = on_cells_,
             .whole = !is_real(*type),
             .values = [input = input_, place] { return read_numbers(*input, place); }});
      }
    } else {
      return false;
    }
    return true;
  }

  std::shared_ptr<const InputFile> input_;
  VtkScanner scanner_;
  VtkContent content_;
  int version_ = 0;
  std::string dataset_;
  bool has_points_ = false;
  bool stopped_ = false;
  std::array<std::uint64_t, 3> dimensions_{};
  CoordinateCode code_;
  std::vector<std::uint64_t> places_;
  VtkCells vertices_, lines_, cells_;
  std::optional<std::uint64_t> data_count_;  // of the arrays that come
  bool on_cells_ = false;
};

}  // namespace

MeshFile read_vtk(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
