// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenmesh/io/input_file.h"

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

}  // namespace evenmesh
