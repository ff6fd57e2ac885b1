// SPDX-License-Identifier: MIT
#include "evenmesh/classic/optimal_delaunay.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace evenmesh {
namespace {

// A cell's size, and its circumcentre seen from one of its vertices times that size.
struct Weighted {
  double size = 0.0;
  Vec3 centre = Vec3::Zero();
};

// Of the triangle 0, a, b. About its own normal where no direction is up.
Weighted of_triangle(const Vec3& a, const Vec3& b, const Vec3& up) {
  const Vec3 normal = a.cross(b);
  const double length = normal.norm();
  if (length == 0.0) return {};
  const double sign = up.dot(normal) < 0.0 ? -1.0 : 1.0;
  const Vec3 across = a.squaredNorm() * b - b.squaredNorm() * a;
  return {sign * 0.5 * length, sign * 0.25 * across.cross(normal / length)};
}

// Of the tet 0, a, b, c.
Weighted of_tet(const Vec3& a, const Vec3& b, const Vec3& c, double sign) {
  const Vec3 centre =
      a.squaredNorm() * b.cross(c) + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b);
  return {sign * a.dot(b.cross(c)) / 6.0, sign * centre / 12.0};
}

}  // namespace

Vec3 OptimalDelaunay::move(const Star& star, Points x) const {
  const bool volume = orientation_.type == MeshType::volume;
  Weighted sum;
  for (const StarCell& around : star.cells) {
    const auto cell = mesh_.cells().vertices(around.cell);
    if (volume != (cell.size() == 4)) continue;  // the skin of a volume
    const std::size_t at =
        static_cast<std::size_t>(std::find(cell.begin(), cell.end(), around.at) - cell.begin());
    const auto edge = [&](std::size_t k) -> Vec3 { return x[cell[k]] - x[around.at]; };
    Weighted part;
    if (volume) {
      // Even permutations of 0 1 2 3, by where the vertex is.
      constexpr std::size_t kOthers[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
      const auto& others = kOthers[at];
      part =
          of_tet(edge(others[0]), edge(others[1]), edge(others[2]), orientation_.sign(around.cell));
    } else {
      part = of_triangle(edge((at + 1) % 3), edge((at + 2) % 3), orientation_.up(around.cell));
    }
    sum.size += part.size;
    sum.centre += part.centre;
  }
  return sum.size > 0.0 ? Vec3(sum.centre / sum.size) : Vec3(Vec3::Zero());
}

}  // namespace evenmesh
