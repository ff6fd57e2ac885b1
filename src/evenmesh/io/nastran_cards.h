// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace evenmesh {

/// A field of a card, and where another text can be put in its place.
struct NastranField {
  enum class Form : std::uint8_t {
    columns,  // 8 or 16 of them, or what the line has of these, also by way of tabs
    word,     // between commas
    none      // on a continuation line that is not there
  };
  std::string_view text = {};  // without blanks around it
  Form form = Form::none;
  const char* first = nullptr;  // its columns, or the word
  const char* last = nullptr;
  std::size_t width = 0;    // characters that may be written there
  std::size_t missing = 0;  // columns or commas by which the line is too short
};

/// A card of Nastran's bulk data with its continuation lines.
struct NastranCard {
  const char* place = nullptr;
  std::string name = {};  // in capitals, without the star
  /// Behind the name, number 1 first, as the manual counts them without continuation fields: each
  /// line has 8, or 4 of 16 characters. [0] is nothing.
  std::vector<NastranField> fields = {};

  /// An empty text behind the last.
  std::string_view text(std::size_t field) const {
    return field < fields.size() ? fields[field].text : std::string_view();
  }
};

/// Goes through the cards of bulk data: fields of 8 or 16 columns, between commas or tabs. Comments
/// begin with $.
class NastranCards {
 public:
  NastranCards(const char* first, const char* last) : p_(first), end_(last) {}
  /// @return  false at the end
  bool next(NastranCard& card);

 private:
  struct Line {
    const char* first = nullptr;
    const char* last = nullptr;  // of what is no comment
    const char* next = nullptr;
  };
  bool peek(Line& line);

  const char* p_;
  const char* end_;
  Line line_ = {};  // that at p_, once it was found
};

/// Where the bulk data of a file begin: behind BEGIN BULK, or at the start where there is none.
const char* nastran_bulk(std::string_view text);

/// Whether a text looks like Nastran's: it has BEGIN BULK on a line, or its first card is one.
bool looks_like_nastran(std::string_view text);

/// A real number as Nastran has them: "1.5", ".5", "1.43-13", "1.D5", "2".
/// @return  false if it is none, or not finite
bool scan_nastran_real(std::string_view text, double& value);

/// A real number in at most so many characters, with a point and as exact as these allow.
/// @pre  at least 7 characters, finite
std::string nastran_real(double value, std::size_t characters);

}  // namespace evenmesh
