// SPDX-License-Identifier: MIT
#include "evenmesh/io/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/io/text_scanner.h"

namespace evenmesh {
namespace {

std::optional<NumberType> type_of(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, NumberType>, 16> kTypes{{
      {"char", NumberType::int8},
      {"int8", NumberType::int8},
      {"uchar", NumberType::uint8},
      {"uint8", NumberType::uint8},
      {"short", NumberType::int16},
      {"int16", NumberType::int16},
      {"ushort", NumberType::uint16},
      {"uint16", NumberType::uint16},
      {"int", NumberType::int32},
      {"int32", NumberType::int32},
      {"uint", NumberType::uint32},
      {"uint32", NumberType::uint32},
      {"float", NumberType::float32},
      {"float32", NumberType::float32},
      {"double", NumberType::float64},
      {"float64", NumberType::float64},
  }};
  for (const auto& [name, type] : kTypes) {
    if (name == word) return type;
  }
  return std::nullopt;
}

/// Reads the header line by line.
class HeaderReader {
 public:
  explicit HeaderReader(const InputFile& input) : scanner_(input) {
    scanner_.word();  // ply
  }

  PlyHeader read() {
    for (;;) {
      if (!scanner_.next()) {
        scanner_.fail("the file ends within its header; it was cut off, copy or export it again");
      }
      const char* const place = scanner_.place();
      const std::string_view word = scanner_.word();
      if (word == "end_header") break;
      if (word == "format") {
        read_format();
      } else if (word == "element") {
        read_element(place);
      } else if (word == "property") {
        read_property(place);
      } else if (word != "comment" && word != "obj_info") {
        scanner_.fail(place,
                      fmt::format("{} in the header; a PLY has format, element, property and "
                                  "comment there",
                                  quoted_word(place, scanner_.end())));
      }
      scanner_.skip_line();
    }
    header_.data = data_offset();
    return std::move(header_);
  }

 private:
  void read_format() {
    const std::string_view word = in_line("the format");
    if (word == "ascii") {
      header_.code = PlyHeader::Code::text;
    } else if (word == "binary_little_endian") {
      header_.code = PlyHeader::Code::little_endian;
    } else if (word == "binary_big_endian") {
      header_.code = PlyHeader::Code::big_endian;
    } else {
      scanner_.fail(word.data(), fmt::format("format {}; ascii, binary_little_endian and "
                                             "binary_big_endian are read",
                                             quoted_word(word.data(), scanner_.end())));
    }
  }

  void read_element(const char* place) {
    PlyElement element;
    element.place = place;
    element.name = in_line("the name of an element");
    in_line_ahead("the number of elements");
    element.count = scanner_.count("the number of elements");
    header_.elements.push_back(std::move(element));
  }

  void read_property(const char* place) {
    if (header_.elements.empty()) scanner_.fail(place, "a property before any element");
    PlyProperty property;
    property.place = place;
    std::string_view word = in_line("the type of a property");
    property.is_list = word == "list";
    if (property.is_list) {
      property.count_type = type(in_line("the type of a list's size"));
      if (is_real(property.count_type))
        scanner_.fail(place, "the size of a list is no whole number");
      word = in_line("the type of a list");
    }
    property.type = type(word);
    property.name = in_line("the name of a property");
    header_.elements.back().properties.push_back(property);
  }

  NumberType type(std::string_view word) const {
    if (const auto found = type_of(word)) return *found;
    scanner_.fail(word.data(),
                  fmt::format("{} is no type of a PLY", quoted_word(word.data(), scanner_.end())));
  }

  void in_line_ahead(std::string_view what) {
    if (!scanner_.has_word()) scanner_.fail(fmt::format("{} is missing in this line", what));
  }
  std::string_view in_line(std::string_view what) {
    in_line_ahead(what);
    return scanner_.word();
  }

  /// Behind the end of the header's last line. Some programs end only that one with CR LF; where
  /// lines end with CR alone, a line feed behind it is the first byte of the data.
  std::uint64_t data_offset() {
    scanner_.skip_line();
    const std::string_view bytes = scanner_.input().bytes();
    const std::uint64_t at = scanner_.offset();
    if (at == bytes.size()) return at;
    const std::string_view first_end = bytes.substr(bytes.find_first_of("\r\n"));
    const bool alone = first_end.starts_with("\r") && !first_end.starts_with("\r\n");
    return at + (bytes.substr(at).starts_with("\r\n") && !alone ? 2 : 1);
  }

  TextScanner scanner_;
  PlyHeader header_;
};

}  // namespace

const PlyProperty* PlyElement::find(std::string_view property) const {
  const auto at = std::find_if(properties.begin(), properties.end(),
                               [property](const PlyProperty& p) { return p.name == property; });
  return at == properties.end() ? nullptr : &*at;
}

PlyHeader read_ply_header(const InputFile& input) { return HeaderReader(input).read(); }

}  // namespace evenmesh
