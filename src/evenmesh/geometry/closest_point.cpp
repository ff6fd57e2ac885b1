// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/closest_point.h"

#include <algorithm>

namespace evenmesh {
namespace {

/// Sines below this are what rounding makes of a triangle without area.
constexpr double kLeastSine = 1e-12;

struct OnSegment {
  double t;
  double squared_distance;
};

OnSegment nearest_parameter(const Vec3& ab, const Vec3& ap) {
  const double length2 = ab.squaredNorm();
  const double along = ap.dot(ab);
  if (!(along > 0.0) || !(length2 > 0.0)) return {0.0, ap.squaredNorm()};
  if (along >= length2) return {1.0, (ap - ab).squaredNorm()};
  const double t = along / length2;
  return {t, (ap - t * ab).squaredNorm()};
}

Vec3 point_between(const Vec3& a, const Vec3& b, double t) {
  if (t <= 0.0) return a;
  if (t >= 1.0) return b;
  return a + t * (b - a);
}

}  // namespace

ClosestPoint closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const OnSegment found = nearest_parameter(b - a, p - a);
  return {point_between(a, b, found.t), {1.0 - found.t, found.t, 0.0}, found.squared_distance};
}

ClosestPoint closest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = p - a;
  const Vec3 normal = ab.cross(ac);
  const double area2 = normal.squaredNorm();
  const double sizes = ab.squaredNorm() * ac.squaredNorm();
  if (area2 > kLeastSine * kLeastSine * sizes) {
    const double v = normal.dot(ap.cross(ac)) / area2;
    const double w = normal.dot(ab.cross(ap)) / area2;
    const double u = 1.0 - v - w;
    if (u > 0.0 && v > 0.0 && w > 0.0) {
      const Vec3 offset = v * ab + w * ac;
      return {a + offset, {u, v, w}, (ap - offset).squaredNorm()};
    }
  }
  const OnSegment on_ab = nearest_parameter(ab, ap);
  const OnSegment on_bc = nearest_parameter(c - b, p - b);
  const OnSegment on_ca = nearest_parameter(a - c, p - c);
  if (on_ab.squared_distance <= std::min(on_bc.squared_distance, on_ca.squared_distance)) {
    return {point_between(a, b, on_ab.t), {1.0 - on_ab.t, on_ab.t, 0.0}, on_ab.squared_distance};
  }
  if (on_bc.squared_distance <= on_ca.squared_distance) {
    return {point_between(b, c, on_bc.t), {0.0, 1.0 - on_bc.t, on_bc.t}, on_bc.squared_distance};
  }
  return {point_between(c, a, on_ca.t), {on_ca.t, 0.0, 1.0 - on_ca.t}, on_ca.squared_distance};
}

}  // namespace evenmesh
