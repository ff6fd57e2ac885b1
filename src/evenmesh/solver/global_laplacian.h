// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "evenmesh/classic/relaxation.h"
#include "evenmesh/classic/stars.h"
#include "evenmesh/solver/multigrid.h"

namespace evenmesh {

/// The fixed point of Laplacian smoothing as one sparse linear system, solved by conjugate
/// gradients preconditioned with multigrid: every vertex that may move is, within its freedom, at
/// the mean of its neighbours.
///
///   Z^T L Z y = -Z^T L x,   x <- x + Z y,     L the Laplacian of the graph of edges
///
/// One sweep is enough where vertices move freely, in planes and on lines. On curves and surfaces
/// it solves for tangents and brings vertices back, and the next sweep takes it from there.
class GlobalLaplacian final : public Relaxation {
 public:
  /// What is passed must outlive the object.
  GlobalLaplacian(const Mesh& mesh, const Motion& motion);

  void sweep(Workers& workers, std::vector<Vec3>& x, Motion::Places& places) override;

 private:
  bool is_unknown(Index v) const;
  SymmetricMatrix matrix() const;
  std::vector<Projector> projectors(const Motion::Places& places) const;
  void apply(Workers& workers, const Motion::Places& places, Points p, std::span<Vec3> q) const;
  std::vector<Vec3> solve(Workers& workers, const Motion::Places& places,
                          std::vector<Vec3> right) const;

  const Motion& motion_;
  Stars stars_;
};

}  // namespace evenmesh
