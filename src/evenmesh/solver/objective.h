// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/solver/layout.h"
#include "evenmesh/solver/multigrid.h"

namespace evenmesh {

/// A problem in the numbering of a layout: the function that drivers minimise.
class Objective {
 public:
  /// The problem must outlive the objective.
  Objective(const Mesh& mesh, const Problem& problem);

  const Layout& layout() const { return layout_; }
  std::size_t size() const { return layout_.size(); }
  const Motion& motion() const { return motion_; }
  Motion& motion() { return motion_; }

  /// The layout's vertices' positions out of the mesh's, and back.
  std::vector<Vec3> gather(Points of_mesh) const;
  void scatter(Points of_layout, std::span<Vec3> of_mesh) const;

  /// The weighted sum of the costs.
  /// @param[out] gradient  projected onto what each vertex may follow; or empty
  double evaluate(Workers& workers, Points x, std::span<Vec3> gradient) const;

  /// The Laplacian of the costs' springs at x over the vertices that may move: the majoriser of
  /// the costs' Hessian that the solver preconditions with.
  SymmetricMatrix majoriser(Workers& workers, Points x) const;

 private:
  const Problem& problem_;
  Layout layout_;
  Motion motion_;  // in the layout's numbering
};

}  // namespace evenmesh
