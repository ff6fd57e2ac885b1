// SPDX-License-Identifier: MIT
#include "evenmesh/io/text_scan.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include <fmt/core.h>

namespace evenmesh {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether a number beyond the range of double is too small for it rather than too large: whether
/// its first digit that is not zero stands behind the decimal point.
bool is_tiny(const char* p, const char* end) {
  constexpr long kFar = 1'000'000'000;  // no sane text has an exponent or as many digits
  long power = -1;                      // of the first digit that counts
  bool found = false;
  bool behind_point = false;
  for (; p != end && *p != 'e' && *p != 'E'; ++p) {
    if (*p == '.') behind_point = true;
    if (!is_digit(*p)) continue;
    if (!found && *p == '0' && behind_point) --power;
    if (!found && *p != '0') {
      found = true;
      if (!behind_point) power = 0;
    } else if (found && !behind_point) {
      ++power;
    }
  }
  if (p == end) return power < 0;
  ++p;
  const bool negative = p != end && *p == '-';
  long exponent = 0;
  for (; p != end; ++p) {
    if (is_digit(*p)) exponent = std::min(kFar, 10 * exponent + (*p - '0'));
  }
  return power + (negative ? -exponent : exponent) < 0;
}

const char* word_end(const char* p, const char* end) {
  while (!ends_word(p, end)) ++p;
  return p;
}

/// Where the digits or the minus of a number begin; nullptr where there are none behind a plus.
const char* behind_plus(const char* p, const char* end) {
  if (p == end || *p != '+') return p;
  return p + 1 == end || p[1] == '-' ? nullptr : p + 1;
}

/// What std::from_chars() found, with zero for what is too small for a double.
/// @return  false if it is no finite number
bool make_finite(const char* digits, const char* stop, std::errc error, double& number) {
  if (error == std::errc::result_out_of_range && is_tiny(digits, stop)) {
    number = *digits == '-' ? -0.0 : 0.0;
    return true;
  }
  return error == std::errc() && std::isfinite(number);
}

}  // namespace

const char* scan_number(const char* p, const char* end, double& value) {
  const char* const digits = behind_plus(p, end);
  if (digits == nullptr) return nullptr;
  double number = 0.0;
  const auto [stop, error] = std::from_chars(digits, end, number);
  if (!ends_word(stop, end) || !make_finite(digits, stop, error, number)) return nullptr;
  value = number;
  return stop;
}

const char* scan_value(const char* p, const char* end, double& value) {
  const char* const digits = behind_plus(p, end);
  if (digits == nullptr) return nullptr;
  double number = 0.0;
  const auto [stop, error] = std::from_chars(digits, end, number);
  const auto ends = [end](const char* place) {
    return ends_word(place, end) || *place == ',' || *place == '<';
  };
  if (ends(stop)) {
    if (!make_finite(digits, stop, error, number)) return nullptr;
    value = number;
    return stop;
  }
  // Once more with the exponent written as from_chars() wants it.
  constexpr std::size_t kLongest = 128;
  if (error != std::errc() || (*stop != 'd' && *stop != 'D')) return nullptr;
  std::string text(digits, stop);
  text += 'e';
  const char* q = stop + 1;
  if (q != end && *q == '+') ++q;
  while (!ends(q) && text.size() <= kLongest) text += *q++;
  return scan_number(text.data(), text.data() + text.size(), value) == nullptr ? nullptr : q;
}

const char* scan_whole(const char* p, const char* end, std::int64_t& value) {
  constexpr std::ptrdiff_t kMostDigits = 18;
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  const char* const first = p;
  std::int64_t number = 0;
  for (; p != end && is_digit(*p); ++p) {
    if (p - first == kMostDigits) return nullptr;
    number = 10 * number + (*p - '0');
  }
  if (p == first || !(ends_word(p, end) || *p == ',')) return nullptr;
  value = negative ? -number : number;
  return p;
}

std::string explain_bad_number(const char* p, const char* end) {
  const char* const stop = word_end(p, end);
  const std::string_view word(p, static_cast<std::size_t>(stop - p));
  const std::string shown = quoted_word(p, end);
  if (word.empty()) return "a number is missing";

  const bool sign = word[0] == '+' || word[0] == '-';
  double value = 0.0;
  const auto [rest, error] = std::from_chars(p + (sign ? 1 : 0), stop, value);
  if (rest == stop && error == std::errc::result_out_of_range) {
    return fmt::format("{} is too large for a double; scale the mesh down", shown);
  }
  if (rest == stop && error == std::errc() && !std::isfinite(value)) {
    return fmt::format("{} is not a finite number; repair the file or write it again", shown);
  }
  if (rest != stop && *rest == ',') {
    return fmt::format("{} has a decimal comma; write numbers with a point, as in 0.25", shown);
  }
  if (rest != stop && (*rest == 'd' || *rest == 'D') && rest != p) {
    return fmt::format("{} has an exponent written with {}; write it with E", shown, *rest);
  }
  return fmt::format("{} is not a number", shown);
}

std::string quoted_word(const char* p, const char* end) {
  constexpr std::size_t kLongest = 40;
  const char* const stop = word_end(p, end);
  std::string shown = "'";
  for (; p != stop && shown.size() <= kLongest; ++p) shown += *p > ' ' && *p <= '~' ? *p : '?';
  if (p != stop) shown += "...";
  return shown + "'";
}

NumberText::NumberText(double value)
    : length_(static_cast<std::size_t>(std::to_chars(text_, text_ + sizeof(text_), value).ptr -
                                       text_)) {}

NumberText::NumberText(float value)
    : length_(static_cast<std::size_t>(std::to_chars(text_, text_ + sizeof(text_), value).ptr -
                                       text_)) {}

NumberText NumberText::fitted(double value, std::size_t characters) {
  NumberText best(value);
  for (int precision = std::numeric_limits<double>::max_digits10 - 1;
       best.length_ > characters && precision > 0; --precision) {
    const char* const stop = std::to_chars(best.text_, best.text_ + sizeof(best.text_), value,
                                           std::chars_format::general, precision)
                                 .ptr;
    best.length_ = static_cast<std::size_t>(stop - best.text_);
  }
  return best.length_ > characters ? NumberText(0.0) : best;
}

}  // namespace evenmesh
