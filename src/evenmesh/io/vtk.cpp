// SPDX-License-Identifier: MIT
#include "evenmesh/io/vtk.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/text.h"
#include "evenmesh/io/byte_scanner.h"
#include "evenmesh/io/number_type.h"
#include "evenmesh/io/text_scanner.h"
#include "evenmesh/io/vtk_content.h"

namespace evenmesh {
namespace {

constexpr bool kSwap = true;  // binary files are big-endian, whatever the machine

/// What the words for types mean where VTK runs on a 64-bit machine, of which numbers consist.
std::optional<NumberType> number_type(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, NumberType>, 14> kTypes{{
      {"char", NumberType::int8},
      {"signed_char", NumberType::int8},
      {"unsigned_char", NumberType::uint8},
      {"short", NumberType::int16},
      {"unsigned_short", NumberType::uint16},
      {"int", NumberType::int32},
      {"unsigned_int", NumberType::uint32},
      {"vtkidtype", NumberType::int32},
      {"long", NumberType::int64},
      {"unsigned_long", NumberType::uint64},
      {"vtktypeint64", NumberType::int64},
      {"vtktypeuint64", NumberType::uint64},
      {"float", NumberType::float32},
      {"double", NumberType::float64},
  }};
  for (const auto& [name, type] : kTypes) {
    if (equal_but_for_case(name, word)) return type;
  }
  return std::nullopt;
}

/// "my array" of "my%20array".
std::string decoded(std::string_view name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned char code = 0;
    const char* const digits = name.data() + i + 1;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      result += static_cast<char>(code);
      i += 2;
    } else {
      result += name[i];
    }
  }
  return result;
}

/// Where the numbers of an array are.
struct Numbers {
  std::uint64_t offset;
  std::uint64_t count;
  NumberType type;
  bool binary;
};

