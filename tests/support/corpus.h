// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>

namespace evenmesh::testing {

/// The folder with other people's meshes, which may not be there: where the environment says, or
/// where the build was told.
inline std::filesystem::path corpus() {
  const char* const elsewhere = std::getenv("EVENMESH_CORPUS_DIR");
  return elsewhere != nullptr ? elsewhere : EVENMESH_CORPUS_DIR;
}

}  // namespace evenmesh::testing
