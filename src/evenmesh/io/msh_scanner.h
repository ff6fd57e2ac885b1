// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "evenmesh/base/vec3.h"
#include "evenmesh/io/input_file.h"

namespace evenmesh {

/// The double at p as a binary file has it; swap: in the byte order that is not this machine's.
double double_at(const char* p, bool swap);

/// Goes through a Gmsh file section by section and number by number, whether the numbers are words
/// or bytes. The names of sections are text in both.
///
/// A text is read in records of one line each: start_record(), its numbers, end_record(). In a
/// binary file these two do nothing. Every function throws IoError where the file has not what is
/// asked for; `what` says what that is, as in "the number of nodes".
class MshScanner {
 public:
  explicit MshScanner(const InputFile& input);

  /// From here on numbers are bytes. swap: in the byte order that is not this machine's.
  void set_binary(bool swap);
  bool is_binary() const { return binary_; }
  bool swaps() const { return swap_; }

  /// Moves behind the line that opens the next section.
  /// @return  its name without the $; empty at the end of the file
  std::string_view next_section();
  /// Moves behind the line that ends the section, which must come now.
  void end_section(std::string_view name);
  /// Moves to the line that ends the section, wherever that is.
  void skip_section(std::string_view name);

  void start_record();
  void end_record();
  /// The same for a line that is text in binary files too.
  void start_line();
  void end_line();

  /// Where the next number begins.
  const char* item();
  std::int64_t integer(std::string_view what);  // 4 bytes
  std::uint64_t count(std::string_view what);   // 8 bytes
  double real(std::string_view what);           // 8 bytes, finite
  /// The number of an element, which some programs count from 0. wide: 8 bytes, else 4.
  std::uint64_t element_tag(bool wide);
  /// The number of a node, above 0.
  std::uint64_t node_tag(bool wide);
  /// Passes over a number of 8 bytes that may be anything.
  void skip_real(std::string_view what);
  /// A whole number that is text in binary files too.
  std::int64_t text_integer(std::string_view what);
  /// The coordinates of a node.
  /// @param[out] offset  where the first begins in the file
  Vec3 position(std::uint64_t node, std::uint64_t& offset);
  /// What is left of the line without blanks around it.
  std::string_view rest_of_line();

  /// Fails where the rest of the file is too short for so many things of at least so many bytes.
  void check_room(std::uint64_t number, std::size_t bytes_each, std::string_view things) const;

  [[noreturn]] void fail(const char* place, std::string_view message) const;
  [[noreturn]] void fail(std::uint64_t offset, std::string_view message) const {
    fail(begin_ + offset, message);
  }
  std::uint64_t offset(const char* place) const {
    return static_cast<std::uint64_t>(place - begin_);
  }
  const char* place() const { return p_; }
  const InputFile& input() const { return input_; }

 private:
  template <typename T>
  T bytes(std::string_view what);
  template <typename T>
  T word(std::string_view what);
  std::uint64_t tag(bool wide, std::uint64_t least, std::string_view what);
  [[noreturn]] void fail_missing(std::string_view what) const;
  std::size_t rest() const { return static_cast<std::size_t>(end_ - p_); }

  const InputFile& input_;
  const char* begin_;
  const char* end_;
  const char* p_;
  bool binary_ = false;
  bool swap_ = false;
};

}  // namespace evenmesh
