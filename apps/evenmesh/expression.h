// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// A displacement that depends on the place, from three formulas in x, y, z:
///
///   0, 0.1 * sin(2 * pi * x), y > 0 ? 0.5 : 0
///
/// What muParser knows may be used: + - * / ^, comparisons, && ||, ?:, sin, sqrt, abs, min, max,
/// atan2, exp, rint, ... and the constant pi. Numbers have a decimal point whatever the locale.
/// An object is for one thread at a time.
class Displacement {
 public:
  /// @throws InvalidOption  the text does not parse or is not three formulas; the message has the
  ///                        text, where in it, and what to try
  explicit Displacement(std::string text);
  ~Displacement();
  Displacement(Displacement&&) noexcept;
  Displacement& operator=(Displacement&&) noexcept;

  /// @return  in the mesh length unit, like p
  /// @throws InvalidOption  a formula is not finite at p (the message has the place)
  Vec3 operator()(const Vec3& p) const;

 private:
  struct Formulas;
  std::unique_ptr<Formulas> formulas_;
};

}  // namespace evenmesh
