// SPDX-License-Identifier: MIT
#include "evenmesh/quality/angles.h"

#include <cmath>
#include <numbers>

namespace evenmesh {
namespace {

/// Grows with the interior angle from 0 through 2 at 180 degrees to 4, and needs no atan2.
double order(const SurfaceCell::Corner& corner) {
  const double sum = std::abs(corner.dot) + corner.area;
  const double half_turn = sum > 0.0 ? 1.0 - corner.dot / sum : 0.0;
  return corner.signed_area < 0.0 ? 4.0 - half_turn : half_turn;
}

double angle_degrees(const SurfaceCell::Corner& corner) {
  const double angle = 180.0 / std::numbers::pi * std::atan2(corner.area, corner.dot);
  return corner.signed_area < 0.0 ? 360.0 - angle : angle;
}

}  // namespace

AngleRange angle_range(const SurfaceCell& cell) {
  if (!(cell.shortest() > 0.0)) return {0.0, 180.0};
  const SurfaceCell::Corner* smallest = cell.corners().data();
  const SurfaceCell::Corner* largest = smallest;
  double least = order(*smallest);
  double most = least;
  for (const auto& corner : cell.corners().subspan(1)) {
    const double here = order(corner);
    if (here < least) {
      least = here;
      smallest = &corner;
    }
    if (here > most) {
      most = here;
      largest = &corner;
    }
  }
  return {angle_degrees(*smallest), angle_degrees(*largest)};
}

}  // namespace evenmesh
