// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// A triangle, quad or polygon reduced to what its measures are made of, so that all of them can
/// share one pass over the points. One object may be set again and again.
///
/// Lengths and areas are in a unit of the cell's own: no measure depends on size, and cells of
/// size 1e-160 or 1e150 are brought near 1 before anything is multiplied.
class SurfaceCell {
 public:
  /// Sizes at one corner, where a and b are the sides that leave it to the next and to the
  /// previous corner.
  struct Corner {
    double signed_area;  // (a x b) . n, n the cell's own unit normal
    double area;         // |a x b|, the same but for the sign if the cell is planar
    double dot;          // a . b
    double next;         // |a|
    double previous;     // |b|
  };

  /// The corner of the regular polygon with as many corners.
  struct Regular {
    double sine, cosine;  // of the interior angle
    double tangent;       // of pi / corners: the area is corners / (4 tangent), the side being 1
  };

  /// @param points  the corners in their order, at least 3. If a coordinate is not finite the cell
  ///                counts as collapsed to one point.
  /// @param up      the direction that counts as positive, any length, or zero: the cell's own
  void set(std::span<const Vec3> points, const Vec3& up);

  std::span<const Corner> corners() const {
    return {many_.empty() ? few_.data() : many_.data(), count_};
  }
  const Regular& regular() const { return regular_; }
  double area() const { return area_; }  // of the cell, not negative

  /// 1, or -1 if the cell's own normal points against up, or 0 if it is square to up. A quad or
  /// polygon of no net area has no normal; up stands in for it then, with sign 1.
  double sign() const { return sign_; }

  double longest() const { return longest_; }  // side
  double shortest() const { return shortest_; }
  double perimeter() const { return perimeter_; }

 private:
  bool try_set(std::span<const Vec3> points, const Vec3& up);
  std::span<Corner> make_room(std::size_t count);

  static constexpr std::size_t kFew = 8;
  std::array<Corner, kFew> few_;  // no allocation for the usual cell
  std::vector<Corner> many_;      // empty, or all corners
  std::size_t count_ = 0;
  Regular regular_{};
  double area_ = 0.0;
  double sign_ = 1.0;
  double longest_ = 0.0;
  double shortest_ = 0.0;
  double perimeter_ = 0.0;
};

}  // namespace evenmesh
