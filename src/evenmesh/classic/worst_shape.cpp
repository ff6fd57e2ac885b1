// SPDX-License-Identifier: MIT
#include "evenmesh/classic/worst_shape.h"

#include <vector>

#include "evenmesh/quality/metric.h"

namespace evenmesh {

double WorstShape::of_cell(std::uint32_t cell, Points x, Index vertex, const Vec3& by) const {
  std::vector<Vec3> corners;
  for (const Index v : mesh_.cells().vertices(cell)) {
    corners.push_back(v == vertex ? Vec3(x[v] + by) : x[v]);
  }
  return measure(Metric::shape, mesh_.cells().kind(cell), corners, orientation_.up(cell),
                 orientation_.sign(cell));
}

WorstShape::Found WorstShape::of(const Star& star, Points x) const {
  Found worst;
  for (const StarCell& around : star.cells) {
    const double shape = of_cell(around.cell, x);
    if (shape < worst.shape) worst = {shape, around};
  }
  return worst;
}

}  // namespace evenmesh
