// SPDX-License-Identifier: MIT
#include "evenmesh/io/vtk_scanner.h"

#include <array>
#include <charconv>
#include <utility>

#include "evenmesh/base/text.h"
#include "evenmesh/io/byte_scanner.h"

namespace evenmesh {

std::optional<NumberType> vtk_number_type(std::string_view word) {
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

std::vector<double> read_numbers(const InputFile& input, const VtkNumbers& numbers) {
  std::vector<double> values;
  values.reserve(numbers.count);
  if (numbers.is_binary) {
    const std::string_view bytes =
        input.bytes().substr(numbers.offset, numbers.count * size_of(numbers.type));
    for_each_number(bytes, numbers.type, VtkScanner::kSwap,
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

void VtkScanner::fail(const char* place, std::string_view message) const {
  if (is_binary_) ByteScanner(input()).fail(offset(place), message);
  input().fail_at(place, message);
}

void VtkScanner::check_room(std::uint64_t count, std::size_t bytes_each,
                            std::string_view things) const {
  if (is_binary_) {
    ByteScanner(input(), offset()).check_room(count, bytes_each, things);
  } else {
    TextScanner::check_room(count, bytes_each, things);
  }
}

void VtkScanner::pass_line() {
  skip_line();
  const char* p = place();
  if (p != end() && *p == '\r') ++p;
  if (p != end() && *p == '\n') ++p;
  set_place(p);
}

void VtkScanner::expect(std::string_view key) {
  next();
  const char* const at = place();
  if (equal_but_for_case(word(), key)) return;
  fail(at, fmt::format("{} where {} is expected", quoted_word(at, end()), key));
}

NumberType VtkScanner::take_type() {
  const char* const at = place();
  const auto type = vtk_number_type(word());
  if (!type) fail(at, fmt::format("{} is no type of number here", quoted_word(at, end())));
  return *type;
}

std::string decoded_vtk_name(std::string_view name) {
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

std::string_view VtkScanner::take_bytes(std::uint64_t count, std::size_t bytes_each,
                                        std::string_view things) {
  pass_line();
  return take_more_bytes(count, bytes_each, things);
}

std::string_view VtkScanner::take_more_bytes(std::uint64_t count, std::size_t bytes_each,
                                             std::string_view things) {
  check_room(count, bytes_each, things);
  const std::string_view bytes(place(), count * bytes_each);
  set_place(place() + bytes.size());
  return bytes;
}

std::uint64_t VtkScanner::skip_numbers(std::uint64_t count, std::uint64_t bytes) {
  if (is_binary_) {
    take_bytes(bytes, 1, "bytes");
    return 0;
  }
  check_room(count, 2, "numbers");
  next();
  const std::uint64_t begin = offset();
  for (std::uint64_t i = 0; i < count; ++i) {
    if (word().empty()) {
      fail(fmt::format("the file ends after {} of {} numbers of an array; it was cut off", i,
                       count));
    }
  }
  return begin;
}

// In bytes a string follows its length, whose first two bits say how many bytes the length has.
void VtkScanner::skip_strings(std::uint64_t count) {
  pass_line();
  for (std::uint64_t i = 0; i < count; ++i) {
    if (place() == end()) {
      fail(fmt::format("the file ends after {} of {} strings; it was cut off", i, count));
    }
    if (!is_binary_) {
      pass_line();
      continue;
    }
    constexpr std::array<std::size_t, 4> kLengthBytes = {8, 4, 2, 1};
    const auto first = static_cast<unsigned char>(*place());
    std::uint64_t length = first & 0x3fU;
    const std::string_view bytes = take_more_bytes(kLengthBytes[first >> 6U], 1, "bytes");
    for (const char c : bytes.substr(1)) length = length << 8U | static_cast<unsigned char>(c);
    take_more_bytes(length, 1, "bytes");
  }
}

}  // namespace evenmesh
