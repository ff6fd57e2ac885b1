// SPDX-License-Identifier: MIT
#include "tests/support/places.h"

#include <cstdlib>

namespace evenmesh::testing {

std::filesystem::path source_dir() { return EVENMESH_SOURCE_DIR; }

std::filesystem::path data_dir() { return source_dir() / "data"; }

std::filesystem::path corpus_dir() {
  const char* const elsewhere = std::getenv("EVENMESH_CORPUS_DIR");
  return elsewhere != nullptr ? elsewhere : source_dir() / ".." / "shared" / "corpus";
}

}  // namespace evenmesh::testing
