// SPDX-License-Identifier: MIT
#include "tests/plot/xml.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include <gtest/gtest.h>

namespace evenmesh::testing {
namespace {

// Strict UTF-8 by its table of ranges, and no character that XML 1.0 forbids.
bool is_clean(std::string_view s) {
  const auto in = [&](std::size_t i, int low, int high) {
    const int byte = i < s.size() ? static_cast<unsigned char>(s[i]) : -1;
    return byte >= low && byte <= high;
  };
  const auto rest = [&](std::size_t i) { return in(i, 0x80, 0xBF); };
  for (std::size_t i = 0; i < s.size();) {
    if (in(i, 0x20, 0x7E) || in(i, '\n', '\n')) {
      i += 1;
    } else if ((in(i, 0xC2, 0xC2) && in(i + 1, 0xA0, 0xBF)) || (in(i, 0xC3, 0xDF) && rest(i + 1))) {
      i += 2;
    } else if (((in(i, 0xE0, 0xE0) && in(i + 1, 0xA0, 0xBF)) ||
                (in(i, 0xED, 0xED) && in(i + 1, 0x80, 0x9F)) ||
                (!in(i, 0xE0, 0xE0) && !in(i, 0xED, 0xED) && in(i, 0xE1, 0xEF) && rest(i + 1))) &&
               rest(i + 2) && s.substr(i, 3) != "\xEF\xBF\xBE" &&
               s.substr(i, 3) != "\xEF\xBF\xBF") {
      i += 3;
    } else if (((in(i, 0xF0, 0xF0) && in(i + 1, 0x90, 0xBF)) ||
                (in(i, 0xF1, 0xF3) && rest(i + 1)) ||
                (in(i, 0xF4, 0xF4) && in(i + 1, 0x80, 0x8F))) &&
               rest(i + 2) && rest(i + 3)) {
      i += 4;
    } else {
      return false;
    }
  }
  return true;
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  void parse(std::vector<Element>& elements) {
    expect(is_clean(text_), "not UTF-8 or a control character");
    element(elements);
    skip_space();
    expect(at_ == text_.size(), "something after the root");
  }

 private:
  void expect(bool holds, const std::string& what) const {
    if (!holds) throw std::runtime_error(what + " at " + std::string(text_.substr(at_, 60)));
  }
  char peek() const {
    expect(at_ < text_.size(), "unexpected end");
    return text_[at_];
  }
  void take(std::string_view token) {
    expect(text_.substr(at_, token.size()) == token, "no " + std::string(token));
    at_ += token.size();
  }
  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  std::string name() {
    std::string result;
    while (std::isalnum(static_cast<unsigned char>(peek())) || peek() == '-' || peek() == ':') {
      result += text_[at_++];
    }
    expect(!result.empty(), "no name");
    return result;
  }

  // Up to one of the characters that end it.
  std::string characters(char end) {
    std::string result;
    while (peek() != end) {
      expect(peek() != '<', "a naked <");
      if (peek() != '&') {
        result += text_[at_++];
        continue;
      }
      const std::size_t semicolon = text_.find(';', at_);
      const std::string entity(text_.substr(at_, semicolon - at_ + 1));
      static const std::map<std::string, char> kEntities = {
          {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}};
      expect(kEntities.contains(entity), "an unknown entity");
      result += kEntities.at(entity);
      at_ = semicolon + 1;
    }
    return result;
  }

  std::string element(std::vector<Element>& elements) {
    take("<");
    const std::size_t place = elements.size();
    elements.push_back({name(), {}, {}});
    for (skip_space(); peek() != '>' && peek() != '/'; skip_space()) {
      const std::string key = name();
      take("=\"");
      expect(!elements[place].attributes.contains(key), "an attribute given twice");
      elements[place].attributes[key] = characters('"');
      take("\"");
      expect(std::isspace(static_cast<unsigned char>(peek())) || peek() == '>' || peek() == '/',
             "no space between attributes");
    }
    if (peek() == '/') {
      take("/>");
      return "";
    }
    take(">");
    std::string text;
    for (;;) {
      text += characters('<');
      if (text_.substr(at_, 2) == "</") break;
      text += element(elements);
    }
    take("</" + elements[place].name + ">");
    elements[place].text = text;
    return text;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Element> parse_xml(std::string_view text) {
  std::vector<Element> elements;
  try {
    Parser(text).parse(elements);
  } catch (const std::exception& error) {
    ADD_FAILURE() << "not well-formed: " << error.what();
  }
  return elements;
}

std::vector<Element> named(const std::vector<Element>& elements, std::string_view name) {
  std::vector<Element> result;
  std::copy_if(elements.begin(), elements.end(), std::back_inserter(result),
               [&](const Element& element) { return element.name == name; });
  return result;
}

std::vector<std::string> texts(std::string_view svg) {
  std::vector<std::string> result;
  for (const Element& element : named(parse_xml(svg), "text")) result.push_back(element.text);
  return result;
}

}  // namespace evenmesh::testing
