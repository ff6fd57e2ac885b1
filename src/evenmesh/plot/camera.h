// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// A parallel projection. Its vectors are orthonormal.
struct Camera {
  Vec3 right;
  Vec3 up;
  Vec3 towards;  // the viewer
  Vec3 light;    // unit, from the viewer's upper left

  /// To the right, up, and towards the viewer.
  Vec3 project(const Vec3& v) const { return {right.dot(v), up.dot(v), towards.dot(v)}; }
};

/// @throws InvalidOption  the directions are parallel, or one is zero
Camera look_from(const Vec3& view, const Vec3& up);

/// Square to a plane, z (else y) up and x (else y) to the right. The normal's sign does not matter.
Camera look_at_plane(const Vec3& normal);

}  // namespace evenmesh
