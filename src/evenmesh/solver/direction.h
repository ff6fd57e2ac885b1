// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// Search directions of the preconditioned conjugate gradient method of Polak and Ribiere:
///
///   p = -z + beta p,   beta = max(0, z.(g - g_old) / (z_old.g_old)),   z = M g
class ConjugateGradients {
 public:
  /// Turns p into the next direction.
  /// @param g, g_old  gradients at the current and at the previous iterate
  /// @param z         the preconditioned gradient
  void next(Workers& workers, Points g, Points g_old, Points z, std::vector<Vec3>& p);
  /// Forgets the past: the next direction is -z.
  void restart() { last_gz_ = 0.0; }

 private:
  double last_gz_ = 0.0;  // z.g of the previous iterate; 0: none
};

/// Search directions of L-BFGS with the preconditioner as its initial inverse Hessian: slower than
/// conjugate gradients where these work (twice the iterations), but its steps keep their length
/// where curvature changes along the way. (Nocedal and Wright, 2006, algorithm 7.4)
class Lbfgs {
 public:
  static constexpr std::size_t kPairs = 5;

  /// Remembers a step. Skipped where the curvature along it is not positive.
  void remember(Workers& workers, Points x, Points x_old, Points g, Points g_old);
  /// First half of the two-loop recursion: q, on entry the gradient, is what M is applied to.
  void before_preconditioner(Workers& workers, std::vector<Vec3>& q);
  /// Second half: p, on entry M q, becomes the search direction.
  void after_preconditioner(Workers& workers, std::vector<Vec3>& p);
  void restart() { pairs_.clear(); }

 private:
  struct Pair {
    std::vector<Vec3> s, y;
    double rho = 0.0;
    double alpha = 0.0;
  };
  std::deque<Pair> pairs_;  // oldest first
};

}  // namespace evenmesh
