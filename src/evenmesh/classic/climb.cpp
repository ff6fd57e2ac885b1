// SPDX-License-Identifier: MIT
#include "evenmesh/classic/climb.h"

namespace evenmesh {

Vec3 Climb::move(const Star& star, Points x) const {
  constexpr double kPart = 0.1;
  constexpr double kDifference = 1e-5;  // relative to edges, as kPart
  double length = 0.0;
  for (const Link& link : star.links) length += (x[link.to] - x[link.from]).norm();
  const WorstShape::Found worst = shapes_.of(star, x);
  if (!(length > 0.0) || worst.shape == 1.0) return Vec3::Zero();
  length /= static_cast<double>(star.links.size());

  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 step = kDifference * length * Vec3::Unit(axis);
    gradient[axis] = shapes_.of_cell(worst.cell.cell, x, worst.cell.at, step) -
                     shapes_.of_cell(worst.cell.cell, x, worst.cell.at, -step);
  }
  const double slope = gradient.norm();
  return slope > 0.0 ? Vec3((kPart * length / slope) * gradient) : Vec3(Vec3::Zero());
}

}  // namespace evenmesh
