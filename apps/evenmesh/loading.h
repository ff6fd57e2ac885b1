// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "apps/evenmesh/console.h"
#include "evenmesh/io/mesh_file.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/report/run_record.h"

namespace evenmesh::app {

/// What all verbs need of a file.
struct InputArguments {
  std::string path;
  double feature_angle = 45.0;
  double weld_tolerance = 0.0;
};

/// A mesh from a file and what can be seen in it without moving anything.
struct Input {
  MeshFile file;
  Orientation orientation;
  Topology topology;
  std::size_t inverted_by_curves = 0;  // cells of second order whose corners alone make good ones
  double read_seconds = 0.0;
};

/// Reads and analyses; says what it found.
Input load(const InputArguments& arguments, const Console& console);

/// Fills in the record's facts about the input.
void describe(const Input& input, RunRecord& record);

/// "1,200 triangles, 3 quads"
std::string cell_counts(const Cells& cells);

/// Cells, worst shape first, with the names they have in the file.
std::vector<NamedCell> name_cells(const Input& input, const std::vector<std::size_t>& cells,
                                  const CellQuality& before, const CellQuality& after,
                                  const std::vector<char>& fixed);

}  // namespace evenmesh::app
