// SPDX-License-Identifier: MIT
#include "evenmesh/io/vtk_xml.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <type_traits>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/text.h"
#include "evenmesh/io/encoded_patch.h"
#include "evenmesh/io/number_type.h"
#include "evenmesh/io/text_scanner.h"
#include "evenmesh/io/vtk_content.h"
#include "evenmesh/io/vtk_encoding.h"
#include "evenmesh/io/xml_scanner.h"

namespace evenmesh {
namespace {

std::optional<NumberType> number_type(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, NumberType>, 10> kTypes{{
      {"Int8", NumberType::int8},
      {"UInt8", NumberType::uint8},
      {"Int16", NumberType::int16},
      {"UInt16", NumberType::uint16},
      {"Int32", NumberType::int32},
      {"UInt32", NumberType::uint32},
      {"Int64", NumberType::int64},
      {"UInt64", NumberType::uint64},
      {"Float32", NumberType::float32},
      {"Float64", NumberType::float64},
  }};
  for (const auto& [name, type] : kTypes) {
    if (name == word) return type;
  }
  return std::nullopt;
}

enum class Section : std::uint8_t {
  none,
  point_data,
  cell_data,
  points,
  cells,
  verts,
  lines,
  strips,
  polys
};

Section section_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Section>, 8> kSections{{
      {"PointData", Section::point_data},
      {"CellData", Section::cell_data},
      {"Points", Section::points},
      {"Cells", Section::cells},
      {"Verts", Section::verts},
      {"Lines", Section::lines},
      {"Strips", Section::strips},
      {"Polys", Section::polys},
  }};
  for (const auto& [word, section] : kSections) {
    if (word == name) return section;
  }
  return Section::none;
}

struct Array {
  XmlTag tag;
  Section section = Section::none;
  std::string name = {};
  std::optional<NumberType> type = {};  // nothing: bits or strings
  std::uint64_t components = 1;
  enum class Place : std::uint8_t { text, letters, appended };
  Place place = Place::text;
  std::uint64_t begin = 0;  // in the file; appended: behind the place where arrays begin
  std::uint64_t end = 0;    // of what is not appended
};

struct Piece {
  XmlTag tag;
  std::vector<Array> arrays;

  const Array* find(Section section, std::string_view name) const {
    const auto at = std::find_if(arrays.begin(), arrays.end(), [&](const Array& array) {
      return array.section == section && (name.empty() || array.name == name);
    });
    return at == arrays.end() ? nullptr : &*at;
  }
};

/// What is needed to take arrays out of a file, now and later.
struct Source {
  std::shared_ptr<const InputFile> input;
  VtkEncoding inline_encoding = {};
  VtkEncoding appended_encoding = {};
  std::uint64_t appended = 0;      // where arrays begin that are behind the tags
  std::uint64_t appended_end = 0;  // 0: there are none

  const VtkEncoding& encoding(const Array& array) const {
    return array.place == Array::Place::appended ? appended_encoding : inline_encoding;
  }
  std::uint64_t begin(const Array& array) const {
    return array.place == Array::Place::appended ? appended + array.begin : array.begin;
  }
  std::uint64_t end(const Array& array) const {
    return array.place == Array::Place::appended ? appended_end : array.end;
  }

  [[noreturn]] void fail(const Array& array, std::string_view message) const {
    input->fail_at(array.tag.first, fmt::format("the array '{}' {}", shown(array.name), message));
  }

  VtkBytes bytes(const Array& array) const {
    if (array.place == Array::Place::appended && begin(array) >= appended_end) {
      fail(array, "begins behind the end of the file; it was cut off, copy or export it again");
    }
    // So much may a compressed file grow.
    constexpr std::uint64_t kRatio = 100;
    constexpr std::uint64_t kAlways = 16 << 20;
    return decode(*input, begin(array), end(array), encoding(array),
                  kRatio * input->bytes().size() + kAlways);
  }

