// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/dual.h"
#include "evenmesh/constraint/function.h"

namespace evenmesh {

/// What a formula gets: the positions of its vertices, x[0] that of the first one named.
/// @tparam T  a Dual, without slopes where only the value is wanted
template <typename T>
using Corners = std::span<const Eigen::Matrix<T, 3, 1>>;

/// How many derivatives a formula computes at once: those of four positions.
inline constexpr int kSlopesAtOnce = 12;

/// A formula that can be asked for its value and for its derivatives.
template <typename F>
concept Formula = requires(const F& formula, Corners<Dual<0>> x, Corners<Dual<kSlopesAtOnce>> y) {
  { formula(x) } -> std::convertible_to<Dual<0>>;
  { formula(y) } -> std::convertible_to<Dual<kSlopesAtOnce>>;
};

/// A function of the positions of a few vertices from its formula alone, usually a generic lambda:
///
///   function_of("length", {3, 7}, [](auto x) { return (x[1] - x[0]).norm(); })
///
/// The derivatives come with the formula (forward mode) and are exact to rounding. It may use
/// vector operations of Eigen, numbers, branches, loops, and sqrt, abs, sin, atan2, pow, min, ...
/// as in dual.h, without std:: before them. Angles are best the atan2 of a cross and a dot product:
/// acos is steep at its ends. Intermediate vectors need their type written down, as with any use of
/// Eigen: `typename decltype(x)::value_type e = x[1] - x[0];`. What the formula cannot compute (the
/// logarithm of a negative number, 0/0) is passed on as it comes, NaN or infinite.
///
/// A value takes one call of the formula, a gradient one more per four vertices. No allocation up
/// to eight vertices.
/// @param name      the word for it in reports and messages
/// @param vertices  whose positions the formula gets, in this order, each once
/// @param formula   value = formula(x) for any Corners x of as many positions; called from
///                  several threads
/// @throws InvalidOption  there are no vertices, or one is named twice.
template <Formula F>
std::shared_ptr<const Function> function_of(std::string name, std::vector<Index> vertices,
                                            F formula);

// ---- implementation -----------------------------------------------------------------------------

namespace detail {

/// @throws InvalidOption  as function_of() does
void check_vertices(std::string_view name, std::span<const Index> vertices);

/// An array whose length is known at run time, on the stack where it is short.
template <typename T>
class ShortArray {
 public:
  explicit ShortArray(std::size_t size) : size_(size), long_(size > kShort ? size : 0) {}

  std::span<T> span() { return {size_ > kShort ? long_.data() : short_.data(), size_}; }
  T& operator[](std::size_t i) { return span()[i]; }

 private:
  static constexpr std::size_t kShort = 8;
  std::size_t size_;
  std::array<T, kShort> short_;
  std::vector<T> long_;
};

template <typename F>
class FormulaFunction final : public Function {
 public:
  FormulaFunction(std::string name, std::vector<Index> vertices, F formula)
      : name_(std::move(name)), vertices_(std::move(vertices)), formula_(std::move(formula)) {
    check_vertices(name_, vertices_);
  }

  std::string_view name() const override { return name_; }
  std::span<const Index> vertices() const override { return vertices_; }

  double evaluate(Points x, std::span<Vec3> gradient) const override {
    assert(gradient.empty() || gradient.size() == vertices_.size());
    if (!gradient.empty()) differentiate(x, gradient);
    ShortArray<Position<0>> corners(vertices_.size());
    for (std::size_t i = 0; i < vertices_.size(); ++i) corners[i] = constant<0>(x[vertices_[i]]);
    const Dual<0> result = formula_(Corners<Dual<0>>(corners.span()));
    return result.value;
  }

 private:
  template <int Count>
  using Position = Eigen::Matrix<Dual<Count>, 3, 1>;

  template <int Count>
  static Position<Count> constant(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
  }
  static Position<kSlopesAtOnce> variable(const Vec3& p, std::size_t place) {
    const int first = static_cast<int>(3 * place);
    using Number = Dual<kSlopesAtOnce>;
    return {Number::variable(p.x(), first), Number::variable(p.y(), first + 1),
            Number::variable(p.z(), first + 2)};
  }

  void differentiate(Points x, std::span<Vec3> gradient) const {
    const std::size_t size = vertices_.size();
    ShortArray<Position<kSlopesAtOnce>> corners(size);
    for (std::size_t i = 0; i < size; ++i) corners[i] = constant<kSlopesAtOnce>(x[vertices_[i]]);

    constexpr std::size_t kAtOnce = kSlopesAtOnce / 3;
    for (std::size_t first = 0; first < size; first += kAtOnce) {
      const std::size_t last = std::min(first + kAtOnce, size);
      for (std::size_t i = first; i < last; ++i) {
        corners[i] = variable(x[vertices_[i]], i - first);
      }
      const Dual<kSlopesAtOnce> result = formula_(Corners<Dual<kSlopesAtOnce>>(corners.span()));
      for (std::size_t i = first; i < last; ++i) {
        gradient[i] = result.slopes.template segment<3>(static_cast<Eigen::Index>(3 * (i - first)));
        corners[i] = constant<kSlopesAtOnce>(x[vertices_[i]]);
      }
    }
  }

  std::string name_;
  std::vector<Index> vertices_;
  F formula_;
};

}  // namespace detail

template <Formula F>
std::shared_ptr<const Function> function_of(std::string name, std::vector<Index> vertices,
                                            F formula) {
  return std::make_shared<const detail::FormulaFunction<F>>(std::move(name), std::move(vertices),
                                                            std::move(formula));
}

}  // namespace evenmesh
