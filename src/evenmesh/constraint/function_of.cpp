// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/function_of.h"

#include <fmt/core.h>

#include "evenmesh/base/error.h"

namespace evenmesh::detail {

void check_vertices(std::string_view name, std::span<const Index> vertices) {
  if (vertices.empty()) {
    throw InvalidOption(fmt::format("the function '{}' depends on no vertex; name some", name));
  }
  std::vector<Index> sorted(vertices.begin(), vertices.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice == sorted.end()) return;
  throw InvalidOption(fmt::format(
      "the function '{}' names vertex {} (counted from 0) twice; name it once and use its position "
      "twice",
      name, *twice));
}

}  // namespace evenmesh::detail
