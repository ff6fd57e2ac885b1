// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

#include "fuzz/patch_promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  evenmesh::fuzz::check_promise(evenmesh::Format::stl_ascii, bytes);
  evenmesh::fuzz::check_promise(evenmesh::Format::stl_binary, bytes);
  evenmesh::fuzz::check_promise(evenmesh::Format::stl_ascii, bytes, {.weld_tolerance = 0.5});
  return 0;
}
