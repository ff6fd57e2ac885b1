// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace evenmesh {

/// Text as it stands between tags or in a quoted attribute of HTML: & < > and quotes as entities,
/// bytes that are not UTF-8 and control characters as U+FFFD. Line ends stay.
std::string html_escaped(std::string_view text);

/// JSON as it stands in a script element: < as \u003c, so that nothing in it ends the element or
/// begins a comment. Means the same.
/// @pre  valid JSON: there is no < outside of strings
std::string script_json(std::string_view json);

}  // namespace evenmesh