  /// Calls take with each number.
  template <typename Take>
  void for_each(const Array& array, const Take& take) const {
    if (!array.type) fail(array, "holds no numbers");
    if (array.place != Array::Place::text) {
      const VtkBytes all = bytes(array);
      if (all.bytes().size() % size_of(*array.type) != 0) fail(array, "ends within a number");
      for_each_number(all.bytes(), *array.type, inline_encoding.swap, take);
      return;
    }
    TextScanner scanner(*input);
    scanner.set_part(input->bytes().data() + array.begin, input->bytes().data() + array.end,
                     "the array");
    while (scanner.next()) {
      if (is_real(*array.type)) {
        take(real(scanner));
      } else {
        take(scanner.integer("a whole number"));
      }
    }
  }

 private:
  /// NaN is a number in arrays that are no coordinates.
  static double real(TextScanner& scanner) {
    const std::string_view word = scanner.word();
    double value = 0.0;
    if (std::from_chars(word.data(), word.data() + word.size(), value).ptr !=
        word.data() + word.size()) {
      scanner.fail(word.data(), fmt::format("'{}' is not a number", shown(word)));
    }
    return value;
  }
};

/// An array over all pieces, for selection.
struct WholeArray {
  Source source;
  std::vector<Array> pieces;
  std::vector<std::uint64_t> counts;

  std::vector<double> values() const {
    std::vector<double> result;
    std::uint64_t wanted = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      source.for_each(pieces[i], [&](auto value) { result.push_back(static_cast<double>(value)); });
      wanted += counts[i];
      if (result.size() != wanted) {
        source.fail(pieces[i], fmt::format("has not the {} numbers that it should", counts[i]));
      }
    }
    return result;
  }
};

class Reader {
 public:
  Reader(std::shared_ptr<const InputFile> input, std::string_view format)
      : input_(std::move(input)), format_(format), content_(input_) {}

  MeshFile read() {
    read_tags();
    for (const Piece& piece : pieces_) read_piece(piece);
    if (pieces_.empty()) input_->fail("has no <Piece>; it was cut off, copy or export it again");
    add_arrays();
    MeshFile file = content_.take_file();
    file.patch = make_patch();
    return file;
  }

 private:
  // ---- tags ----
  void read_tags() {
    XmlScanner scanner(input_->bytes());
    XmlTag tag;
    if (!scanner.next(tag) || tag.name != "VTKFile" || tag.closes) {
      input_->fail("does not begin with <VTKFile>");
    }
    read_root(tag);
    Section section = Section::none;
    bool complete = false;
    while (!complete && scanner.next(tag)) {
      const Section here = section_of(tag.name);
      if (tag.name == "VTKFile") {
        complete = tag.closes;
      } else if (tag.name == "AppendedData" && !tag.closes) {
        read_appended(tag);
        complete = true;
      } else if (tag.name == "Piece") {
        if (!tag.closes) pieces_.push_back({.tag = tag, .arrays = {}});
      } else if (here != Section::none) {
        section = tag.closes || tag.empty ? Section::none : here;
      } else if ((tag.name == "DataArray" || tag.name == "Array") && !tag.closes) {
        read_array(tag, section);
      }
    }
    if (!complete) input_->fail("ends before </VTKFile>; it was cut off, copy or export it again");
  }

  void read_root(const XmlTag& tag) {
    const std::string_view type = tag.get("type");
    const std::string_view wanted = format_ == "vtp" ? "PolyData" : "UnstructuredGrid";
    if (type != wanted) {
      input_->fail_at(
          tag.first,
          fmt::format("a VTK file of type '{}'; UnstructuredGrid (.vtu) and PolyData "
                      "(.vtp) are read{}",
                      shown(type), type.starts_with('P') ? "; smooth its parts one by one" : ""));
    }
    VtkEncoding encoding{.base64 = true};
    encoding.swap = tag.get("byte_order") == "BigEndian";
    encoding.header_bytes = tag.get("header_type") == "UInt64" ? 8 : 4;
    const std::string_view compressor = tag.get("compressor");
    encoding.compressed = !compressor.empty();
    if (encoding.compressed && compressor != "vtkZLibDataCompressor") {
      input_->fail_at(tag.first, fmt::format("arrays packed by {} are not read; write them with "
                                             "vtkZLibDataCompressor or without compression",
                                             shown(compressor)));
    }
    source_ = {.input = input_, .inline_encoding = encoding, .appended_encoding = encoding};
  }

