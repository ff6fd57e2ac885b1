// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// A unit vector perpendicular to a unit vector, always the same one.
inline Vec3 perpendicular(const Vec3& axis) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return axis.cross(Vec3::Unit(least)).normalized();
}

}  // namespace evenmesh
