// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/solver/flips.h"
#include "evenmesh/solver/multigrid.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/report.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh {

/// Minimises an objective from x, in place: nonlinear conjugate gradients (Polak and Ribiere, PR+)
/// preconditioned with multigrid, a secant line search, steps shortened where a cell would turn
/// over. Where conjugate gradients fail to descend, L-BFGS with the same preconditioner takes over.
/// Fills in the report's stop, history and held.
/// @param observe  called with every iterate, the first included; returns false to stop there
///
/// The cost never rises from one iterate to the next (beyond rounding), so the last is the best.
void descend(Workers& workers, Objective& objective, Multigrid& preconditioner, const Flips& flips,
             const Options& options, std::vector<Vec3>& x, Report& report,
             const std::function<bool(Points x)>& observe = {});

}  // namespace evenmesh
