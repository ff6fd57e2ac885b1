// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "evenmesh/base/vec3.h"
#include "evenmesh/io/input_file.h"
#include "evenmesh/io/text_scan.h"

namespace evenmesh {

/// Goes through a text word by word. What makes the rest of a line a comment is up to the format.
///
/// Functions that read throw IoError with the line where the file has not what is asked for;
/// `what` says what that is, as in "the number of cells".
class TextScanner {
 public:
  /// @param comment  the character that begins a comment; 0: there are none
  explicit TextScanner(const InputFile& input, char comment = 0);

  /// Moves to the next word, of this line or a later one.
  /// @return  false at the end of the text
  bool next();
  /// Moves to the next word of this line, or to what ends the line.
  bool has_word();
  /// Moves to the end of the line.
  void skip_line();

  /// The next word, of this line or a later one, passed over; empty at the end of the text.
  std::string_view word();
  /// The same without passing over it.
  std::string_view peek();
  /// What is left of this line without blanks around it, passed over.
  std::string_view rest_of_line();

  // The next word as a number, of this line or a later one.
  std::int64_t integer(std::string_view what);
  std::uint64_t count(std::string_view what);  // not negative
  double real(std::string_view what);
  /// @param dimension      2 or 3 numbers; the third coordinate is 0 where it is missing
  /// @param[out] offset    where the first of them begins
  Vec3 position(int dimension, std::uint64_t vertex, std::uint64_t& offset);

  /// Fails where the rest of the file is too short for so many things of at least so many bytes.
  void check_room(std::uint64_t number, std::size_t bytes_each, std::string_view things) const;

  /// @throws IoError  always
  [[noreturn]] void fail(std::string_view message) const { fail(p_, message); }
  [[noreturn]] void fail(const char* place, std::string_view message) const {
    input_.fail_at(place, message);
  }
  /// The next word in quotes for a message; "the end of the file" where there is none.
  std::string shown();

  std::uint64_t offset() const { return offset(p_); }
  std::uint64_t offset(const char* place) const {
    return static_cast<std::uint64_t>(place - begin_);
  }
  const char* place() const { return p_; }
  const char* end() const { return end_; }
  void set_place(const char* p) { p_ = p; }
  const InputFile& input() const { return input_; }

  /// Goes through a part of the file alone.
  /// @param whole  what messages call the part: "the array"
  void set_part(const char* first, const char* last, std::string_view whole) {
    p_ = first;
    end_ = last;
    whole_ = whole;
  }

 private:
  void need(std::string_view what);
  bool ends_strangely(const char* stop) const;

  const InputFile& input_;
  const char* begin_;
  const char* p_;
  const char* end_;
  char comment_;
  std::string_view whole_ = "the file";
};

}  // namespace evenmesh
