// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/classic/rule.h"
#include "evenmesh/classic/worst_shape.h"

namespace evenmesh {

/// Along the gradient of the `shape` of the worst cell around, by a tenth of the mean length of the
/// edges around. The gradient is found from differences.
/// @see   Canann, Tristano, Staten, An approach to combined Laplacian and optimization-based
///        smoothing for triangular, quadrilateral, and quad-dominant meshes, 1998
class Climb final : public Rule {
 public:
  /// Both must outlive the rule.
  Climb(const Mesh& mesh, const Orientation& orientation) : shapes_(mesh, orientation) {}

  Vec3 move(const Star& star, Points x) const override;

 private:
  WorstShape shapes_;
};

}  // namespace evenmesh
