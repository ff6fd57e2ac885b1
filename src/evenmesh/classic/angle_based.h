// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/classic/rule.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// Every edge to a neighbour wants to halve the angle that the two cells beside it have there
/// together: seen from neighbour j, vertex i goes to where it is after a turn by half the
/// difference of the angles on both sides,
///
///   x_i <- mean over j of  x_j + R_j (x_i - x_j),   R_j: turn by (left angle - right angle) / 2.
///
/// Edges with fewer or more than two cells have no such angle and are left out. Turns are about the
/// direction that counts as up in the input.
///
/// Triangles only: about perfect squares the same rule is unstable (docs/classic.md).
/// @see   Zhou and Shimada, An angle-based approach to two-dimensional mesh smoothing, 2000: the
///        mean without weights
class AngleBased final : public Rule {
 public:
  /// Both must outlive the rule.
  AngleBased(const Mesh& mesh, const Orientation& orientation)
      : mesh_(mesh), orientation_(orientation) {}

  Vec3 move(const Star& star, Points x) const override;

 private:
  bool turn_at(const Link& link, const Star& star, Points x, Vec3& turn) const;

  const Mesh& mesh_;
  const Orientation& orientation_;
};

}  // namespace evenmesh
