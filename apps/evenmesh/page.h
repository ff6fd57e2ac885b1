// SPDX-License-Identifier: MIT
//
// Reports in HTML: what is said of a mesh, of two, and of a run.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/loading.h"
#include "evenmesh/constraint/motion.h"
#include "evenmesh/report/report_page.h"
#include "evenmesh/report/shown_mesh.h"

namespace evenmesh::app {

/// The mesh of an input as a report shows it: with its groups, numbers, curves and wall layers.
/// What is passed must outlive the result.
ShownMesh shown_mesh(const Input& input, const CellQuality& quality);

/// How many of the worst cells a report lists.
inline constexpr std::size_t kWorstInPage = 50;

/// What every vertex may do.
std::vector<Hold> holds_of(const Motion& motion, MeshType type);

/// Title, quality and facts of a mesh that was not moved.
ReportPage page_of(const Input& input, const QualitySummary& quality);

/// Adds the worst cells of that which the mesh shows, without what holds them.
void list_worst(const Input& input, const ShownMesh& mesh, ReportPage& page);

/// Adds what moved, by how much, and what became of area or volume.
void add_changes(const ShownMesh& mesh, ReportPage& page);

// ---- what was checked ----

Verdict no_inverted_cells(const QualitySummary& before, const QualitySummary& after);
/// Of every metric. Not judged where cells were inverted: getting rid of them comes first.
/// @param judged  false: worse was allowed
Verdict worst_not_lower(const QualitySummary& before, const QualitySummary& after, bool judged);

/// What is known of a run beside its record.
struct RunFacts {
  std::size_t fixed = 0;        // vertices that may not move
  std::size_t fixed_moved = 0;  // of these those that have, by a bit or more
  std::string target = {};      // "shape>=0.3"; empty: none
  std::size_t below_target = 0;
  double max_deviation = std::numeric_limits<double>::infinity();
  bool fails_demand = false;  // one that somebody asked for
  bool same_shape = true;     // nothing was prescribed, so that quality and deviation count
  bool allows_worse = false;
};

/// Adds what the run promised and whether it holds, and its facts.
void add_run(const RunRecord& record, const RunFacts& facts, ReportPage& page);

/// Writes the file, complete or not at all.
/// @throws IoError  it cannot be written
void write_page(const HtmlArguments& arguments, const ReportPage& page, const ShownMesh& mesh);

}  // namespace evenmesh::app
