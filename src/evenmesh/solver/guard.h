// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/motion.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/quality/quality.h"
#include "evenmesh/solver/deviation_limit.h"
#include "evenmesh/solver/report.h"

namespace evenmesh {

/// The promise that nothing gets worse, for one input mesh:
///
/// - no cell is inverted that was not in the input, and none that was has a corner further over or,
///   if it is inverted between good corners, a lower determinant there,
/// - the worst value over the mesh of every metric is at least as good as in the input, unless
///   the input has inverted cells: then getting rid of them comes first,
/// - so is the mean of `shape`, unless inverted cells have all become valid,
/// - and the shape stays within a distance of the input's, if one is set.
class Guard {
 public:
  /// Measures the input. It and the orientation must outlive the guard.
  Guard(Workers& workers, const Mesh& input, const Orientation& orientation);

  /// Also keeps the shape within a distance of another (or the same) mesh's.
  /// @param limit  must outlive the guard
  void set_limit(const DeviationLimit* limit) { limit_ = limit; }
  /// Lets vertices that go back stay on their tracks, and those that are tied go back together.
  /// @param motion  with its start at the input; must outlive the guard
  void set_motion(const Motion* motion) { motion_ = motion; }

  const QualitySummary& before() const { return summary_; }

  /// Looks for a breach in other positions of the same mesh.
  /// @return  one sentence that names the first, or nothing
  std::string find_breach(Workers& workers, Points points, Judge judge) const;

  /// The mean of `shape` over all cells at other positions.
  double mean_shape_at(Workers& workers, Points points) const;

  struct Result {
    Promise promise = Promise::kept;
    bool mean_fell = false;  // vertices went back because the mean of shape was lower than before
    std::size_t pulled_back = 0;
    std::size_t inverted_unguarded = 0;  // cells, before anything was pulled back
    double deviation = 0.0;              // of the shape, if a limit is set
    QualitySummary after;
  };

  /// What a file can hold of positions (identity if empty).
  using Rounding = std::function<std::vector<Vec3>(Points)>;

  /// Vertices of cells that would be spoilt in a way that the mesh does not know (none if empty).
  using Spoilt = std::function<std::vector<Index>(Points)>;

  /// Changes positions until they keep the promise: vertices of offending cells go back half the
  /// way to where they were, then three quarters, then all of it. A vertex that is all the way back
  /// has the bits of the input, and a cell all of whose vertices are back cannot offend, so this
  /// ends. With a mean that fell, vertices around which `shape` fell go back the same way.
  /// Judge::nothing only rounds and measures.
  /// @param points  replaced by the positions that keep the promise, rounded
  Result enforce(Workers& workers, std::vector<Vec3>& points, Judge judge,
                 const Rounding& rounding = {}, const Spoilt& spoilt = {}) const;

 private:
  class Retreat;

  bool offends(const CellQuality& quality, std::size_t cell, Points points, Judge judge) const;
  bool is_further_over(std::size_t cell, Points points) const;
  bool mean_counts(const CellQuality& quality) const;
  double least_corner_of(std::size_t cell, Points points) const;
  double least_determinant_of(std::size_t cell, Points points) const;

  const Mesh& input_;
  const Orientation& orientation_;
  CellQuality quality_;
  QualitySummary summary_;
  const DeviationLimit* limit_ = nullptr;
  const Motion* motion_ = nullptr;
};

}  // namespace evenmesh
