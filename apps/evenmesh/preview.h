// SPDX-License-Identifier: MIT
//
// What a run is about to do, in words.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "apps/evenmesh/commands.h"
#include "evenmesh/problem/constraints.h"
#include "evenmesh/problem/problem.h"

namespace evenmesh::app {

/// A constraint, how it enters, for how many and who asked for it, in columns.
std::string in_one_line(const ConstraintSummary& constraint);

/// How many vertices may do what: "of 25 vertices 4 are fixed, 12 slide, 9 are free".
std::string freedoms(const Motion& motion, MeshType type);

/// The options that matter to the result, by name and value in TOML, with what was chosen where
/// they left it open.
std::vector<std::pair<std::string, std::string>> chosen_options(const SmoothArguments& arguments,
                                                                const Problem& problem);

/// A configuration file that repeats the run, with what holds in its comments.
std::string dry_run_text(const SmoothArguments& arguments,
                         const std::vector<ConstraintSummary>& constraints, const Problem& problem);

}  // namespace evenmesh::app
