// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/console.h"
#include "apps/evenmesh/loading.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/report/run_record.h"
#include "evenmesh/report/shown_mesh.h"

namespace evenmesh::app {

/// A run as far as it came. What it refers to must outlive it.
struct RunState {
  const SmoothArguments& arguments;
  const Input* input = nullptr;  // null: it was not read
  const Problem& problem;
  const Mesh* result = nullptr;  // null: there is none
  std::optional<double> target;  // of every cell's shape
  const std::vector<StoredIterate>& iterates;
};

/// Writes those reports of a run that are asked for, in JSON and HTML, adding to the record what
/// only they tell: the worst cells, and what holds what.
/// @throws IoError  one cannot be written
void write_reports(const RunState& state, RunRecord& record, const Console& console);

}  // namespace evenmesh::app
