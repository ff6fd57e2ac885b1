// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

#include "fuzz/patch_promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  evenmesh::fuzz::check_promise(evenmesh::Format::exodus, {reinterpret_cast<const char*>(data), size});
  return 0;
}
