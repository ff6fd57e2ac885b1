// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace evenmesh {

inline bool is_eol(char c) { return c == '\n' || c == '\r'; }
inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Length of a line continuation at p, a backslash and the line end right after it; 0 if there is
/// none.
inline int continuation_length(const char* p, const char* end) {
  if (end - p < 2 || *p != '\\' || !is_eol(p[1])) return 0;
  return p[1] == '\r' && end - p > 2 && p[2] == '\n' ? 3 : 2;
}

/// Skips blanks and line continuations; stops at the end of the line at the latest.
inline const char* skip_blank(const char* p, const char* end) {
  while (p != end) {
    if (is_blank(*p)) {
      ++p;
    } else if (const int length = continuation_length(p, end)) {
      p += length;
    } else {
      break;
    }
  }
  return p;
}

/// True where a word ends: at a blank, a line end, a line continuation, or the end of the text.
inline bool ends_word(const char* p, const char* end) {
  return p == end || is_blank(*p) || is_eol(*p) || continuation_length(p, end) != 0;
}

/// Reads one decimal number that fills a whole word. A leading '+' is accepted; numbers too small
/// for a double become zero, as they do in C.
/// @param[out] value  finite; only set when a number was read
/// @return            where the number ends, or nullptr where there is no finite number
const char* scan_number(const char* p, const char* end, double& value);

/// The same for formats whose words may end at a comma or a tag and whose exponents may be written
/// with D.
const char* scan_value(const char* p, const char* end, double& value);

/// Reads a whole number, digits with a sign or none, that ends a word or at a comma.
/// @return  where it ends, or nullptr where there is none below 10^18
const char* scan_whole(const char* p, const char* end, std::int64_t& value);

/// What is wrong with the word at p, at which scan_number() returned nullptr, and what to try.
std::string explain_bad_number(const char* p, const char* end);

/// The word at p as a message may show it: shortened, and without bytes that could upset a screen.
std::string quoted_word(const char* p, const char* end);

/// The shortest digits that scan_number() reads back as the same double.
class NumberText {
 public:
  explicit NumberText(double value);
  explicit NumberText(float value);
  /// The best that has at most so many characters. Where even that needs more, as for 1e-300 in
  /// five, it is zero.
  /// @pre  at least 7 characters, finite
  static NumberText fitted(double value, std::size_t characters);
  std::string_view view() const { return {text_, length_}; }

 private:
  char text_[32];
  std::size_t length_;
};

}  // namespace evenmesh
