// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/loading.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/solver/report.h"

namespace evenmesh::app {

/// A run that has come to its end. What it refers to must outlive it.
struct Ending {
  const SmoothArguments& arguments;
  const Input& input;
  const Problem& problem;
  const Report& report;
};

/// Why the run ended as it did, and what is not met, in one sentence without a full stop.
std::string outcome(const Ending& ending);

/// Whether something that an option demands is not met. What holds by default (that no cell is
/// turned over) is asked for by nobody.
bool fails_a_demand(const ConstraintText& asked, const Holding& holding);

}  // namespace evenmesh::app
