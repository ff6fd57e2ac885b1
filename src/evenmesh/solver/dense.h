// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/solver/flips.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/report.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh {

/// Memory beyond which the dense method is refused: enough for about 7,000 unknowns.
inline constexpr double kMostDenseBytes = 1024.0 * 1024.0 * 1024.0;

/// Minimises an objective from x, in place, by the paper's own method: lagrange_newton() on the
/// costs, with every demand a constraint of its own. What motion eliminates stays eliminated: the
/// unknowns are steps along lines and in tangent planes, whose axes turn as little as they can when
/// a vertex moves along its track.
///
/// Unknowns have the unit of length, or where the springs of the costs are more than a hundred
/// times stiffer or softer than those of the paper's costs (2), the one that makes them alike: the
/// identity that curvature starts from is then as good a guess as there.
///
/// While no cell is inverted, steps end at .95 of where the first cell would turn over. If demands
/// on cells are not met at the start, the lagrangian's smoothed penalty is minimised first, in its
/// stages and in the same way but without constraints, until they are.
///
/// Fills in the report's stop, history and solver, and leaves the multipliers with the objective's
/// lagrangian.
/// @param flips    null: cells may turn over
/// @param observe  called with every iterate, the first included; returns false to stop there
/// @throws InvalidOption  there are so many unknowns that it takes more than kMostDenseBytes; the
///                        message says how many and what to use instead
/// @pre  the objective is constrained
void descend_densely(Workers& workers, Objective& objective, const Flips* flips,
                     const Options& options, std::vector<Vec3>& x, Report& report,
                     const std::function<bool(Points x)>& observe = {});

}  // namespace evenmesh
