// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/problem/constraints.h"
#include "evenmesh/quality/quality.h"
#include "evenmesh/solver/report.h"

namespace evenmesh {

/// A cell by the name it has in the file, with what it is like.
struct NamedCell {
  std::string name;
  CellKind kind = CellKind::triangle;
  double shape_before = 0.0;
  double shape_after = 0.0;
  bool inverted = false;  // afterwards
  std::size_t fixed_vertices = 0;
  std::vector<std::string> held_by = {};  // what keeps it from getting better, the strongest first
};

/// A cell that is inverted afterwards.
struct InvertedCell {
  std::string name;                       // in the file
  std::vector<std::string> held_by = {};  // what keeps it from getting better, the strongest first
};

/// A constraint that keeps the cost from falling further.
struct HoldingConstraint {
  std::string kind;            // "fixed", "slide", "validity", "max_move", or a function's name
  std::size_t count = 0;       // vertices, cells or rows of which it holds some cost
  double multiplier = 0.0;     // sum of their multipliers
  std::string strongest = {};  // the one with the greatest multiplier, by its name in the file
};

/// Everything there is to say about one run of the program: what the JSON report is made from.
struct RunRecord {
  std::string status;  // "ok", "refused", "interrupted", "failed"
  int exit_code = 0;
  std::string message;  // one sentence for people
  std::string command;  // to repeat the run

  std::string input;
  std::string output;  // empty: nothing was written
  std::string format;
  std::uint64_t input_bytes = 0;
  std::size_t vertices = 0;
  std::array<std::size_t, kCellKinds> cells{};  // by kind
  MeshType type = MeshType::surface;
  std::size_t components = 0;
  std::size_t cells_against_majority = 0;
  std::vector<std::pair<std::string, std::string>> options;  // effective, name and value
  std::vector<std::string> notes;

  std::vector<ConstraintSummary> constraints;  // what held
  Report report;
  std::vector<NamedCell> worst;              // by shape afterwards, the worst first
  std::vector<InvertedCell> still_inverted;  // the first thousand
  std::vector<HoldingConstraint> holding;    // the strongest first

  double read_seconds = 0.0;
  double write_seconds = 0.0;  // including reading back and checking
  double total_seconds = 0.0;
  double cpu_seconds = 0.0;
  std::uint64_t peak_memory_bytes = 0;
};

/// The version of the report's format: additions raise the second number, anything else the first.
inline constexpr const char* kReportSchemaVersion = "1.4";

/// The record as JSON text, indented, with a final newline; docs/report.schema.json describes it.
/// Infinite values (the edge ratio of a collapsed cell) are null, as JSON has no word for them.
std::string to_json(const RunRecord& record);

/// The `count` worst cells after a run: those that are inverted, then those with the least `shape`,
/// the worst first; equal ones in the order of the file. Names are left empty.
/// @return  cell numbers
std::vector<std::size_t> worst_cells(const CellQuality& quality, std::size_t count);

}  // namespace evenmesh
