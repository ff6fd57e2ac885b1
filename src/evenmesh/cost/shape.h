// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/cost/cost.h"

namespace evenmesh {

/// Makes every cell as like its ideal one as it can be, whatever its size: the inverse of what the
/// metric `shape` measures.
///
///   f(x) = sum over cells of the mean over their corners k of  (1 / chi(t_k)^p - 1 / chi(1)^p) /
///   p, t_k  = (d / |T|^2)^(d/2) det T,   T = A W^-1,   chi(t) = (t + sqrt(t^2 + delta^2)) / 2
///
/// and for p = 0, which is the limit of that, of log(chi(1) / chi(t_k)).
///
/// A has the edges at the corner, W those of the ideal cell; d is the dimension of the cell. t is 1
/// for the ideal corner and shape^(d/2) for others, negative where the corner is turned over. There
/// f is finite and large, most of all for the mirror image of the ideal corner, so that what is
/// turned over far is better untangled first. Knows no lengths, so sizes follow from
/// what is fixed. Triangles and tets have the same t at every corner.
///
/// The greater the exponent p, the more the worst cells count; as p grows the minimiser becomes
/// the mesh whose worst cell is best. The smaller the softness delta, the less a corner may be
/// turned over, and the harder is the way out for one that is.
///
/// On a surface the determinant is that about the cell's up direction, in a volume mesh surface
/// cells count nothing.
/// @see   Knupp, "Algebraic mesh quality metrics", SIAM J. Sci. Comput. 23 (2001): mean ratio;
///        chi as in Escobar et al., Comput. Methods Appl. Mech. Eng. 192 (2003)
class Shape final : public Cost {
 public:
  /// Corners with a smaller t are treated more and more like inverted ones.
  static constexpr double kSoftness = 0.05;

  /// @param exponent  p, from 0 to 32
  /// @param softness  delta, above 0
  explicit Shape(int exponent = 1, double softness = kSoftness)
      : exponent_(exponent), softness_(softness) {}
  std::string_view name() const override { return "shape"; }
  double evaluate(const CellBlock& cells, Points x, double weight,
                  std::span<Vec3> gradient) const override;
  void add_springs(const CellBlock& cells, Points x, std::vector<Spring>& springs) const override;
  bool wants_valid_cells() const override { return true; }

 private:
  int exponent_;
  double softness_;
};

}  // namespace evenmesh
