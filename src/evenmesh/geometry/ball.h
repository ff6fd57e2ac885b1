// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// The ball around a point through another, a little larger: the other must be in it whatever
/// rounding says.
class Ball {
 public:
  Ball(const Vec3& centre, const Vec3& through) : centre_(centre) {
    constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
    const double size = centre.lpNorm<Eigen::Infinity>() + through.lpNorm<Eigen::Infinity>();
    const double radius = (centre - through).norm() * (1.0 + kRounding) + kRounding * size;
    squared_radius_ = radius * radius;
  }

  bool contains(double squared_distance) const { return squared_distance <= squared_radius_; }
  bool contains(const Vec3& point) const { return contains((point - centre_).squaredNorm()); }

 private:
  Vec3 centre_;
  double squared_radius_;
};

}  // namespace evenmesh
