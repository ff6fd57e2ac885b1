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
///
/// With Options::solver newton the directions are Newton's instead, and all else is the same; with
/// automatic they are where conjugate gradients stall or are about to use up their iterations,
/// if a factorisation is a matter of seconds. newton too does without where not even the indices of
/// a factor fit.
///
/// Fills in the report's stop, history, held, solver and newton_steps.
/// @param observe  called with every iterate, the first included; returns false to stop there
///
/// The cost never rises from one iterate to the next of the same function (beyond rounding).
void descend(Workers& workers, Objective& objective, Multigrid& preconditioner, const Flips& flips,
             const Options& options, std::vector<Vec3>& x, Report& report,
             const std::function<bool(Points x)>& observe = {});

}  // namespace evenmesh
