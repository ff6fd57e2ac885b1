// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace evenmesh {

/// A number for every vertex, or for every cell, that a file has under a name.
struct DataArray {
  std::string name = {};  // as in the file
  bool on_cells = false;
  /// One number per vertex or cell of the mesh, read from the file when asked for.
  /// @throws IoError  what stands there is broken
  std::function<std::vector<double>()> values = {};
};

}  // namespace evenmesh
