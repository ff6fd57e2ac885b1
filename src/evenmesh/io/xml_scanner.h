// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evenmesh/io/input_file.h"

namespace evenmesh {

/// A tag of an XML file as it stands there.
struct XmlTag {
  const char* first = nullptr;  // its '<'
  const char* last = nullptr;   // behind its '>'
  std::string_view name;
  bool closes = false;  // </name>
  bool empty = false;   // <name/>
  std::string_view attributes;

  /// The text between the quotes of an attribute, entities and all.
  std::optional<std::string_view> find(std::string_view attribute) const;
  /// The same, or what it is where it is not there.
  std::string_view get(std::string_view attribute, std::string_view otherwise = {}) const;
};

/// Goes through the tags of an XML file. Comments, declarations and CDATA are passed over; whether
/// tags are nested well is not looked at.
class XmlScanner {
 public:
  explicit XmlScanner(std::string_view text) : p_(text.data()), end_(text.data() + text.size()) {}

  /// @return  false where there are no more, or where the text ends within one
  bool next(XmlTag& tag);

 private:
  std::string_view rest() const { return {p_, static_cast<std::size_t>(end_ - p_)}; }
  bool skip_behind(std::string_view mark);

  const char* p_;
  const char* end_;
};

/// With the characters that entities such as &amp; stand for; others are left as they are.
std::string without_entities(std::string_view text);

}  // namespace evenmesh
