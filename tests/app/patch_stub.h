// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "evenmesh/io/mesh_file.h"

namespace evenmesh::testing {

/// The names of a mesh that came from no file.
class PatchStub final : public FilePatch {
 public:
  std::string_view format() const override { return "none"; }
  std::vector<Vec3> representable(Points points) const override {
    return {points.begin(), points.end()};
  }
  void write(Points, const std::function<void(std::string_view)>&) const override {}
  std::string cell_name(std::size_t cell) const override { return "face " + std::to_string(cell); }
  std::string vertex_name(Index vertex) const override {
    return "vertex " + std::to_string(vertex);
  }
};

}  // namespace evenmesh::testing
