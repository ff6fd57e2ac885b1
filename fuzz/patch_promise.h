// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/base/error.h"
#include "evenmesh/io/format.h"
#include "evenmesh/io/gzip.h"

namespace evenmesh::fuzz {

inline void demand(bool claim) {
  if (!claim) std::abort();
}

inline std::string written(const MeshFile& file, Points points) {
  std::string text;
  file.patch->write(points, [&](std::string_view piece) { text += piece; });
  return text;
}

/// Moves vertices here and there, mostly to places of their own, all finite.
inline std::vector<Vec3> moved_points(const Mesh& mesh) {
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 3 == 0) continue;
    const double factor = 1.0 + 1e-3 * static_cast<double>(i % 97);
    for (int k = 0; k < 3; ++k) {
      const double there = points[i][k] * factor + static_cast<double>(i % 5) - 2.0;
      if (std::isfinite(there) && (i + static_cast<std::size_t>(k)) % 2 == 0) points[i][k] = there;
    }
  }
  return points;
}

inline void demand_same_points(Points a, Points b) {
  demand(a.size() == b.size());
  demand(a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

/// What every reader and its patch promise, for any bytes whatever.
inline void check_promise(Format format, std::string_view bytes, const ReadOptions& options = {}) {
  if (bytes.empty() || is_gzip(bytes)) return;  // the patch is of what is in it
  const auto input = InputFile::borrow(bytes, "fuzz");
  MeshFile file;
  try {
    find_format(*input);
  } catch (const IoError&) {
  }
  try {
    file = read_as(format, input, options);
  } catch (const IoError&) {
    return;
  }
  demand(written(file, file.mesh.points()) == bytes);
  if (!file.mesh.cells().empty()) file.patch->cell_name(file.mesh.cells().size() - 1);
  if (file.mesh.point_count() > 0) file.patch->vertex_name(0);

  // With a tolerance, vertices that move may become one with others: write_mesh() refuses those.
  if (options.weld_tolerance > 0.0) return;
  const std::vector<Vec3> points = moved_points(file.mesh);
  const std::vector<Vec3> wanted = file.representable(points);
  const std::string text = written(file, wanted);
  const MeshFile again = read_as(format, InputFile::borrow(text, "again"), {});
  // Corners of an STL may fall together; they are then fewer, which write_mesh() refuses.
  if (again.mesh.point_count() != wanted.size()) {
    demand((format == Format::stl_ascii || format == Format::stl_binary) &&
           again.mesh.point_count() < wanted.size());
    return;
  }
  demand(std::ranges::equal(again.mesh.cells().corners(), file.mesh.cells().corners()));
  demand(std::ranges::equal(again.mesh.cells().offsets(), file.mesh.cells().offsets()));
  demand_same_points(again.mesh.points(), wanted);
}

}  // namespace evenmesh::fuzz
