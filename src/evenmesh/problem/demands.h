// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "evenmesh/problem/constraints.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/problem/scene.h"

namespace evenmesh {

/// @throws InvalidOption  a length that is not positive and finite or in a unit that has no meaning
///                        for it; a Jacobian outside (0, 1)
void check_lengths(const Scene& scene);

/// Fills in the demands of a problem: max_move, bounds, validity and max_deviation.
/// @throws InvalidOption  a limit of moves below the way to a target
void demand(const Scene& scene, const Arrangement& arrangement, Problem& problem);

/// One line for each demand.
/// @pre  problem is complete
std::vector<ConstraintSummary> summarize_demands(const Scene& scene, const Arrangement& arrangement,
                                                 const Problem& problem);

}  // namespace evenmesh
