// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// Finds where the boundary conditions of a file change: vertices on sides with different labels
/// may not slide, even where the boundary is flat or straight, or an inlet would grow.
class SideLabels {
 public:
  /// @param label  what the file calls the side by, above 0
  void add(std::span<const Index> vertices, std::uint32_t label) {
    for (const Index v : vertices) {
      if (v >= label_of_.size()) label_of_.resize(std::size_t{v} + 1 + label_of_.size(), 0);
      if (label_of_[v] == 0) label_of_[v] = label;
      if (label_of_[v] != label) label_of_[v] = kSeveral;
    }
  }

  std::vector<Index> between() const {
    std::vector<Index> result;
    for (std::size_t v = 0; v < label_of_.size(); ++v) {
      if (label_of_[v] == kSeveral) result.push_back(static_cast<Index>(v));
    }
    return result;
  }

 private:
  static constexpr std::uint32_t kSeveral = ~std::uint32_t{0};
  std::vector<std::uint32_t> label_of_;
};

}  // namespace evenmesh
