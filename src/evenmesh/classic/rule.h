// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/base/vec3.h"
#include "evenmesh/classic/stars.h"

namespace evenmesh {

/// Where a vertex should go, given what is around it. Implementations are const and safe to call
/// from many threads.
class Rule {
 public:
  virtual ~Rule() = default;

  /// The move of the star's vertex, and of all that are tied to it, as if it were free.
  /// @return  finite; 0 where the rule has nothing to go by, as at a vertex without neighbours
  virtual Vec3 move(const Star& star, Points x) const = 0;
};

}  // namespace evenmesh
