// SPDX-License-Identifier: MIT
#include "evenmesh/quality/volume_cell.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "evenmesh/geometry/unit_size.h"

namespace evenmesh {
namespace {

// See surface_cell.cpp; the highest power here is the sixth of a length.
constexpr double kSmallSum = 1e-80;
constexpr double kLargeSum = 1e80;

double determinant(const VolumeCell::Corner& corner) {
  return corner.a.dot(corner.b.cross(corner.c));
}

VolumeCell::Corner hex_axes(std::span<const Vec3> p) {
  VolumeCell::Corner axes;
  axes.a = (p[1] - p[0]) + (p[2] - p[3]) + (p[5] - p[4]) + (p[6] - p[7]);
  axes.b = (p[3] - p[0]) + (p[2] - p[1]) + (p[7] - p[4]) + (p[6] - p[5]);
  axes.c = (p[4] - p[0]) + (p[5] - p[1]) + (p[6] - p[2]) + (p[7] - p[3]);
  return axes;
}

}  // namespace

void VolumeCell::set(CellKind kind, std::span<const Vec3> points, double sign) {
  assert(traits(kind).dimension == 3);
  assert(points.size() == static_cast<std::size_t>(traits(kind).vertices));
  kind_ = kind;
  sign_ = sign;
  if (!try_set(points)) try_set(unit_sized(points));  // at worst all zero: collapsed
}

bool VolumeCell::try_set(std::span<const Vec3> points) {
  const auto table = traits(kind_).corners;
  count_ = table.size();
  point_count_ = points.size();
  for (std::size_t i = 0; i < point_count_; ++i) points_[i] = points[i] - points[0];
  double sum = 0.0;
  double most = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count_; ++i) {
    const Vec3& v = points[table[i].vertex];
    Corner& corner = corners_[i];
    corner.a = points[table[i].neighbours[0]] - v;
    corner.b = points[table[i].neighbours[1]] - v;
    corner.c = points[table[i].neighbours[2]] - v;
    corner.determinant = sign_ * determinant(corner);
    for (const Vec3* edge : {&corner.a, &corner.b, &corner.c}) {
      const double squared_length = edge->squaredNorm();
      sum += squared_length;
      most = std::max(most, squared_length);
      least = std::min(least, squared_length);
    }
  }
  longest_ = std::sqrt(most);
  shortest_ = std::sqrt(least);
  if (kind_ == CellKind::hex) {
    axes_ = hex_axes(points);
    axes_.determinant = sign_ * determinant(axes_);
  }
  return sum > kSmallSum && sum < kLargeSum;  // false for NaN
}

}  // namespace evenmesh
