// SPDX-License-Identifier: MIT
#include "apps/evenmesh/iterates.h"

namespace evenmesh::app {

void Iterates::add(int iteration, Points points) {
  if (most_ == 0 || iteration % stride_ != 0) return;
  // A stage of a run begins where the one before it ended.
  if (!kept_.empty() && kept_.back().iteration >= iteration) return;
  kept_.push_back({iteration, {points.begin(), points.end()}});
  while (kept_.size() > most_) {  // ends: all but iteration 0 fall to a stride beyond them
    stride_ *= 2;
    std::erase_if(kept_, [this](const StoredIterate& s) { return s.iteration % stride_ != 0; });
  }
}

void Iterates::end_at(int iteration) {
  std::erase_if(kept_, [iteration](const StoredIterate& s) { return s.iteration > iteration; });
}

}  // namespace evenmesh::app
