// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace evenmesh {

/// The letters of base64 (RFC 4648), four for three bytes.
inline constexpr std::string_view kBase64Letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// How many letters so many bytes take, padding included.
constexpr std::uint64_t base64_size(std::uint64_t bytes) { return (bytes + 2) / 3 * 4; }

/// Bytes in letters, padded with "=" to groups of four.
std::string to_base64(std::string_view bytes);

}  // namespace evenmesh
