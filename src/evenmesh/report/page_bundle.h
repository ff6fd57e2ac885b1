// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace evenmesh {

/// The script and the style sheet of the HTML report, from web/dist, as the build embeds them.
struct PageBundle {
  std::string_view script;
  std::string_view style;
  std::string_view script_sha256;  // base64, for the page's policy
  std::string_view style_sha256;
};

const PageBundle& page_bundle();

}  // namespace evenmesh
