// SPDX-License-Identifier: MIT
//
// The pictures of a run: convergence.svg, quality.svg and mesh.svg in a folder.
#pragma once

#include <string>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/solver/report.h"

namespace evenmesh::app {

/// Finds out before the work whether the pictures can be written. Leaves nothing behind.
/// @param folder  where they go; need not be there if the folder around it is. Empty: none are
///                asked for
/// @param others  other files that the run reads or writes
/// @throws InvalidOption  a picture would overwrite one of them
/// @throws IoError        the folder or a picture in it cannot be written
void check_plot_folder(const std::string& folder, const std::vector<std::string>& others);

/// What the pictures show. What it refers to must outlive it.
struct Plotted {
  std::string title;
  const Mesh& before;
  const Mesh* after;  // null: there is no result to show
  const Orientation& orientation;
  const Report& report;
  int threads = 0;
};

/// Writes the pictures, over those of an earlier run.
/// @throws IoError  one could not be written
void write_plots(const std::string& folder, const Plotted& plotted);

}  // namespace evenmesh::app
