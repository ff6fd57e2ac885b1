// SPDX-License-Identifier: MIT
#include "evenmesh/io/text_scanner.h"

#include <fmt/core.h>

namespace evenmesh {

TextScanner::TextScanner(const InputFile& input, char comment)
    : input_(input),
      begin_(input.bytes().data()),
      p_(begin_ + (input.bytes().starts_with("\xEF\xBB\xBF") ? 3 : 0)),
      end_(begin_ + input.bytes().size()),
      comment_(comment) {}

bool TextScanner::has_word() {
  while (p_ != end_ && is_blank(*p_)) ++p_;
  return p_ != end_ && !is_eol(*p_) && !(comment_ != 0 && *p_ == comment_);
}

void TextScanner::skip_line() {
  while (p_ != end_ && !is_eol(*p_)) ++p_;
}

bool TextScanner::next() {
  while (!has_word()) {
    skip_line();
    if (p_ == end_) return false;
    ++p_;
  }
  return true;
}

std::string_view TextScanner::word() {
  const std::string_view found = peek();
  p_ += found.size();
  return found;
}

std::string_view TextScanner::peek() {
  if (!next()) return {};
  const char* stop = p_;
  while (stop != end_ && !is_blank(*stop) && !is_eol(*stop)) ++stop;
  return {p_, static_cast<std::size_t>(stop - p_)};
}

std::string_view TextScanner::rest_of_line() {
  if (!has_word()) return {};
  const char* const first = p_;
  skip_line();
  const char* last = p_;
  while (is_blank(last[-1])) --last;
  return {first, static_cast<std::size_t>(last - first)};
}

void TextScanner::need(std::string_view what) {
  if (next()) return;
  fail(fmt::format("{} ends where {} should be; it was cut off, copy or export it again", whole_,
                   what));
}

bool TextScanner::ends_strangely(const char* stop) const {
  return stop != end_ && (*stop == ',' || *stop == '<');
}

std::int64_t TextScanner::integer(std::string_view what) {
  need(what);
  std::int64_t value = 0;
  const char* const stop = scan_whole(p_, end_, value);
  if (stop == nullptr || ends_strangely(stop)) {
    fail(fmt::format("{} is not a whole number; {} is expected here", quoted_word(p_, end_), what));
  }
  p_ = stop;
  return value;
}

std::uint64_t TextScanner::count(std::string_view what) {
  need(what);
  const char* const place = p_;
  const std::int64_t value = integer(what);
  if (value < 0) fail(place, fmt::format("{} is {}, below zero", what, value));
  return static_cast<std::uint64_t>(value);
}

double TextScanner::real(std::string_view what) {
  need(what);
  double value = 0.0;
  const char* const stop = scan_value(p_, end_, value);
  if (stop == nullptr || ends_strangely(stop)) {
    fail(fmt::format("{}; {} is expected here", explain_bad_number(p_, end_), what));
  }
  p_ = stop;
  return value;
}

Vec3 TextScanner::position(int dimension, std::uint64_t vertex, std::uint64_t& offset) {
  Vec3 position = Vec3::Zero();
  for (int k = 0; k < dimension; ++k) {
    if (!next()) {
      fail(
          fmt::format("{} ends within the coordinates of vertex {}; it was cut off, copy or "
                      "export it again",
                      whole_, vertex));
    }
    if (k == 0) offset = this->offset();
    const char* const stop = scan_value(p_, end_, position[k]);
    if (stop == nullptr || ends_strangely(stop)) {
      fail(fmt::format("{} (a coordinate of vertex {})", explain_bad_number(p_, end_), vertex));
    }
    p_ = stop;
  }
  return position;
}

void TextScanner::check_room(std::uint64_t number, std::size_t bytes_each,
                             std::string_view things) const {
  const std::uint64_t fits = static_cast<std::uint64_t>(end_ - p_ + 1) / bytes_each;
  if (number <= fits) return;
  fail(fmt::format(
      "promises {} {} but the rest of {} has room for {} at most; it was cut off, or the "
      "number is wrong",
      number, things, whole_, fits));
}

std::string TextScanner::shown() {
  return next() ? quoted_word(p_, end_) : std::string("the end of the file");
}

}  // namespace evenmesh
