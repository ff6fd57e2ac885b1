// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/solver/report.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh {

/// Makes the worst cells better, now that the others are good: where `shape` is less than a
/// threshold, the vertices around are moved to where
///
///   sum over the cells there of  1 / chi(t) + w / (p chi(t)^p),   w = 4 t_0^(p-1)
///
/// (the cost Shape twice) is least, p being 8, then 32. t_0 belongs to the threshold: the second
/// part says next to nothing to cells above it, and to those below the more the worse they are, so
/// that where the threshold is out of reach the least shape becomes as large as it can. What is
/// farther off stays. Each place is taken over only if its least shape rises. A minimum of the
/// mean alone leaves single cells bad, since one among thousands weighs little.
///
/// Vertices that are tied, or that functions with bounds depend on, are left alone.
/// @param problem  its motion with its start at start
/// @param start    where vertices were when the iterations began
/// @param origin   where moves are measured from
/// @param x        changed in place
Lifting lift_worst(Workers& workers, const Mesh& mesh, const Problem& problem, Points start,
                   Points origin, const Options& options, std::vector<Vec3>& x);

}  // namespace evenmesh
