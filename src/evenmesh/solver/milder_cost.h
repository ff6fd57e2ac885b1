// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"

namespace evenmesh {

/// Whether milder_terms() may do better than the problem's own, where these let the mean of shape
/// fall: the cost is `shape` alone, of a planar or surface mesh that is not too large, since the
/// minimum is found slowly.
bool has_milder_cost(const Mesh& mesh, const Problem& problem);

/// Instead of `shape`, where the boundary leaves no room for good cells, so that its minimiser
/// takes much from many cells for the sake of the worst: the logarithm, which takes less, with a
/// wall before the worst cells.
///
///   f(x) = weight * sum over cells of the mean over their corners of
///          -log(chi(t) / chi(1)) + (w / chi(t))^2 / 2 + constant,   w = 0.25
///
/// with chi of Shape, of a softness so small that no cell can be given up for others.
/// @pre  has_milder_cost()
std::vector<Term> milder_terms(const Problem& problem);

}  // namespace evenmesh
