// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string_view>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// A number c(x) that depends on the positions of some vertices, to be kept equal to a value or
/// within an interval. function_of() makes one from a formula and differentiates it.
class Function {
 public:
  virtual ~Function() = default;

  /// The word for it in reports and messages.
  virtual std::string_view name() const = 0;

  /// The vertices it depends on, each once.
  virtual std::span<const Index> vertices() const = 0;

  /// @param own       positions of vertices(), in their order, mesh length unit
  /// @param gradient  one vector per entry of vertices(), set to the derivative with respect to
  ///                  it; empty: only the value is wanted
  virtual double evaluate(Points own, std::span<Vec3> gradient) const = 0;
};

/// lower <= c(x) <= upper; an equation where both are the same.
struct Bound {
  std::shared_ptr<const Function> function;
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();

  bool is_equation() const { return lower == upper; }
};

}  // namespace evenmesh
