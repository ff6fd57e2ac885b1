// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/area.h"

#include <cassert>
#include <cstddef>

namespace evenmesh {
namespace {

Vec3 triangle_area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 bc = c - b;
  const Vec3 ca = a - c;
  const double ab2 = ab.squaredNorm();
  const double bc2 = bc.squaredNorm();
  const double ca2 = ca.squaredNorm();
  if (ab2 >= bc2 && ab2 >= ca2) return 0.5 * bc.cross(ca);
  if (bc2 >= ca2) return 0.5 * ca.cross(ab);
  return 0.5 * ab.cross(bc);
}

}  // namespace

Vec3 area_vector(std::span<const Vec3> corners) {
  assert(corners.size() >= 3);
  if (corners.size() == 3) return triangle_area_vector(corners[0], corners[1], corners[2]);
  if (corners.size() == 4) return 0.5 * (corners[2] - corners[0]).cross(corners[3] - corners[1]);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    sum += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  }
  return 0.5 * sum;
}

}  // namespace evenmesh
