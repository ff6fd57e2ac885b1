// SPDX-License-Identifier: MIT
#include "evenmesh/io/nastran_cards.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "evenmesh/base/text.h"
#include "evenmesh/io/text_scan.h"

namespace evenmesh {
namespace {

constexpr std::size_t kColumn = 8;
constexpr std::size_t kWide = 16;
constexpr std::size_t kPerLine = 8;
constexpr std::size_t kWidePerLine = 4;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_continuation(const char* first, const char* last) {
  if (*first == '+' || *first == '*' || *first == ',') return true;
  const char* const stop = first + std::min<std::ptrdiff_t>(kColumn, last - first);
  for (const char* p = first; p != stop; ++p) {
    if (*p == '\t') return p == first;
    if (*p != ' ') return false;
  }
  return true;
}

NastranField word_between(const char* first, const char* last) {
  while (first != last && is_blank(*first)) ++first;
  while (first != last && is_blank(last[-1])) --last;
  return {.text = {first, static_cast<std::size_t>(last - first)},
          .form = NastranField::Form::word,
          .first = first,
          .last = last};
}

void add_free(const char* first, const char* last, std::size_t most, std::size_t width,
              std::vector<NastranField>& fields) {
  while (is_blank(last[-1])) --last;
  const char* p = std::find(first, last, ',');
  std::size_t missing = 0;
  for (std::size_t i = 0; i < most; ++i) {
    const char* const begin = p == last ? last : p + 1;
    if (p == last) ++missing;
    p = std::find(begin, last, ',');
    NastranField field = word_between(begin, p);
    field.form = NastranField::Form::word;
    field.width = width;
    field.missing = missing;
    fields.push_back(field);
  }
}

/// The stretch between tabs in which a field has its text, or could.
NastranField tabbed_field(const char* first, const char* last, std::size_t width) {
  const char* const word = std::find_if_not(first, last, is_blank);
  const char* begin = first;
  if (word != last) {
    begin = word;
    while (begin != first && begin[-1] != '\t') --begin;
  }
  const char* const stop = std::find(begin, last, '\t');
  NastranField field = word_between(begin, last);
  field.first = begin;
  field.last = stop;
  field.width = width;
  if (stop != last) {
    // The tab goes to the next column that 8 divides, and shall go on doing so.
    const auto length = static_cast<std::size_t>(stop - begin);
    field.width = length / kColumn * kColumn + kColumn - 1;
  } else if (begin != first) {
    // Each tab before took 8 columns, but for what stands there.
    field.width = width - kColumn;
  }
  return field;
}

void add_columns(const char* first, const char* last, std::size_t most, std::size_t width,
                 std::vector<NastranField>& fields) {
  const bool has_tabs = std::find(first, last, '\t') != last;
  std::size_t column = 0;
  const char* p = first;
  const auto go_to = [&](std::size_t wanted) {
    if (!has_tabs) {
      const std::size_t step = std::min(wanted - column, static_cast<std::size_t>(last - p));
      column += step;
      p += step;
    }
    for (; p != last && column < wanted; ++p) {
      column = *p == '\t' ? (column / kColumn + 1) * kColumn : column + 1;
    }
  };
  for (std::size_t i = 0; i < most; ++i) {
    const std::size_t begin = kColumn + width * i;
    go_to(begin);
    const char* const from = p;
    const std::size_t missing = begin - std::min(begin, column);
    go_to(begin + width);
    NastranField field = tabbed_field(from, p, width);
    field.form = NastranField::Form::columns;
    field.missing = missing;
    fields.push_back(field);
  }
}

std::string point_behind_digits(std::string text) {
  if (text.find('.') == std::string::npos) return text + '.';
  while (text.back() == '0') text.pop_back();
  return text;
}

/// "-.25" rather than "-0.25".
std::string without_leading_zero(std::string text) {
  const std::size_t at = text[0] == '-' ? 1 : 0;
  if (text.size() > at + 2 && text[at] == '0' && text[at + 1] == '.') text.erase(at, 1);
  return text;
}

std::string fixed_text(double value, int decimals) {
  std::array<char, 400> text{};
  const char* const stop = std::to_chars(text.data(), text.data() + text.size(), value,
                                         std::chars_format::fixed, std::max(0, decimals))
                               .ptr;
  const auto length = static_cast<std::size_t>(stop - text.data());
  return without_leading_zero(point_behind_digits(std::string(text.data(), length)));
}

/// "1.5-7": Nastran needs no letter.
std::string scientific_text(double value, int decimals) {
  std::array<char, 64> text{};
  const char* const stop = std::to_chars(text.data(), text.data() + text.size(), value,
                                         std::chars_format::scientific, std::max(0, decimals))
                               .ptr;
  const std::string_view whole(text.data(), static_cast<std::size_t>(stop - text.data()));
  const std::size_t letter = whole.find('e');
  std::string exponent(whole.substr(letter + 1));
  while (exponent.size() > 2 && exponent[1] == '0') exponent.erase(1, 1);
  return point_behind_digits(std::string(whole.substr(0, letter))) + exponent;
}

/// The text with the most decimals that has so many characters; empty where none has.
template <typename Text>
std::string longest_fit(double value, std::size_t characters, const Text& text) {
  const int most = std::min<int>(static_cast<int>(characters), 17);
  for (int decimals = most; decimals >= 0; --decimals) {
    std::string made = text(value, decimals);
    if (made.size() <= characters) return made;
  }
  return {};
}

bool is_known_card(std::string_view name) {
  constexpr std::array<std::string_view, 34> kCards{
      "GRID",   "GRDSET", "SOL",    "CEND",   "NASTRAN", "ASSIGN", "ID",     "PARAM", "CORD2R",
      "CORD2C", "CORD2S", "MAT1",   "PSHELL", "PSOLID",  "PCOMP",  "PROD",   "PBAR",  "CTRIA3",
      "CTRIA6", "CQUAD4", "CQUAD8", "CTETRA", "CHEXA",   "CPENTA", "CPYRAM", "CBAR",  "CROD",
      "RBE2",   "RBE3",   "SPC1",   "SPC",    "FORCE",   "PLOAD4", "INIT"};
  return std::any_of(kCards.begin(), kCards.end(),
                     [name](std::string_view known) { return equal_but_for_case(known, name); });
}

std::string_view first_word(const char* first, const char* last) {
  while (first != last && is_blank(*first)) ++first;
  const char* stop = first;
  while (stop != last && !is_blank(*stop) && *stop != ',' && *stop != '*') ++stop;
  return {first, static_cast<std::size_t>(stop - first)};
}

bool is_begin_bulk(const char* first, const char* last) {
  const std::string_view word = first_word(first, last);
  if (!equal_but_for_case(word, "BEGIN")) return false;
  const std::string_view next = first_word(word.data() + word.size(), last);
  return equal_but_for_case(next.substr(0, 4), "BULK") ||
         equal_but_for_case(next.substr(0, 5), "SUPER");
}

const char* end_of_line(const char* p, const char* end) {
  while (p != end && !is_eol(*p)) ++p;
  return p;
}

const char* next_line(const char* p, const char* end) {
  if (p != end && *p == '\r') ++p;
  if (p != end && *p == '\n') ++p;
  return p;
}

}  // namespace

/// The next line with something on it, without its comment.
bool NastranCards::peek(Line& line) {
  while (line_.first != p_ || p_ == nullptr) {
    if (p_ == end_) return false;
    const char* const stop = end_of_line(p_, end_);
    line_ = {p_, std::find(p_, stop, '$'), next_line(stop, end_)};
    if (std::all_of(line_.first, line_.last, is_blank)) p_ = line_.next;
  }
  line = line_;
  return true;
}

bool NastranCards::next(NastranCard& card) {
  Line line{};
  card.fields.assign(1, {});
  bool begun = false;
  while (peek(line)) {
    const bool continues = is_continuation(line.first, line.last);
    if (begun && !continues) return true;
    p_ = line.next;
    if (!begun && continues) continue;  // of nothing
    const std::string_view word = first_word(line.first, line.last);
    const bool starred = *line.first == '*' || (word.data() + word.size() != line.last &&
                                                word.data()[word.size()] == '*');
    if (!begun) {
      begun = true;
      card.place = line.first;
      card.name = word;
      std::transform(card.name.begin(), card.name.end(), card.name.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
      });
    }
    const std::size_t most = starred ? kWidePerLine : kPerLine;
    const std::size_t width = starred ? kWide : kColumn;
    // Lines between commas may have fewer fields than they have room for.
    const std::size_t filled = (card.fields.size() - 1 + most - 1) / most * most + 1;
    card.fields.resize(filled, NastranField{.form = NastranField::Form::none});
    if (std::find(line.first, line.last, ',') != line.last) {
      add_free(line.first, line.last, most, width, card.fields);
    } else {
      add_columns(line.first, line.last, most, width, card.fields);
    }
  }
  return begun;
}

