// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "apps/evenmesh/gallery/figures.h"
#include "evenmesh/solver/report.h"

namespace evenmesh::gallery {

/// How a case is run.
enum class Way : std::uint8_t {
  paper,        // the paper's dense method, its budget; validity and the promise are off
  dense,        // the same method with validity, to the end
  evenmesh,     // the solver of the library's own choice, validity and the promise on
  cured_dense,  // the last two for Case::cure
  cured_evenmesh
};
std::string_view name(Way way);

/// What came out.
struct Result {
  Way way = Way::paper;
  Report report;
  std::vector<Vec3> points;
  double cost = 0.0;       // f alone, without what constraints add
  double size = 1.0;       // total area, relative to the start's; cells turned over count negative
  double error = 0.0;      // greatest distance from the known optimum, if there is one
  double departure = 0.0;  // greatest distance from the sheet of Fig. 28

  int iterations() const { return report.history.empty() ? 0 : report.history.back().number; }
  std::size_t inverted() const { return report.quality_after.inverted; }
};

/// The problem that a way makes of a case.
/// @pre  the case has a cure if the way asks for it
Problem problem_of(const Case& of, Way way, const Mesh& mesh);

/// Runs a case from a mesh; that of the case, or another one alike.
Result run(const Case& of, Way way, const Mesh& mesh);

/// All the ways of a case, from its own mesh.
std::vector<Result> run_all_ways(const Case& of);

/// A case from many random starts; its optimum is known.
struct Medians {
  int least = 0;  // iterations
  double median = 0.0;
  int most = 0;
  double error_at_stop = 0.0;  // the greatest distance from the optimum, where Case::eps stops
  double error_at_end = 0.0;   // and where an eps of 1e-16 does
  std::size_t inverted = 0;    // cells, over all of them
};
inline constexpr int kStarts = 30;

/// @pre  the plate of the case is exact
Medians run_random_starts(const Case& of, Way way);

}  // namespace evenmesh::gallery
