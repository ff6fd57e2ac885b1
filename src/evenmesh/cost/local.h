// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/cost/cost.h"

namespace evenmesh {

/// Makes the edges of each cell equally long, whatever the cell's size.
///
///   f(x) = sum over cells e, edges j of e:  (l_ej - m_e)^2,   m_e = mean of the l_ej
///
/// An edge shared by two cells counts once in each. Minimum 0, reached when every cell is
/// equilateral. m_e is taken anew at every evaluation; since the differences to a mean add up to
/// 0, its own change does not enter the gradient. Scale-free: every cell's part divided by m_e^2.
///
/// Blind to orientation and, on quads, to shear. f(s x) = s^2 f(x): a mesh with nothing to hold it
/// collapses to a point (not so the scale-free variant).
/// @see   Kulovec, Kos, Duhovnik 2011, Eqs. 13 and 14
class Local final : public Cost {
 public:
  explicit Local(Scaling scaling = Scaling::absolute) : scaling_(scaling) {}

  std::string_view name() const override { return "local"; }
  double evaluate(const CellBlock& cells, Points x, double weight,
                  std::span<Vec3> gradient) const override;
  void add_springs(const CellBlock& cells, Points x, std::vector<Spring>& springs) const override;
  bool can_collapse() const override { return scaling_ == Scaling::absolute; }

 private:
  Scaling scaling_;
};

}  // namespace evenmesh
