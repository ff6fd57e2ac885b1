// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "evenmesh/mesh/mesh.h"

namespace evenmesh::testing {

/// Triangles of a square whose middle vertex lies such that every step of the cost local makes
/// some worst value worse.
inline constexpr const char* kCannotImprove =
    "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 0 1 0\nv 0.5 0.6 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

/// The same square with its middle vertex far from the middle: there is much to gain.
inline constexpr const char* kCanImprove =
    "# one\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.2 0.3 0 # middle\n"
    "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

/// A cube of eight vertices: all of them corners, so none may move.
inline constexpr const char* kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

inline void write_obj(const Mesh& mesh, const std::filesystem::path& path) {
  std::string text;
  for (const Vec3& p : mesh.points()) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    text += 'f';
    for (const Index v : mesh.cells().vertices(c)) text += fmt::format(" {}", v + 1);
    text += '\n';
  }
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace evenmesh::testing
