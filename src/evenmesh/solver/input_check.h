// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"

namespace evenmesh {

/// What nobody but smooth() can tell, who knows both.
/// @throws InvalidOption  squares of the mesh's lengths leave the range of doubles, or a demand of
///                        the problem is none that the mesh can meet: a bound on a vertex that is
///                        not there, with its limits the wrong way round, a limit of moves that is
///                        not positive
void check_input(const Mesh& mesh, const Problem& problem);

}  // namespace evenmesh