  void read_appended(const XmlTag& tag) {
    const std::string_view bytes = input_->bytes();
    const auto from = static_cast<std::size_t>(tag.last - bytes.data());
    const std::size_t mark = bytes.find('_', from);
    const std::size_t end = bytes.rfind("</AppendedData");
    if (mark == std::string_view::npos || end == std::string_view::npos || end <= mark) {
      input_->fail_at(tag.first,
                      "the appended data have no '_' in front or no end; the file was "
                      "cut off, copy or export it again");
    }
    source_.appended_encoding.base64 = tag.get("encoding") != "raw";
    source_.appended = mark + 1;
    source_.appended_end = end;
  }

  void read_array(const XmlTag& tag, Section section) {
    Array array{.tag = tag, .section = section};
    array.name = without_entities(tag.get("Name"));
    array.type = number_type(tag.get("type"));
    if (const auto components = tag.find("NumberOfComponents")) {
      array.components = number(tag, *components);
    }
    const std::string format = lower(tag.get("format", "ascii"));
    if (format == "appended") {
      array.place = Array::Place::appended;
      const auto offset = tag.find("offset");
      if (!offset) input_->fail_at(tag.first, "an appended array without an offset");
      array.begin = number(tag, *offset);
      offsets_.push_back({place(offset->data()), offset->size(), array.begin});
    } else {
      array.place = format == "binary" ? Array::Place::letters : Array::Place::text;
      set_text(array);
    }
    // What is in no piece belongs to the whole file.
    if (!pieces_.empty() && section != Section::none)
      pieces_.back().arrays.push_back(std::move(array));
  }

  /// Where the text of an array is: up to the next tag, without white space around it.
  void set_text(Array& array) const {
    const std::string_view bytes = input_->bytes();
    std::size_t begin = place(array.tag.last);
    std::size_t end = array.tag.empty ? begin : std::min(bytes.find('<', begin), bytes.size());
    while (begin < end && is_space(bytes[begin])) ++begin;
    while (begin < end && is_space(bytes[end - 1])) --end;
    array.begin = begin;
    array.end = end;
  }

  std::uint64_t place(const char* p) const {
    return static_cast<std::uint64_t>(p - input_->bytes().data());
  }

