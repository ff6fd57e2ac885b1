// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "evenmesh/problem/constraints.h"
#include "evenmesh/problem/scene.h"

namespace evenmesh {

/// Gives vertices that are prescribed a place a target there, their images the one that goes with
/// it, and fixes them all.
/// @throws InvalidOption  a place that contradicts what else is asked of the vertex
void prescribe(const Scene& scene, Arrangement& arrangement);

/// One line for each prescription.
std::vector<ConstraintSummary> summarize_prescriptions(const Scene& scene);

}  // namespace evenmesh
