// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "evenmesh/problem/constraints.h"
#include "evenmesh/problem/scene.h"

namespace evenmesh {

/// What vertices may do that nobody asks anything of, as apply() says.
std::vector<Held> find_defaults(const Scene& scene);

/// Lets vertices that take part in no slide do what default_of says.
void apply_defaults(const Scene& scene, Arrangement& arrangement);

/// The defaults that nothing overruled.
/// @pre  everything is arranged
std::vector<ConstraintSummary> summarize_defaults(const Scene& scene,
                                                  const Arrangement& arrangement);

}  // namespace evenmesh
