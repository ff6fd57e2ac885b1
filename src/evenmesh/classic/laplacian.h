// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/classic/rule.h"

namespace evenmesh {

/// To the mean of the neighbours:  x_i <- mean over edges {i, j} of x_j.
///
/// An edge counts once, however many cells share it. One vertex after the other, as here, this
/// lowers the sum of squared edge lengths at every move, within what lines and planes allow.
/// @see   Field, Laplacian smoothing and Delaunay triangulations, 1988
class Laplacian final : public Rule {
 public:
  Vec3 move(const Star& star, Points x) const override;
};

}  // namespace evenmesh
