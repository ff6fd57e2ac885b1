// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/base/parallel.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh {

/// A mesh with vertices at their targets, the others having followed.
struct Brought {
  Mesh mesh;
  int steps = 0;  // in which the way was gone; 0: nothing had to move
};

/// Brings vertices to a problem's targets on straight lines and lets the others follow so that no
/// cell turns over: the whole way at once, and where cells stay inverted then, in shorter steps.
/// What the others do in between is minimise the cost under the problem's other constraints; only
/// a few iterations, enough to be valid. Where that does not work even in the shortest steps, cells
/// are left inverted. When the run is interrupted vertices are left on their way.
Brought bring_to_targets(Workers& workers, const Mesh& mesh, const Problem& problem,
                         const Options& options);

}  // namespace evenmesh
