// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/classic/rule.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// To the mean of the circumcentres around, weighted with areas (or volumes):
///
///   x_i <- sum over cells e around i of |e| c_e  /  sum of |e|
///
/// This is where the vertex belongs in an optimal Delaunay triangulation; here the connectivity
/// stays. |e| is signed in a plane and in space, which makes |e| c_e a polynomial: flat cells,
/// whose circumcentre is far off, do no harm. Where the sum of |e| is not positive the vertex
/// stays. Triangles and tets.
/// @see   Chen, Mesh smoothing schemes based on optimal Delaunay triangulations, 2004
class OptimalDelaunay final : public Rule {
 public:
  /// Both must outlive the rule.
  OptimalDelaunay(const Mesh& mesh, const Orientation& orientation)
      : mesh_(mesh), orientation_(orientation) {}

  Vec3 move(const Star& star, Points x) const override;

 private:
  const Mesh& mesh_;
  const Orientation& orientation_;
};

}  // namespace evenmesh
