// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/extent.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

namespace evenmesh {

Extent extent_of(Points points, std::span<const Index> vertices) {
  if (vertices.empty()) return {};
  Extent extent{points[vertices[0]], points[vertices[0]]};
  for (const Index v : vertices) {
    extent.low = extent.low.cwiseMin(points[v]);
    extent.high = extent.high.cwiseMax(points[v]);
  }
  return extent;
}

Vec3 doubled_area(Points points, std::span<const Index> vertices, double unit) {
  // Differences first: far from the origin the products would drown them. Halves, because a
  // difference of two large coordinates may overflow.
  const Vec3 origin = points[vertices[0]] / 2.0;
  const double half_unit = unit / 2.0;
  Vec3 sum = Vec3::Zero();
  Vec3 previous = (points[vertices[1]] / 2.0 - origin) / half_unit;
  for (std::size_t i = 2; i < vertices.size(); ++i) {
    const Vec3 current = (points[vertices[i]] / 2.0 - origin) / half_unit;
    sum += previous.cross(current);
    previous = current;
  }
  return sum;
}

Vec3 unit_normal(Points points, std::span<const Index> vertices) {
  const double half = extent_of(points, vertices).half();
  if (!(half > 0.0)) return Vec3::Zero();
  const Vec3 area = doubled_area(points, vertices, half);
  const double length = area.norm();
  // In this unit coordinates are about 1, so less than that is what rounding leaves of nothing.
  constexpr double kNothing = 1e-15;
  return length > kNothing ? Vec3(area / length) : Vec3(Vec3::Zero());
}

double volume(CellKind kind, Points points, std::span<const Index> vertices, double unit) {
  const Vec3 origin = points[vertices[0]] / 2.0;
  const double half_unit = unit / 2.0;
  std::array<Vec3, 8> x;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    x[i] = (points[vertices[i]] / 2.0 - origin) / half_unit;
  }
  const auto triangle = [&](int a, int b, int c) {
    return x[static_cast<std::size_t>(a)].dot(
        x[static_cast<std::size_t>(b)].cross(x[static_cast<std::size_t>(c)]));
  };
  double sixfold = 0.0;
  for (const CellTraits::Face& face : traits(kind).faces) {
    const auto [a, b, c, d] = face.vertices;
    if (face.count == 3) {
      sixfold += triangle(a, b, c);
    } else {
      sixfold +=
          0.5 * (triangle(a, b, c) + triangle(a, c, d) + triangle(a, b, d) + triangle(b, c, d));
    }
  }
  return sixfold / 6.0;
}

}  // namespace evenmesh
