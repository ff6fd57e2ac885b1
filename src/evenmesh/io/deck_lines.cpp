// SPDX-License-Identifier: MIT
#include "evenmesh/io/deck_lines.h"

#include <algorithm>
#include <cstring>

#include "evenmesh/io/text_scan.h"

namespace evenmesh {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || is_eol(text.back()))) text.remove_suffix(1);
  return text;
}

std::string_view without_quotes(std::string_view text) {
  const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
  return quoted ? text.substr(1, text.size() - 2) : text;
}

/// In capitals, with one blank between words.
std::string normalized(std::string_view text) {
  std::string result;
  for (const char c : trimmed(text)) {
    if (is_blank(c)) {
      if (result.back() != ' ') result += ' ';
    } else {
      result += c;
    }
  }
  return in_capitals(result);
}

void add_parameters(std::string_view line, std::vector<std::pair<std::string, std::string>>& to) {
  for (const std::string_view field : fields_of(line)) {
    if (field.empty()) continue;
    const std::size_t equals = field.find('=');
    const bool has_value = equals != std::string_view::npos;
    to.emplace_back(normalized(field.substr(0, equals)),
                    has_value ? without_quotes(trimmed(field.substr(equals + 1))) : "");
  }
}

}  // namespace

DeckLines::DeckLines(const InputFile& input)
    : p_(input.bytes().data() + (input.bytes().starts_with("\xEF\xBB\xBF") ? 3 : 0)),
      end_(input.bytes().data() + input.bytes().size()),
      newline_(nullptr),
      first_(p_),
      last_(p_) {}

bool DeckLines::next() {
  while (p_ != end_) {
    const char* const line = p_;
    const auto find = [](const char* from, const char* to, char c) {
      return static_cast<const char*>(std::memchr(from, c, static_cast<std::size_t>(to - from)));
    };
    if (newline_ < line) newline_ = find(line, end_, '\n');
    if (newline_ == nullptr) newline_ = end_;
    const char* stop = newline_;
    const char* const carriage = find(line, stop, '\r');
    if (carriage != nullptr) stop = carriage;
    p_ = stop == end_ ? end_ : stop + 1;
    first_ = line;
    last_ = stop;
    while (first_ != last_ && is_blank(*first_)) ++first_;
    while (last_ != first_ && is_blank(last_[-1])) --last_;
    if (first_ == last_ || (last_ - first_ > 1 && first_[0] == '*' && first_[1] == '*')) continue;
    return true;
  }
  first_ = last_ = end_;
  return false;
}

const std::string* DeckKeyword::find(std::string_view parameter) const {
  for (const auto& [key, value] : parameters) {
    if (key == parameter) return &value;
  }
  return nullptr;
}

std::string DeckKeyword::value(std::string_view parameter) const {
  const std::string* const found = find(parameter);
  return found == nullptr ? std::string() : *found;
}

DeckKeyword read_keyword(DeckLines& lines) {
  DeckKeyword result;
  result.place = lines.first();
  std::string_view text = lines.text().substr(1);
  const std::size_t comma = std::min(text.find(','), text.size());
  result.name = normalized(text.substr(0, comma));
  text.remove_prefix(comma);
  add_parameters(text, result.parameters);
  while (!text.empty() && text.back() == ',') {
    DeckLines ahead = lines;
    if (!ahead.next() || ahead.is_keyword()) break;
    lines = ahead;
    text = lines.text();
    add_parameters(text, result.parameters);
  }
  return result;
}

std::string in_capitals(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return result;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (line[i] != ',' || quoted)) continue;
    fields.push_back(trimmed(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  return fields;
}

}  // namespace evenmesh
