// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "evenmesh/base/parallel.h"
#include "evenmesh/constraint/motion.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/report.h"

namespace evenmesh {

/// What keeps vertices from going further down the cost, from the multipliers at `points`: of what
/// was eliminated, the part of the gradient that vertices cannot follow.
/// @param mesh    has its vertices where `motion` starts
/// @param motion  as the problem has it, without what was fixed on the way
Holding holding_at(Workers& workers, const Mesh& mesh, const Motion& motion, Objective& objective,
                   Points points);

/// Demands that are not met.
std::size_t count_unmet(const Holding& holding);

}  // namespace evenmesh
