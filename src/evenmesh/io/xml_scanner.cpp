// SPDX-License-Identifier: MIT
#include "evenmesh/io/xml_scanner.h"

#include <array>
#include <utility>

#include "evenmesh/base/text.h"

namespace evenmesh {
namespace {

bool ends_name(char c) { return is_space(c) || c == '=' || c == '/' || c == '>'; }

/// The next attribute of a tag, taken off the text.
bool take_attribute(std::string_view& text, std::string_view& name, std::string_view& value) {
  text = trimmed(text);
  std::size_t end = 0;
  while (end < text.size() && !ends_name(text[end])) ++end;
  name = text.substr(0, end);
  text = trimmed(text.substr(end));
  if (name.empty() || !text.starts_with('=')) return false;
  text = trimmed(text.substr(1));
  if (!text.starts_with('"') && !text.starts_with('\'')) return false;
  const std::size_t close = text.find(text[0], 1);
  if (close == std::string_view::npos) return false;
  value = text.substr(1, close - 1);
  text.remove_prefix(close + 1);
  return true;
}

}  // namespace

std::optional<std::string_view> XmlTag::find(std::string_view attribute) const {
  std::string_view text = attributes;
  std::string_view found, value;
  while (take_attribute(text, found, value)) {
    if (found == attribute) return value;
  }
  return std::nullopt;
}

std::string_view XmlTag::get(std::string_view attribute, std::string_view otherwise) const {
  return find(attribute).value_or(otherwise);
}

bool XmlScanner::skip_behind(std::string_view mark) {
  const std::size_t at = rest().find(mark);
  if (at == std::string_view::npos) return false;
  p_ += at + mark.size();
  return true;
}

bool XmlScanner::next(XmlTag& tag) {
  for (;;) {
    const std::size_t at = rest().find('<');
    if (at == std::string_view::npos) return false;
    p_ += at;
    if (rest().starts_with("<!--")) {
      if (!skip_behind("-->")) return false;
    } else if (rest().starts_with("<![CDATA[")) {
      if (!skip_behind("]]>")) return false;
    } else if (rest().starts_with("<?") || rest().starts_with("<!")) {
      if (!skip_behind(">")) return false;
    } else {
      break;
    }
  }
  tag = {};
  tag.first = p_++;
  tag.closes = p_ != end_ && *p_ == '/';
  if (tag.closes) ++p_;
  const char* const name = p_;
  while (p_ != end_ && !ends_name(*p_)) ++p_;
  tag.name = {name, static_cast<std::size_t>(p_ - name)};
  const char* const attributes = p_;
  char quote = 0;  // in which one we are
  for (; p_ != end_ && (quote != 0 || *p_ != '>'); ++p_) {
    if (quote != 0) {
      if (*p_ == quote) quote = 0;
    } else if (*p_ == '"' || *p_ == '\'') {
      quote = *p_;
    }
  }
  if (p_ == end_) return false;
  tag.empty = p_[-1] == '/';
  tag.attributes = {attributes, static_cast<std::size_t>(p_ - attributes)};
  tag.last = ++p_;
  return true;
}

std::string without_entities(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string result;
  while (!text.empty()) {
    std::size_t length = 1;
    char c = text[0];
    for (const auto& [entity, meaning] : kEntities) {
      if (!text.starts_with(entity)) continue;
      c = meaning;
      length = entity.size();
    }
    result += c;
    text.remove_prefix(length);
  }
  return result;
}

}  // namespace evenmesh
