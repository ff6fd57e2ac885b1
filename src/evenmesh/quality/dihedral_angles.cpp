// SPDX-License-Identifier: MIT
#include "evenmesh/quality/dihedral_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace evenmesh {
namespace {

/// Of an angle that stands for others until the end, because an arc tangent for each would take
/// most of the time: s / (s + |c|) up to 90 degrees and 2 minus that above, in [0, 2]. It grows
/// with the angle and has all digits of small ones.
struct Extremes {
  double least = 2.0;
  double most = 0.0;

  /// False if there is no angle.
  bool add(double sine, double cosine) {
    const double sum = sine + std::abs(cosine);
    if (!(sum > 0.0)) return false;
    const double half = sine / sum;
    // In hexes the sign is a coin toss: as a factor it costs no branch.
    const double obtuse = cosine < 0.0 ? 1.0 : 0.0;
    const double order = half + obtuse * (2.0 - 2.0 * half);
    least = std::min(least, order);
    most = std::max(most, order);
    return true;
  }
};

double degrees(double order) {
  return 180.0 / std::numbers::pi * std::atan2(std::min(order, 2.0 - order), 1.0 - order);
}

bool add_angles(const VolumeCell::Corner& corner, Extremes& extremes) {
  const Vec3 ab = corner.a.cross(corner.b);
  const Vec3 bc = corner.b.cross(corner.c);
  const Vec3 ca = corner.c.cross(corner.a);
  const double size = std::abs(corner.determinant);
  return extremes.add(corner.a.norm() * size, -ab.dot(ca)) &&
         extremes.add(corner.b.norm() * size, -bc.dot(ab)) &&
         extremes.add(corner.c.norm() * size, -ca.dot(bc));
}

}  // namespace

AngleRange angle_range(const VolumeCell& cell) {
  constexpr AngleRange kWorst = {0.0, 180.0};
  if (!(cell.shortest() > 0.0)) return kWorst;
  Extremes extremes;
  for (const VolumeCell::Corner& corner : cell.corners()) {
    if (!add_angles(corner, extremes)) return kWorst;
  }
  return {degrees(extremes.least), degrees(extremes.most)};
}

}  // namespace evenmesh
