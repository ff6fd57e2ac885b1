// SPDX-License-Identifier: MIT
#include "evenmesh/plot/camera.h"

#include <cmath>

#include "evenmesh/base/error.h"

namespace evenmesh {

Camera look_from(const Vec3& view, const Vec3& up) {
  const Vec3 towards = view.stableNormalized();
  const Vec3 right = up.stableNormalized().cross(towards);
  if (!(right.norm() > 1e-9)) {
    throw InvalidOption("a view and what is up in it must not point the same way, nor be zero");
  }
  Camera camera;
  camera.towards = towards;
  camera.right = right.normalized();
  camera.up = towards.cross(camera.right);
  camera.light = (0.75 * camera.towards + 0.5 * camera.up - 0.4 * camera.right).normalized();
  return camera;
}

Camera look_at_plane(const Vec3& normal) {
  const bool lies_flat = std::abs(normal.z()) > 0.9 * normal.norm();
  const Vec3 up = lies_flat ? Vec3::UnitY() : Vec3::UnitZ();
  const Camera camera = look_from(normal, up);
  int most = 0;
  camera.right.cwiseAbs().maxCoeff(&most);
  return camera.right[most] < 0.0 ? look_from(-normal, up) : camera;
}

}  // namespace evenmesh
