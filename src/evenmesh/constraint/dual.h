// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross()

namespace evenmesh {

/// A number and its derivatives with respect to Count others; Count may be 0. Formulas written for
/// doubles differentiate themselves when given this instead.
///
/// Every operation yields a finished Dual. Eigen's AutoDiffScalar yields expressions that refer to
/// their operands, which dangle in `auto a = 2.0 * f(x)` and in what a lambda returns.
/// Comparisons look at the value alone. Where a function has no derivative, the chain rule's
/// infinity or NaN is passed on, except that sqrt (and with it every norm) and abs have slope 0 at
/// 0.
template <int Count>
struct Dual {
  using Slopes = Eigen::Array<double, Count, 1>;

  double value = 0.0;
  Slopes slopes = Slopes::Zero();

  Dual() = default;
  // A constant; implicit, as numbers are in formulas.
  Dual(double constant) : value(constant) {}
  Dual(double v, const Slopes& s) : value(v), slopes(s) {}

  /// The variable that slopes[place] counts.
  static Dual variable(double value, int place) {
    Dual result(value);
    result.slopes[place] = 1.0;
    return result;
  }
  /// g of this, for g(value) and g'(value).
  Dual through(double g, double slope) const { return {g, slope * slopes}; }

  Dual operator-() const { return through(-value, -1.0); }
  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.slopes + b.slopes};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.slopes - b.slopes};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.slopes * b.value + b.slopes * a.value};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.slopes - quotient * b.slopes) / b.value};
  }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend auto operator<=>(const Dual& a, const Dual& b) { return a.value <=> b.value; }

  // ---- friends, so that they are found for Duals alone and take numbers beside them -------------

  friend Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value);
    return a.through(root, root == 0.0 ? 0.0 : 0.5 / root);
  }
  friend Dual abs(const Dual& a) {
    return a.through(std::abs(a.value), (a.value > 0.0) - (a.value < 0.0));
  }
  friend Dual exp(const Dual& a) { return a.through(std::exp(a.value), std::exp(a.value)); }
  friend Dual log(const Dual& a) { return a.through(std::log(a.value), 1.0 / a.value); }
  friend Dual sin(const Dual& a) { return a.through(std::sin(a.value), std::cos(a.value)); }
  friend Dual cos(const Dual& a) { return a.through(std::cos(a.value), -std::sin(a.value)); }
  friend Dual tan(const Dual& a) {
    const double tangent = std::tan(a.value);
    return a.through(tangent, 1.0 + tangent * tangent);
  }
  friend Dual asin(const Dual& a) {
    return a.through(std::asin(a.value), 1.0 / std::sqrt(1.0 - a.value * a.value));
  }
  friend Dual acos(const Dual& a) {
    return a.through(std::acos(a.value), -1.0 / std::sqrt(1.0 - a.value * a.value));
  }
  friend Dual atan(const Dual& a) {
    return a.through(std::atan(a.value), 1.0 / (1.0 + a.value * a.value));
  }
  friend Dual atan2(const Dual& y, const Dual& x) {
    const double squared = x.value * x.value + y.value * y.value;
    return {std::atan2(y.value, x.value), (x.value * y.slopes - y.value * x.slopes) / squared};
  }
  friend Dual hypot(const Dual& x, const Dual& y) { return sqrt(x * x + y * y); }
  friend Dual pow(const Dual& a, double b) {
    return a.through(std::pow(a.value, b), b == 0.0 ? 0.0 : b * std::pow(a.value, b - 1.0));
  }
  friend Dual pow(const Dual& a, const Dual& b) {
    const double power = std::pow(a.value, b.value);
    return {power, b.value * std::pow(a.value, b.value - 1.0) * a.slopes +
                       power * std::log(a.value) * b.slopes};
  }
  friend Dual min(const Dual& a, const Dual& b) { return b < a ? b : a; }
  friend Dual max(const Dual& a, const Dual& b) { return a < b ? b : a; }
  friend bool isfinite(const Dual& a) { return std::isfinite(a.value); }
};

}  // namespace evenmesh

// Lets Eigen's vectors hold it, alone and together with doubles.
template <int Count>
struct Eigen::NumTraits<evenmesh::Dual<Count>> : Eigen::NumTraits<double> {
  using Real = evenmesh::Dual<Count>;
  using NonInteger = evenmesh::Dual<Count>;
  using Nested = evenmesh::Dual<Count>;
  using Literal = evenmesh::Dual<Count>;
  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1 };
  enum { ReadCost = 1 + Count, AddCost = 1 + Count, MulCost = 1 + 3 * Count };
};
template <int Count, typename Op>
struct Eigen::ScalarBinaryOpTraits<evenmesh::Dual<Count>, double, Op> {
  using ReturnType = evenmesh::Dual<Count>;
};
template <int Count, typename Op>
struct Eigen::ScalarBinaryOpTraits<double, evenmesh::Dual<Count>, Op> {
  using ReturnType = evenmesh::Dual<Count>;
};
