// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/core.h>

#include "evenmesh/io/number_type.h"
#include "evenmesh/io/text_scanner.h"

namespace evenmesh {

/// Where the numbers of an array of a legacy VTK file are.
struct VtkNumbers {
  std::uint64_t offset;
  std::uint64_t count;
  NumberType type;
  bool is_binary;
};

/// @throws IoError  a word that is no number
std::vector<double> read_numbers(const InputFile& input, const VtkNumbers& numbers);

/// What the words for types mean where VTK runs on a 64-bit machine; none for those that are not
/// made of numbers.
std::optional<NumberType> vtk_number_type(std::string_view word);

/// The name "my array" that the file has as "my%20array".
std::string decoded_vtk_name(std::string_view name);

/// Goes through a legacy VTK file: keywords are words, and lists are words or bytes.
class VtkScanner : public TextScanner {
 public:
  /// Binary files are big-endian, whatever the machine.
  static constexpr bool kSwap = true;

  explicit VtkScanner(const InputFile& input) : TextScanner(input) {}

  bool is_binary() const { return is_binary_; }
  void set_binary(bool is_binary) { is_binary_ = is_binary; }

  // As those of a text; but lines mean nothing where numbers are bytes.
  [[noreturn]] void fail(const char* place, std::string_view message) const;
  [[noreturn]] void fail(std::string_view message) const { fail(place(), message); }
  void check_room(std::uint64_t count, std::size_t bytes_each, std::string_view things) const;

  /// Moves behind the end of this line.
  void pass_line();
  /// Passes over a word that has to be there.
  void expect(std::string_view key);
  /// The word for a type of number.
  NumberType take_type();
  /// So many bytes behind this line, passed over.
  std::string_view take_bytes(std::uint64_t count, std::size_t bytes_each, std::string_view things);

  /// Calls take with each of so many whole numbers behind this line, and where it is.
  template <typename Take>
  void take_whole_numbers(std::uint64_t count, NumberType type, std::string_view things,
                          const Take& take) {
    if (is_binary_) {
      const std::string_view bytes = take_bytes(count, size_of(type), things);
      for_each_number(bytes, type, kSwap, [&](auto value) {
        if constexpr (std::is_integral_v<decltype(value)>) take(value, bytes.data());
      });
      return;
    }
    check_room(count, 2, things);
    for (std::uint64_t i = 0; i < count; ++i) {
      next();
      const char* const at = place();
      take(integer(things), at);
    }
  }

  /// The number of a point.
  template <typename Number>
  Index index(Number value, const char* place) const {
    if (value < 0 || static_cast<std::uint64_t>(value) >= std::numeric_limits<Index>::max()) {
      fail(place, fmt::format("there is no point {}", value));
    }
    return static_cast<Index>(value);
  }

  /// Passes over numbers: so many words, or so many bytes behind this line.
  /// @return  where they begin
  std::uint64_t skip_numbers(std::uint64_t count, std::uint64_t bytes);
  /// Passes over strings, which a text has one to a line.
  void skip_strings(std::uint64_t count);

 private:
  std::string_view take_more_bytes(std::uint64_t count, std::size_t bytes_each,
                                   std::string_view things);

  bool is_binary_ = false;
};

}  // namespace evenmesh
