// SPDX-License-Identifier: MIT
#include "evenmesh/plot/axis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "evenmesh/plot/svg.h"

namespace evenmesh {
namespace {

constexpr int kLabelledDecades = 10;
constexpr int kDecadesWithMinorTicks = 8;
constexpr const char* kMinus = "\u2212";

// 1, 2 or 5 times a power of ten, the least that makes at most so many steps.
double nice_step(double length, int steps) {
  const double power = std::pow(10.0, std::floor(std::log10(length / steps)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    // A hair of rounding must not cost a factor.
    if (factor * power * steps >= length * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::string with_minus(std::string text) {
  return text.starts_with('-') ? kMinus + text.substr(1) : text;
}

// A multiple of a step, with the decimals that the step needs.
Tick labelled(double place, double value, double step) {
  if (step >= 1e6 || step < 1e-5) {
    const int exponent = static_cast<int>(std::floor(std::log10(std::max(std::abs(value), step))));
    const double mantissa = value == 0.0 ? 0.0 : value / std::pow(10.0, exponent);
    if (mantissa == 0.0) return {place, "0", ""};
    return {place, with_minus(svg_number(mantissa, 4)) + "\u00D710",
            with_minus(std::to_string(exponent))};
  }
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  return {place, with_minus(svg_number(value, decimals)), ""};
}

}  // namespace

Axis::Axis(double low, double high, bool is_logarithmic)
    : low_(low), high_(high), is_logarithmic_(is_logarithmic) {}

Axis Axis::linear(double low, double high, int ticks, bool whole) {
  assert(std::isfinite(low) && std::isfinite(high) && ticks > 0);
  if (!(high > low)) high = low + std::max(1.0, std::abs(low) * 1e-6);
  Axis axis(low, high, false);
  double step = nice_step(high - low, ticks);
  if (whole) step = std::max(1.0, step);
  // Multiples are counted, not added up: the hundredth is as exact as the first.
  const double slack = 1e-9 * (high - low);
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k) {
    axis.ticks_.push_back(labelled(axis.place(k * step), k * step, step));
  }
  return axis;
}

Axis Axis::from_zero(double high, int ticks, bool whole) {
  if (!(high > 0.0)) high = 1.0;
  const double step = whole ? std::max(1.0, nice_step(high, ticks)) : nice_step(high, ticks);
  return linear(0.0, std::ceil(high / step * (1.0 - 1e-9)) * step, ticks, whole);
}

Axis Axis::logarithmic(double low, double high) {
  assert(low > 0.0 && low <= high && std::isfinite(high));
  const int first = static_cast<int>(std::floor(std::log10(low) + 1e-9));
  const int last = std::max(first + 1, static_cast<int>(std::ceil(std::log10(high) - 1e-9)));
  Axis axis(first, last, true);
  const int decades = last - first;
  const int stride = (decades + kLabelledDecades - 1) / kLabelledDecades;
  const auto at = [&](double exponent) { return (exponent - first) / decades; };
  for (int k = first; k <= last; ++k) {
    if ((last - k) % stride == 0) {
      axis.ticks_.push_back({at(k), "10", with_minus(std::to_string(k))});
    } else {
      axis.ticks_.push_back({at(k), "", ""});
    }
    if (decades > kDecadesWithMinorTicks || k == last) continue;
    for (int i = 2; i < 10; ++i) axis.ticks_.push_back({at(k + std::log10(i)), "", ""});
  }
  return axis;
}

double Axis::place(double value) const {
  return ((is_logarithmic_ ? std::log10(value) : value) - low_) / (high_ - low_);
}

}  // namespace evenmesh
