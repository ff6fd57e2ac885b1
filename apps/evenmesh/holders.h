// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "evenmesh/io/mesh_file.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/report/run_record.h"
#include "evenmesh/solver/report.h"

namespace evenmesh::app {

/// Says in words which constraints hold what, from their multipliers. All arguments must outlive
/// the object.
class Holders {
 public:
  Holders(const Problem& problem, const Holding& holding, const FilePatch& names)
      : problem_(problem), holding_(holding), names_(names) {}

  /// What keeps a cell from getting better, the strongest first.
  std::vector<std::string> of_cell(std::size_t cell, std::span<const Index> vertices) const;

  /// All constraints by kind, the strongest first.
  std::vector<HoldingConstraint> ranked() const;

 private:
  const Problem& problem_;
  const Holding& holding_;
  const FilePatch& names_;
};

}  // namespace evenmesh::app
