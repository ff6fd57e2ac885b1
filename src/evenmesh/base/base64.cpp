// SPDX-License-Identifier: MIT
#include "evenmesh/base/base64.h"

#include <algorithm>
#include <cstddef>

namespace evenmesh {

std::string to_base64(std::string_view bytes) {
  std::string text;
  text.reserve(base64_size(bytes.size()));
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t taken = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8U | (k < taken ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= taken ? kBase64Letters[bits >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace evenmesh
