// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace evenmesh {

struct Tick {
  double place;        // along the axis, 0 at its low end and 1 at its high one
  std::string label;   // empty: a minor tick
  std::string raised;  // an exponent behind the label: 10 and -3
};

/// An axis of a chart: where values lie along it, and the ticks that tell them.
class Axis {
 public:
  /// From low to high as they are; ticks at multiples of 1, 2 or 5 times a power of ten.
  /// @param ticks  about how many, > 0
  /// @param whole  none between whole numbers
  static Axis linear(double low, double high, int ticks, bool whole = false);

  /// As linear(), from 0 to the first tick that is not below high.
  static Axis from_zero(double high, int ticks, bool whole = false);

  /// Whole decades around low and high, at most ten of them labelled; minor ticks at 2 to 9 times
  /// each, or at the decades without a label where there are many.
  /// @pre  0 < low <= high, finite
  static Axis logarithmic(double low, double high);

  /// From 0 to 1, where there is nothing to measure.
  static Axis without_ticks() { return {0.0, 1.0, false}; }

  /// 0 at the low end, 1 at the high one; finite for every value that has a place.
  double place(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  Axis(double low, double high, bool is_logarithmic);

  double low_, high_;  // of logarithmic axes the exponents
  bool is_logarithmic_;
  std::vector<Tick> ticks_;
};

}  // namespace evenmesh