const char* nastran_bulk(std::string_view text) {
  const char* const end = text.data() + text.size();
  const char* p = text.data();
  while (p != end) {
    const char* const stop = end_of_line(p, end);
    if (is_begin_bulk(p, stop)) return next_line(stop, end);
    // Bulk data without that line begin with their first card.
    p = next_line(stop, end);
  }
  return text.data() + (text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
}

bool looks_like_nastran(std::string_view text) {
  const char* const end = text.data() + text.size();
  bool is_first = true;
  for (const char* p = text.data(); p != end;) {
    const char* const stop = end_of_line(p, end);
    const std::string_view word = first_word(p, std::find(p, stop, '$'));
    if (is_begin_bulk(p, stop)) return true;
    if (!word.empty() && is_first) {
      is_first = false;
      if (is_known_card(word)) return true;
    }
    p = next_line(stop, end);
  }
  return false;
}

bool scan_nastran_real(std::string_view text, double& value) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_sign = c == '+' || c == '-';
    if (is_sign && i > 0 && (is_digit(text[i - 1]) || text[i - 1] == '.')) plain += 'e';
    if (c == 'd' || c == 'D') {
      plain += 'e';
    } else {
      plain += c;
    }
  }
  return !plain.empty() && scan_number(plain.data(), plain.data() + plain.size(), value) ==
                               plain.data() + plain.size();
}

std::string nastran_real(double value, std::size_t characters) {
  const double size = std::abs(value);
  if (size == 0.0) return "0.";
  std::string best;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](std::string text) {
    double read = 0.0;
    if (text.empty() || !scan_nastran_real(text, read)) return;
    const double error = std::abs(read - value);
    if (error < least || (error == least && text.size() < best.size())) {
      best = std::move(text);
      least = error;
    }
  };
  constexpr double kLargest = 1e17;
  constexpr double kSmallest = 1e-17;
  if (size < kLargest && size > kSmallest) {
    consider(longest_fit(value, characters, fixed_text));
  }
  // From a thousandth on, fixed digits are as exact, if they fit.
  constexpr double kSmall = 1e-3;
  if (best.empty() || (least > 0.0 && size < kSmall)) {
    consider(longest_fit(value, characters, scientific_text));
  }
  return best.empty() ? "0." : best;
}

}  // namespace evenmesh
