// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/solver/lagrangian.h"
#include "evenmesh/solver/layout.h"
#include "evenmesh/solver/multigrid.h"

namespace evenmesh {

/// The function that drivers minimise: a problem's costs over a mesh's cells, and what constraints
/// add to them, laid out for speed.
class Objective {
 public:
  /// The costs alone. The problem must outlive the objective.
  Objective(const Mesh& mesh, const Problem& problem);
  Objective(const Objective&) = delete;
  Objective& operator=(const Objective&) = delete;

  /// Adds the constraints. The mesh and the points must outlive the objective.
  /// @param origin  where moves are measured from
  void constrain(Workers& workers, const Mesh& mesh, Points origin);
  /// Null before constrain().
  Lagrangian* lagrangian() { return lagrangian_ ? &*lagrangian_ : nullptr; }
  const Lagrangian* lagrangian() const { return lagrangian_ ? &*lagrangian_ : nullptr; }

  const Problem& problem() const { return problem_; }
  const Layout& layout() const { return layout_; }
  std::size_t size() const { return motion_.size(); }
  const Motion& motion() const { return motion_; }
  Motion& motion() { return motion_; }

  /// The weighted sum of the costs, and what constraints add.
  /// @param[out] gradient  with respect to every position, whether it may move or not; or empty
  double evaluate(Workers& workers, Points x, std::span<Vec3> gradient) const;
  /// The part of it that a block's cells contribute.
  /// @param gradient  added to; or empty
  double evaluate(const Layout::Block& block, Points x, std::span<Vec3> gradient) const;
  /// The weighted sum of the costs alone.
  /// @param[out] gradient  as for evaluate()
  double cost(Workers& workers, Points x, std::span<Vec3> gradient = {}) const;
  /// Geometric mean of the stiffnesses of the costs' springs at x; 1 if there are none.
  double typical_stiffness(Points x) const;

  /// The Laplacian of the costs' springs at x over the vertices that may move: the majoriser of
  /// the costs' Hessian that the solver preconditions with. Pieces of the mesh that no fixed vertex
  /// holds in place are held by a slight pull everywhere, which makes the matrix definite. Springs
  /// that are 10^12 times as stiff (or as soft) as the typical one count as just that.
  SymmetricMatrix majoriser(Workers& workers, Points x) const;
  /// The directions of the majoriser's rows that cannot move in all of them.
  std::vector<Projector> projectors(const Motion::Places& places) const;

 private:
  double cost(const Layout::Block& block, Points x, std::span<Vec3> gradient) const;
  double sum_over_blocks(Workers& workers, std::span<Vec3> gradient,
                         const std::function<double(const Layout::Block&)>& part) const;

  const Problem& problem_;
  Layout layout_;
  Motion motion_;  // the problem's, less what was held on the way
  std::optional<Lagrangian> lagrangian_;
};

}  // namespace evenmesh