std::vector<double> read_numbers(const InputFile& input, const Numbers& numbers) {
  std::vector<double> values;
  values.reserve(numbers.count);
  if (numbers.binary) {
    const std::string_view bytes =
        input.bytes().substr(numbers.offset, numbers.count * size_of(numbers.type));
    for_each_number(bytes, numbers.type, kSwap,
                    [&](auto value) { values.push_back(static_cast<double>(value)); });
    return values;
  }
  TextScanner scanner(input);
  scanner.set_place(input.bytes().data() + numbers.offset);
  while (values.size() < numbers.count) {
    const std::string_view word = scanner.word();
    double value = 0.0;
    if (std::from_chars(word.data(), word.data() + word.size(), value).ptr !=
        word.data() + word.size()) {
      input.fail_at(word.data(), fmt::format("'{}' in an array is not a number", shown(word)));
    }
    values.push_back(value);
  }
  return values;
}

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
  // ---- lines and numbers
  // -------------------------------------------------------------------------
  /// Moves behind the end of this line.
  void pass_line() {
    scanner_.skip_line();
    const char* p = scanner_.place();
    if (p != scanner_.end() && *p == '\r') ++p;
    if (p != scanner_.end() && *p == '\n') ++p;
    scanner_.set_place(p);
  }

  /// So many bytes behind this line, passed over.
  std::string_view take_bytes(std::uint64_t count, std::size_t bytes_each,
                              std::string_view things) {
    pass_line();
    return take_more_bytes(count, bytes_each, things);
  }
  std::string_view take_more_bytes(std::uint64_t count, std::size_t bytes_each,
                                   std::string_view things) {
    check_room(count, bytes_each, things);
    const std::string_view bytes(scanner_.place(), count * bytes_each);
    scanner_.set_place(scanner_.place() + bytes.size());
    return bytes;
  }

  /// Lines mean nothing where numbers are bytes.
  [[noreturn]] void fail(const char* place, std::string_view message) const {
    if (binary_) ByteScanner(*input_).fail(scanner_.offset(place), message);
    input_->fail_at(place, message);
  }
  [[noreturn]] void fail(std::string_view message) const { fail(scanner_.place(), message); }
  void check_room(std::uint64_t count, std::size_t bytes_each, std::string_view things) const {
    if (binary_) {
      ByteScanner(*input_, scanner_.offset()).check_room(count, bytes_each, things);
    } else {
      scanner_.check_room(count, bytes_each, things);
    }
  }

  NumberType take_type() {
    const char* const place = scanner_.place();
    const auto type = number_type(scanner_.word());
    if (!type) {
      fail(place, fmt::format("{} is no type of number here", quoted_word(place, scanner_.end())));
    }
    return *type;
  }

  template <typename Number>
  Index to_index(Number value, const char* place) const {
    if (value < 0 || static_cast<std::uint64_t>(value) >= std::numeric_limits<Index>::max()) {
      fail(place, fmt::format("there is no point {}", value));
    }
    return static_cast<Index>(value);
  }

  /// Whole numbers behind this line.
  template <typename Take>
  void take_whole_numbers(std::uint64_t count, NumberType type, std::string_view things,
                          const Take& take) {
    if (binary_) {
      const std::string_view bytes = take_bytes(count, size_of(type), things);
      for_each_number(bytes, type, kSwap, [&](auto value) {
        if constexpr (std::is_integral_v<decltype(value)>) take(value, bytes.data());
      });
      return;
    }
    check_room(count, 2, things);
    for (std::uint64_t i = 0; i < count; ++i) {
      scanner_.next();
      const char* const place = scanner_.place();
      take(scanner_.integer(things), place);
    }
  }

  // ---- sections
  // ----------------------------------------------------------------------------------
  void read_header() {
    const char* const first = scanner_.place();
    for (const std::string_view word : {"#", "vtk", "DataFile", "Version"}) {
      if (!equal_but_for_case(scanner_.word(), word)) {
        fail(first, "a VTK file begins with '# vtk DataFile Version 3.0'");
      }
    }
    const char* const place = scanner_.place();
    const std::string_view version = scanner_.word();
    std::from_chars(version.data(), version.data() + version.size(), version_);
    if (version_ < 1 || version_ > 5) {
      fail(place, fmt::format("version '{}' of VTK's files is not read; those up to 5.1 are",
                              shown(version)));
    }
    pass_line();
    pass_line();  // the title, which may be empty
    const std::string_view code = scanner_.word();
    binary_ = equal_but_for_case(code, "BINARY");
    if (!binary_ && !equal_but_for_case(code, "ASCII")) {
      fail("ASCII or BINARY is expected in the third line");
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
      fail(place,
           "triangle strips are not read; make triangles of them "
           "(vtkTriangleFilter)");
    }
    if (key == "cell_data" || key == "point_data")
      return read_data_count(place, key == "cell_data");
    if (data_count_ && read_attribute(key)) return;
    if (!data_count_) {
      fail(place, fmt::format("{} is not known here; was the file cut off or edited?",
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
      fail(place,
           "the points of this dataset lie on a grid and cannot move; save it as "
           "UNSTRUCTURED_GRID");
    }
    if (dataset_ != "unstructured_grid" && dataset_ != "polydata" &&
        dataset_ != "structured_grid") {
      fail(place, fmt::format("{} is no dataset with a mesh; UNSTRUCTURED_GRID, POLYDATA "
                              "and STRUCTURED_GRID are read",
                              quoted_word(place, scanner_.end())));
    }
  }

  /// It ends with an empty line.
  void skip_metadata() {
    for (;;) {
      pass_line();
      if (scanner_.place() == scanner_.end() || !scanner_.has_word()) return;
    }
  }

  void read_dimensions() {
    for (std::uint64_t& size : dimensions_) size = scanner_.count("a number of points");
  }

  void read_points(const char* place) {
    if (has_points_) fail(place, "POINTS again; there is one list of them");
    has_points_ = true;
    const std::uint64_t count = scanner_.count("the number of points");
    scanner_.next();
    const char* const type_place = scanner_.place();
    const NumberType type = take_type();
    if (!is_real(type)) fail(type_place, "points must be float or double");
    code_.single = type == NumberType::float32;
    if (binary_) return read_binary_points(count, type);
    constexpr std::size_t kLeast = 6;  // "0 0 0" and what ends it
    check_room(count, kLeast, "points");
    content_.reserve_points(count);
    places_.resize(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      content_.add_point(scanner_.position(3, i, places_[i]));
    }
  }

  void read_binary_points(std::uint64_t count, NumberType type) {
    code_.kind = code_.single ? CoordinateCode::Kind::float32 : CoordinateCode::Kind::float64;
    code_.swap = kSwap;
    const std::size_t each = 3 * size_of(type);
    const std::string_view bytes = take_bytes(count, each, "points");
    content_.reserve_points(count);
    places_.resize(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      const char* const p = bytes.data() + i * each;
      places_[i] = scanner_.offset(p);
      if (!content_.add_point(code_.position_at(p))) {
        fail(p, fmt::format("point {} has a coordinate that is no finite number; "
                            "repair the file or write it again",
                            i));
      }
    }
  }

  // ---- cells
  // -------------------------------------------------------------------------------------
  /// @param type  of all of them; 0: CELL_TYPES has them
  void read_cell_list(VtkCells& cells, std::uint8_t type = 0) {
    if (!cells.ends.empty()) fail("a second list of the same kind of cells");
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
    const std::size_t least = binary_ ? 2 * sizeof(std::int32_t) : 4;
    check_room(count, least, "cells");
    check_room(size, binary_ ? sizeof(std::int32_t) : 2, "numbers of cells");
    if (size < count) fail("the size of the list of cells is less than their number");
    cells.ends.reserve(count);
    cells.points.reserve(size - count);
    if (!binary_) cells.places.reserve(count);
    std::uint64_t points_left = 0;
    take_whole_numbers(size, NumberType::int32, "a number of the cells",
                       [&](auto value, const char* place) {
                         if (points_left > 0) {
                           cells.points.push_back(to_index(value, place));
                           --points_left;
                         } else {
                           begin_cell(cells, count, size, value, place);
                           points_left = static_cast<std::uint64_t>(value);
                           if (points_left == 0) return;
                         }
                         if (points_left == 0) cells.ends.push_back(cells.points.size());
                       });
    if (points_left == 0 && cells.ends.size() == count) return;
    fail(list, fmt::format("{} cells do not fill a list of {} numbers", count, size));
  }

  template <typename Number>
  void begin_cell(VtkCells& cells, std::uint64_t count, std::uint64_t size, Number points,
                  const char* place) {
    const std::size_t cell = cells.ends.size();
    if (cell == count) {
      fail(place,
           fmt::format("the list of {} cells is shorter than its size, {} numbers", count, size));
    }
    if (points < 0) fail(place, fmt::format("cell {} has {} points", cell, points));
    if (!binary_) cells.places.push_back(scanner_.offset(place));
    if (points == 0) cells.ends.push_back(cells.points.size());
  }

  /// Where each cell begins, then the points of all; since version 5.
  void read_offsets(VtkCells& cells, std::uint64_t offsets, std::uint64_t points) {
    expect("OFFSETS");
    const NumberType offset_type = take_type();
    std::uint64_t last = 0;
    bool is_first = true;
    check_room(offsets, 2, "offsets of cells");
    cells.ends.reserve(offsets);
    take_whole_numbers(
        offsets, offset_type, "an offset of a cell", [&](auto value, const char* place) {
          const auto offset = static_cast<std::uint64_t>(value);
          if (value < 0 || offset < last || offset > points || (is_first && offset != 0)) {
            fail(place, fmt::format("offset {} of a cell follows {}; the "
                                    "list has {} points",
                                    value, last, points));
          }
          last = offset;
          if (!is_first) cells.ends.push_back(offset);
          is_first = false;
        });
    expect("CONNECTIVITY");
    const NumberType type = take_type();
    check_room(points, 2, "points of cells");
    cells.points.reserve(points);
    take_whole_numbers(points, type, "a point of a cell", [&](auto value, const char* place) {
      cells.points.push_back(to_index(value, place));
    });
  }

  void expect(std::string_view key) {
    scanner_.next();
    const char* const place = scanner_.place();
    if (equal_but_for_case(scanner_.word(), key)) return;
    fail(place, fmt::format("{} where {} is expected", quoted_word(place, scanner_.end()), key));
  }

  void read_cell_types(const char* place) {
    const std::uint64_t count = scanner_.count("the number of cells");
    if (count != cells_.ends.size()) {
      fail(place, fmt::format("{} types for {} cells", count, cells_.ends.size()));
    }
    cells_.types.clear();
    cells_.types.reserve(count);
    take_whole_numbers(count, NumberType::int32, "the type of a cell",
                       [&](auto value, const char* at) {
                         constexpr int kMost = 255;
                         if (value < 0 || static_cast<std::uint64_t>(value) > kMost) {
                           fail(at, fmt::format("there is no type {} of cell", value));
                         }
                         cells_.types.push_back(static_cast<std::uint8_t>(value));
                       });
  }

  /// The cells of a structured grid, which are not in the file.
  void make_structured_cells() {
    std::array<std::uint64_t, 3> cells{};
    std::uint64_t points = 1;
    std::vector<std::size_t> axes;  // along which there are cells
    for (std::size_t k = 0; k < 3; ++k) {
      cells[k] = dimensions_[k] > 1 ? dimensions_[k] - 1 : 1;
      if (dimensions_[k] > 1) axes.push_back(k);
      points = dimensions_[k] > content_.points() ? content_.points() + 1 : points * dimensions_[k];
      points = std::min<std::uint64_t>(points, content_.points() + 1);
    }
    if (points != content_.points()) {
      input_->fail(fmt::format("DIMENSIONS {} {} {} do not give the {} points that there are",
                               dimensions_[0], dimensions_[1], dimensions_[2], content_.points()));
    }
    if (axes.size() < 2) return;
    const std::array<std::uint64_t, 3> step = {1, dimensions_[0], dimensions_[0] * dimensions_[1]};
    const std::uint64_t u = step[axes[0]];
    const std::uint64_t v = step[axes[1]];
    for (std::uint64_t k = 0; k < cells[2]; ++k) {
      for (std::uint64_t j = 0; j < cells[1]; ++j) {
        for (std::uint64_t i = 0; i < cells[0]; ++i) {
          const std::uint64_t first = i * step[0] + j * step[1] + k * step[2];
          for (const std::uint64_t corner : {first, first + u, first + u + v, first + v}) {
            cells_.points.push_back(static_cast<Index>(corner));
          }
          if (axes.size() == 3) {
            for (std::size_t c = 0; c < 4; ++c) {
              cells_.points.push_back(
                  static_cast<Index>(cells_.points[cells_.points.size() - 4] + step[2]));
            }
          }
          cells_.ends.push_back(cells_.points.size());
        }
      }
    }
    cells_.types.assign(cells_.ends.size(), axes.size() == 3 ? kVtkHex : kVtkQuad);
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

  // ---- arrays
  // ------------------------------------------------------------------------------------
  void read_data_count(const char* place, bool on_cells) {
    const std::uint64_t count = scanner_.count("the number of values");
    const std::uint64_t things = on_cells ? cell_count() : content_.points();
    if (count != things) {
      fail(place, fmt::format("data for {0} {2}, but there are {1} {2}", count, things,
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
    const std::string name = decoded(scanner_.word());
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
      if (!scanner_.next()) fail(fmt::format("the file ends after {} of {} arrays", i, arrays));
      const char* const place = scanner_.place();
      const std::string_view word = scanner_.word();
      if (equal_but_for_case(word, "metadata")) {  // of the array before
        skip_metadata();
        --i;
        continue;
      }
      const std::uint64_t components = scanner_.count("the number of components");
      const std::uint64_t count = scanner_.count("the number of values");
      if (!read_array(decoded(word), count, components, scanner_.word())) return stop(place);
    }
  }

  /// Passes over an array, and offers it for selection if it has one number per point or cell.
  /// @return  false if its size is unknown
  bool read_array(std::string name, std::uint64_t count, std::uint64_t components,
                  std::string_view type_name) {
    const std::uint64_t most = input_->bytes().size();  // even bits are fewer than 8 times as many
    if (components > most || (components > 0 && count > 8 * most / components)) {
      fail(fmt::format("an array of {} times {} numbers; the file is shorter", count, components));
    }
    const std::uint64_t numbers = count * components;
    const auto type = number_type(type_name);
    if (equal_but_for_case(type_name, "bit")) {
      constexpr std::uint64_t kBits = 8;
      skip_numbers(numbers, binary_ ? (numbers + kBits - 1) / kBits : 0);
    } else if (equal_but_for_case(type_name, "string") ||
               equal_but_for_case(type_name, "utf8_string")) {
      skip_strings(numbers);
    } else if (type) {
      std::uint64_t offset = 0;
      if (binary_) {
        const std::string_view bytes = take_bytes(numbers, size_of(*type), "numbers");
        offset = scanner_.offset(bytes.data());
      } else {
        offset = skip_numbers(numbers, 0);
      }
      if (data_count_ && components == 1 && count == *data_count_ && !name.empty()) {
        const Numbers place{.offset = offset, .count = count, .type = *type, .binary = binary_};
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

  /// @return  where they begin
  std::uint64_t skip_numbers(std::uint64_t count, std::uint64_t bytes) {
    if (binary_) {
      take_bytes(bytes, 1, "bytes");
      return 0;
    }
    check_room(count, 2, "numbers");
    scanner_.next();
    const std::uint64_t offset = scanner_.offset();
    for (std::uint64_t i = 0; i < count; ++i) {
      if (scanner_.word().empty()) {
        fail(fmt::format("the file ends after {} of {} numbers of an array; it was cut off", i,
                         count));
      }
    }
    return offset;
  }

  /// A text has a line for each; else a string follows its length, whose first two bits say how
  /// many bytes the length has.
  void skip_strings(std::uint64_t count) {
    pass_line();
    for (std::uint64_t i = 0; i < count; ++i) {
      if (scanner_.place() == scanner_.end()) {
        fail(fmt::format("the file ends after {} of {} strings; it was cut off", i, count));
      }
      if (!binary_) {
        pass_line();
        continue;
      }
      constexpr std::array<std::size_t, 4> kLengthBytes = {8, 4, 2, 1};
      const auto first = static_cast<unsigned char>(*scanner_.place());
      std::uint64_t length = first & 0x3fU;
      const std::string_view bytes = take_more_bytes(kLengthBytes[first >> 6U], 1, "bytes");
      for (const char c : bytes.substr(1)) length = length << 8U | static_cast<unsigned char>(c);
      take_more_bytes(length, 1, "bytes");
    }
  }

  std::shared_ptr<const InputFile> input_;
  TextScanner scanner_;
  VtkContent content_;
  int version_ = 0;
  bool binary_ = false;
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