  std::uint64_t number(const XmlTag& tag, std::string_view text) const {
    const std::string_view digits = trimmed(text);
    std::uint64_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error == std::errc() && stop == end) return value;
    input_->fail_at(tag.first, fmt::format("'{}' is no number of something", shown(text)));
  }

  std::uint64_t count(const Piece& piece, std::string_view attribute) const {
    const auto text = piece.tag.find(attribute);
    if (!text) input_->fail_at(piece.tag.first, fmt::format("a piece without {}", attribute));
    return number(piece.tag, *text);
  }

  // ---- pieces ----
  void read_piece(const Piece& piece) {
    const std::size_t first = content_.points();
    const std::uint64_t points = count(piece, "NumberOfPoints");
    if (points > 0) read_points(piece, points);
    std::uint64_t in_piece = 0;
    if (format_ == "vtp") {
      in_piece += read_polygons(piece, Section::verts, "NumberOfVerts", kVtkPolyVertex, first);
      in_piece += read_polygons(piece, Section::lines, "NumberOfLines", kVtkPolyLine, first);
      const auto strips = piece.tag.find("NumberOfStrips");
      if (strips && number(piece.tag, *strips) > 0) {
        input_->fail_at(piece.tag.first,
                        "triangle strips are not read; make triangles of them "
                        "(vtkTriangleFilter)");
      }
      in_piece += read_polygons(piece, Section::polys, "NumberOfPolys", kVtkPolygon, first);
    } else {
      in_piece = count(piece, "NumberOfCells");
      VtkCells cells = read_lists(piece, Section::cells, in_piece);
      if (in_piece > 0) {
        cells.types.reserve(std::min<std::size_t>(in_piece, input_->bytes().size()));
        source_.for_each(array(piece, Section::cells, "types"), [&](auto value) {
          cells.types.push_back(static_cast<std::uint8_t>(value));
        });
      }
      if (cells.types.size() != in_piece) {
        input_->fail_at(piece.tag.first,
                        fmt::format("{} types for {} cells", cells.types.size(), in_piece));
      }
      content_.add_cells(cells, first);
    }
    points_in_.push_back(points);
    cells_in_.push_back(in_piece);
  }

  const Array& array(const Piece& piece, Section section, std::string_view name) const {
    if (const Array* const found = piece.find(section, name)) return *found;
    input_->fail_at(piece.tag.first,
                    fmt::format("a piece without {}; it was cut off, copy or export it again",
                                name.empty() ? std::string_view("points") : name));
  }

  void read_points(const Piece& piece, std::uint64_t count) {
    const Array& found = array(piece, Section::points, "");
    const auto arrays = std::count_if(piece.arrays.begin(), piece.arrays.end(),
                                      [](const Array& a) { return a.section == Section::points; });
    if (arrays > 1) source_.fail(found, "is one of several of points; keep one time step");
    if (!found.type || !is_real(*found.type) || found.components != 3) {
      source_.fail(found, "must have points of three components, Float32 or Float64");
    }
    take_code(found);
    const std::size_t first = content_.points();
    if (found.place == Array::Place::text) {
      read_text_points(found);
    } else {
      read_encoded_points(found);
    }
    if (content_.points() - first != count) {
      source_.fail(found, fmt::format("has {} points, and the piece says {}",
                                      content_.points() - first, count));
    }
  }

  void take_code(const Array& found) {
    CoordinateCode code;
    code.single = *found.type == NumberType::float32;
    if (found.place != Array::Place::text) {
      code.kind = code.single ? CoordinateCode::Kind::float32 : CoordinateCode::Kind::float64;
      code.swap = source_.inline_encoding.swap;
    }
    const bool same =
        code.kind == code_.kind && code.single == code_.single && found.place == points_place_;
    if (content_.points() > 0 && !same) {
      source_.fail(found, "is written in another way than the points of the piece before");
    }
    code_ = code;
    points_place_ = found.place;
  }

  void read_text_points(const Array& found) {
    TextScanner scanner(*input_);
    scanner.set_part(input_->bytes().data() + found.begin, input_->bytes().data() + found.end,
                     "the array");
    while (scanner.next()) {
      places_.push_back(0);
      content_.add_point(scanner.position(3, content_.points(), places_.back()));
    }
  }

  void read_encoded_points(const Array& found) {
    const VtkBytes taken = source_.bytes(found);
    const std::size_t each = 3 * code_.bytes_each();
    const std::size_t count = taken.bytes().size() / each;
    if (taken.bytes().size() % each != 0) source_.fail(found, "ends within a point");
    const std::uint64_t begin = source_.begin(found);
    encoded_.push_back({begin, begin + taken.length, content_.points(), count});
    content_.reserve_points(content_.points() + count);
    for (std::size_t i = 0; i < count; ++i) {
      if (content_.add_point(code_.position_at(taken.bytes().data() + i * each))) continue;
      source_.fail(found, fmt::format("has a coordinate of point {} that is no finite number; "
                                      "repair the file or write it again",
                                      content_.points() - 1));
    }
  }

  std::uint64_t read_polygons(const Piece& piece, Section section, std::string_view attribute,
                              std::uint8_t type, std::size_t first) {
    const auto text = piece.tag.find(attribute);
    const std::uint64_t count = text ? number(piece.tag, *text) : 0;
    VtkCells cells = read_lists(piece, section, count);
    cells.types.assign(cells.ends.size(), type);
    content_.add_cells(cells, first);
    return count;
  }

  /// The points of cells and where each cell ends in them.
  VtkCells read_lists(const Piece& piece, Section section, std::uint64_t count) const {
    VtkCells cells;
    if (count == 0) return cells;
    const Array& points = array(piece, section, "connectivity");
    // What is promised is believed only as far as the file could hold it.
    const std::size_t expected = std::min<std::size_t>(count, input_->bytes().size() / 4);
    cells.points.reserve(3 * expected);
    cells.ends.reserve(expected);
    source_.for_each(points, [&](auto value) {
      if (!(value >= 0 && static_cast<double>(value) < std::numeric_limits<Index>::max())) {
        source_.fail(points, fmt::format("names point {}", value));
      }
      cells.points.push_back(static_cast<Index>(value));
    });
    const Array& ends = array(piece, section, "offsets");
    std::uint64_t last = 0;
    source_.for_each(ends, [&](auto value) {
      const auto end = value >= 0 ? static_cast<std::uint64_t>(value) : 0;
      if (value < 0 || end < last || end > cells.points.size()) {
        source_.fail(ends, fmt::format("has {} behind {}; there are {} points of cells", value,
                                       last, cells.points.size()));
      }
      cells.ends.push_back(last = end);
    });
    if (cells.ends.size() != count) {
      source_.fail(ends, fmt::format("has {} numbers for {} cells", cells.ends.size(), count));
    }
    return cells;
  }

  // ---- arrays ----
  /// Those of one number per point or cell that all pieces have.
  void add_arrays() {
    for (const Array& first : pieces_[0].arrays) {
      const bool on_cells = first.section == Section::cell_data;
      if (!on_cells && first.section != Section::point_data) continue;
      WholeArray whole{
          .source = source_, .pieces = {}, .counts = on_cells ? cells_in_ : points_in_};
      for (const Piece& piece : pieces_) {
        const Array* const same = piece.find(first.section, first.name);
        if (same == nullptr || !same->type || same->components != 1) break;
        whole.pieces.push_back(*same);
      }
      if (first.name.empty() || whole.pieces.size() != pieces_.size()) continue;
      const auto shared = std::make_shared<const WholeArray>(std::move(whole));
      content_.add_array({.name = first.name,
                          .on_cells = on_cells,
                          .whole = !is_real(*first.type),
                          .values = [shared] { return shared->values(); }});
    }
  }

  std::unique_ptr<FilePatch> make_patch() {
    FileNumbers numbers = content_.take_numbers();
    if (points_place_ == Array::Place::text) {
      return std::make_unique<PlacedPatch>(format_, input_, code_, std::move(places_),
                                           std::move(numbers));
    }
    check_own_arrays();
    const VtkEncoding& encoding = points_place_ == Array::Place::appended
                                      ? source_.appended_encoding
                                      : source_.inline_encoding;
    return std::make_unique<EncodedPatch>(format_, input_, code_, std::move(numbers), encoding,
                                          std::move(encoded_), source_.appended,
                                          std::move(offsets_));
  }

  /// Arrays may share their bytes, but what the points have must be theirs alone.
  void check_own_arrays() const {
    for (const EncodedPoints& points : encoded_) {
      const auto sharing =
          std::count_if(offsets_.begin(), offsets_.end(), [&](const EncodedOffset& offset) {
            const std::uint64_t at = source_.appended + offset.offset;
            return at >= points.begin && at < points.end;
          });
      if (sharing <= 1) continue;
      input_->fail("another array shares the bytes of the points; write the file again");
    }
  }

  std::shared_ptr<const InputFile> input_;
  std::string_view format_;
  VtkContent content_;
  Source source_;
  std::vector<Piece> pieces_;
  std::vector<std::uint64_t> points_in_, cells_in_;  // of each piece
  Array::Place points_place_ = Array::Place::text;
  CoordinateCode code_;
  std::vector<std::uint64_t> places_;   // of vertices in text
  std::vector<EncodedPoints> encoded_;  // else
  std::vector<EncodedOffset> offsets_;
};

}  // namespace

std::optional<std::string_view> vtk_xml_dataset(std::string_view begin) {
  XmlScanner scanner(begin);
  XmlTag tag;
  if (!scanner.next(tag) || tag.name != "VTKFile") return std::nullopt;
  return tag.get("type");
}

MeshFile read_vtu(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input), "vtu").read();
}

MeshFile read_vtp(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input), "vtp").read();
}

}  // namespace evenmesh
