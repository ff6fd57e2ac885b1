// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/report/shown_mesh.h"

namespace evenmesh::app {

/// Keeps positions at iterations that are evenly spread over a run whose length nobody knows.
class Iterates {
 public:
  /// @param most  how many are kept
  explicit Iterates(std::size_t most = 0) : most_(most) {}

  /// An iterate that may be kept; they come in their order.
  void add(int iteration, Points points);

  /// Forgets those behind an iteration.
  void end_at(int iteration);

  const std::vector<StoredIterate>& kept() const { return kept_; }

 private:
  std::size_t most_;
  int stride_ = 1;  // of the numbers that are kept
  std::vector<StoredIterate> kept_;
};

}  // namespace evenmesh::app
