// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/cost/cost.h"

namespace evenmesh {

/// Makes quads rectangular and other cells round: corners equally far from the middle.
///
///   quads:      (d_1 - d_2)^2, the lengths of the two diagonals
///   triangles:  0
///   others:     sum over vertices k:  (r_k - mean r)^2,  r_k = |x_k - centroid of the vertices|
///
/// This is what gives quads their stiffness against shear, which edge lengths cannot see: without
/// some of it the costs local and global fold quads. Scale-free: every cell's part divided by the
/// square of the mean of its d (or r).
/// @see   Kulovec, Kos, Duhovnik 2011, section 3 ("equal diagonals"); the part for other cells is
///        ours
class Barycenter final : public Cost {
 public:
  explicit Barycenter(Scaling scaling = Scaling::absolute) : scaling_(scaling) {}

  std::string_view name() const override { return "barycenter"; }
  double evaluate(const CellBlock& cells, Points x, double weight,
                  std::span<Vec3> gradient) const override;
  void add_springs(const CellBlock& cells, Points x, std::vector<Spring>& springs) const override;
  bool can_collapse() const override { return scaling_ == Scaling::absolute; }

 private:
  Scaling scaling_;
};

}  // namespace evenmesh
