// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "evenmesh/problem/problem.h"

namespace evenmesh::app {

/// "local=0.3,barycenter" -> names and weights (1 where none is given); nothing: none.
/// @throws InvalidOption  the text does not parse, or a weight is beyond reason
std::vector<CostChoice> parse_costs(const std::string& text);

/// The other way round, for the costs that a problem has.
std::string cost_text(const Problem& problem);

}  // namespace evenmesh::app
