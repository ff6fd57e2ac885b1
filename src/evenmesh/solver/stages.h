// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/solver/report.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh {

/// Takes what a stage used from the budget of the next one, which goes on counting iterations where
/// that stopped.
/// @param iterations  >= 0
/// @param seconds     wall-clock
void take_from(Options& options, int iterations, double seconds);

/// Makes of two stages' reports that of both.
/// @param report  that of the second stage; then that of both
/// @pre  both have a history
void put_before(const Report& first, Report& report);

}  // namespace evenmesh
