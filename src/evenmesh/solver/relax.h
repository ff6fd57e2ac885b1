// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/classic/relaxation.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/report.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh {

/// Throws InvalidOption, naming the method and the remedy, where a classic method cannot do what a
/// problem asks: bounds on functions, a least size or Jacobian of cells, kinds of cell it does not
/// know, targets without a cost by which others follow, and nothing that keeps the mesh from
/// shrinking to a point.
void check_method(Method method, const Mesh& mesh, const Problem& problem);

/// The relaxation for a method.
/// What is passed must outlive it.
std::unique_ptr<Relaxation> relaxation_of(Method method, const Mesh& mesh, const Problem& problem);

/// Repeats a relaxation's sweep from x, in place, until in one sweep no vertex moves farther than
/// Options::tolerance times the mean length of its edges in the input. The costs of the objective
/// are recorded and nothing more.
///
/// Fills in the report's stop and history.
/// @param mesh     the input
/// @param observe  called with every iterate, the first included; returns false to stop there
void relax(Workers& workers, Relaxation& relaxation, const Mesh& mesh, const Objective& objective,
           const Options& options, std::vector<Vec3>& x, Report& report,
           const std::function<bool(Points x)>& observe = {});

}  // namespace evenmesh
