// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace evenmesh::testing {

/// Expects that the output keeps what a run with default options promises, judged from the two
/// files alone: connectivity and every byte that is no coordinate, the bits of fixed vertices, no
/// inverted cell more, no worst value worse, mean shape no lower.
void expect_promise(const std::filesystem::path& before, const std::filesystem::path& after);

}  // namespace evenmesh::testing
