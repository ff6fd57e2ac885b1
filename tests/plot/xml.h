// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace evenmesh::testing {

/// An element of a picture.
struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  // of itself and of what is in it, entities resolved

  std::string operator[](const std::string& attribute) const {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? "" : found->second;
  }
  double number(const std::string& attribute) const { return std::stod((*this)[attribute]); }
};

/// The elements of a document in their order, if it is well-formed XML in UTF-8 (as far as the
/// pictures go: no comments, no declarations). Fails the test and returns what came before if not.
std::vector<Element> parse_xml(std::string_view text);

/// Those with that name.
std::vector<Element> named(const std::vector<Element>& elements, std::string_view name);

/// The texts of all text elements.
std::vector<std::string> texts(std::string_view svg);

}  // namespace evenmesh::testing
