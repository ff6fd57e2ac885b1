// SPDX-License-Identifier: MIT
#include "evenmesh/report/html_text.h"

#include <algorithm>

#include "evenmesh/plot/svg.h"

namespace evenmesh {

std::string html_escaped(std::string_view text) {
  std::string result;
  while (true) {
    const std::size_t end = text.find('\n');
    result += svg_escaped(text.substr(0, end));
    if (end == std::string_view::npos) return result;
    result += '\n';
    text.remove_prefix(end + 1);
  }
}

std::string script_json(std::string_view json) {
  std::string result;
  result.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace evenmesh
