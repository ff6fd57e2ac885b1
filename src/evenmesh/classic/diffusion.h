// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "evenmesh/classic/rule.h"

namespace evenmesh {

/// The forces between neighbours at distance d, in units of the target length; > 0 repels.
enum class Force : std::uint8_t {
  lennard_jones,          // d^-13 - d^-7
  lennard_jones_printed,  // d^-13 - d^-4
  pliant                  // (1 - d^4) exp(-d^4)
};

/// f(d), at least about the distance 0.01: below it what it is there, so that it stays finite.
/// All are 0 at d = 1.
double force(Force kind, double d);

/// Neighbours repel a vertex where they are nearer than a target length h and attract it where
/// they are farther:
///
///   x_i <- x_i - 0.2 h * sum over edges {i, j} of f(|x_j - x_i| / h) * (x_j - x_i) / |x_j - x_i|
///
/// A neighbour at the same place has no direction and is left out. No move is longer than h: the
/// force d^-13 of a single short edge would throw its vertices out of the mesh.
/// @see   Bossen and Heckbert, A pliant method for anisotropic mesh generation, 1996. Here the
///        connectivity stays.
class Diffusion final : public Rule {
 public:
  /// @param length  h, mesh length unit; where it is 0 nothing moves
  Diffusion(Force kind, double length) : kind_(kind), length_(length) {}

  Vec3 move(const Star& star, Points x) const override;

 private:
  Force kind_;
  double length_;
};

}  // namespace evenmesh
