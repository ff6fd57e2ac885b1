// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/text_scan.h"

namespace evenmesh {

/// Goes through an Abaqus deck line by line. Comments and empty lines are none.
class DeckLines {
 public:
  explicit DeckLines(const InputFile& input);

  /// Moves to the next line.
  /// @return  false at the end of the deck
  bool next();
  bool is_keyword() const { return *first_ == '*'; }
  /// Where the line begins, behind blanks, and where it ends, before blanks.
  const char* first() const { return first_; }
  const char* last() const { return last_; }
  std::string_view text() const { return {first_, static_cast<std::size_t>(last_ - first_)}; }

 private:
  const char* p_;
  const char* end_;
  const char* newline_;  // the first at or behind p_; searched for once, for decks that have none
  const char* first_;
  const char* last_;
};

/// A keyword and its parameters: "*NSET, NSET=Bolts, GENERATE". Keyword and names of parameters in
/// capitals with one blank between words; values as they are, without blanks and quotes around.
struct DeckKeyword {
  std::string name;
  std::vector<std::pair<std::string, std::string>> parameters;
  const char* place = nullptr;

  /// @return  the value, empty also for a parameter without one; null if it is not there
  const std::string* find(std::string_view parameter) const;
  std::string value(std::string_view parameter) const;
};

/// Reads the keyword at the line at hand, and the lines that it continues on.
DeckKeyword read_keyword(DeckLines& lines);

/// In capitals, as Abaqus compares names.
std::string in_capitals(std::string_view text);

/// The fields of a data line, without blanks around them.
std::vector<std::string_view> fields_of(std::string_view line);

/// Reads comma-separated whole numbers of a data line.
class NumberLine {
 public:
  NumberLine(const char* first, const char* last) : p_(first), last_(last) { skip(); }

  bool at_end() const { return p_ == last_; }
  const char* place() const { return p_; }
  const char* end() const { return last_; }
  /// @return  false where there is no whole number, which may be a name
  bool take(std::int64_t& value) {
    const char* const stop = scan_whole(p_, last_, value);
    if (stop == nullptr) return false;
    p_ = stop;
    skip_comma();
    return true;
  }
  std::string_view take_word() {
    const char* const first = p_;
    while (p_ != last_ && *p_ != ',') ++p_;
    const char* stop = p_;
    while (stop != first && is_blank(stop[-1])) --stop;
    skip_comma();
    return {first, static_cast<std::size_t>(stop - first)};
  }
  /// Whether the last field is followed by a comma, which says that the next line goes on.
  bool goes_on() const { return comma_last_; }

 private:
  void skip() {
    while (p_ != last_ && is_blank(*p_)) ++p_;
  }
  void skip_comma() {
    skip();
    comma_last_ = p_ != last_ && *p_ == ',';
    if (comma_last_) ++p_;
    skip();
    comma_last_ = comma_last_ && p_ == last_;
  }

  const char* p_;
  const char* last_;
  bool comma_last_ = false;
};

}  // namespace evenmesh
