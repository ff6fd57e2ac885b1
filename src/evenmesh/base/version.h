// SPDX-License-Identifier: MIT
#pragma once

namespace evenmesh {

/// The library's version; a test compares it with the build's.
inline constexpr const char* kVersion = "0.1.0";

}  // namespace evenmesh
