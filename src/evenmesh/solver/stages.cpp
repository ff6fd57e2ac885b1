// SPDX-License-Identifier: MIT
#include "evenmesh/solver/stages.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace evenmesh {

void take_from(Options& options, int iterations, double seconds) {
  options.max_iterations = std::max(0, options.max_iterations - iterations);
  if (options.time_limit_seconds > 0.0) {
    options.time_limit_seconds = std::max(1e-9, options.time_limit_seconds - seconds);
  }
  if (options.watch) {
    options.watch = [iterations, watch = options.watch](Iteration iteration, Points points) {
      iteration.number += iterations;
      watch(iteration, points);
    };
  }
  if (!options.progress) return;
  options.progress = [iterations, progress = options.progress](Iteration iteration) {
    iteration.number += iterations;
    return progress(iteration);
  };
}

void put_before(const Report& first, Report& report) {
  const Iteration last = first.history.back();
  std::vector<Iteration> history = first.history;
  for (Iteration iteration : report.history) {
    if (iteration.number == 0) continue;  // where the first stage ended
    iteration.number += last.number;
    iteration.function += last.function + 1;
    history.push_back(iteration);
  }
  report.history = std::move(history);
  if (first.stop == Stop::interrupted) report.stop = first.stop;
  report.held += first.held;
  report.newton_steps += first.newton_steps;
  report.setup_seconds += first.setup_seconds;
  report.setup_cpu_seconds += first.setup_cpu_seconds;
  report.solve_seconds += first.solve_seconds;
}

}  // namespace evenmesh
