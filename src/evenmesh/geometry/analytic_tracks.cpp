// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/analytic_tracks.h"

#include <cassert>
#include <limits>

#include "evenmesh/geometry/perpendicular.h"

namespace evenmesh {
namespace {

constexpr double kParallel = 1e-9;  // sine of the angle below which directions are the same

Vec3 unit(const Vec3& v) {
  assert(!v.isZero(0.0));
  return v.stableNormalized();
}

/// The part of v that is perpendicular to a unit vector.
Vec3 across(const Vec3& v, const Vec3& axis) { return v - axis.dot(v) * axis; }

/// The unit vector from an axis to p; zero where p is on the axis up to rounding.
/// @param axis  a unit vector, or zero if the "axis" is the point alone
Vec3 away_from_axis(const Vec3& p, const Vec3& point, const Vec3& axis) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  const Vec3 radial = across(p - point, axis);
  const double size = p.lpNorm<Eigen::Infinity>() + point.lpNorm<Eigen::Infinity>();
  if (!(radial.lpNorm<Eigen::Infinity>() > kRounding * size)) return Vec3::Zero();
  // Once more, because what rounding leaves along the axis may be much of a small difference.
  return across(radial.stableNormalized(), axis).normalized();
}

/// The same, where it is zero that of `from`, and if that is on the axis too, some direction.
Vec3 outward(const Vec3& p, const TrackPoint& from, const Vec3& point, const Vec3& axis) {
  Vec3 result = away_from_axis(p, point, axis);
  if (result.isZero(0.0)) result = away_from_axis(from.position, point, axis);
  if (result.isZero(0.0)) result = axis.isZero(0.0) ? Vec3(Vec3::UnitX()) : perpendicular(axis);
  return result;
}

}  // namespace

LineTrack::LineTrack(const Vec3& point, const Vec3& direction)
    : point_(point), direction_(unit(direction)) {}

TrackPoint LineTrack::nearest(const Vec3& p, const TrackPoint& /*from*/) const {
  return {point_ + direction_.dot(p - point_) * direction_, direction_, 0};
}

Vec3 LineTrack::curvature(const TrackPoint& /*point*/, const Vec3& /*t*/) const {
  return Vec3::Zero();
}

PlaneTrack::PlaneTrack(const Vec3& point, const Vec3& normal)
    : point_(point), normal_(unit(normal)) {}

TrackPoint PlaneTrack::nearest(const Vec3& p, const TrackPoint& /*from*/) const {
  return {p - normal_.dot(p - point_) * normal_, normal_, 0};
}

Vec3 PlaneTrack::curvature(const TrackPoint& /*point*/, const Vec3& /*t*/) const {
  return Vec3::Zero();
}

CircleTrack::CircleTrack(const Vec3& centre, const Vec3& normal, double radius)
    : centre_(centre), normal_(unit(normal)), radius_(radius) {
  assert(radius > 0.0);
}

TrackPoint CircleTrack::nearest(const Vec3& p, const TrackPoint& from) const {
  const Vec3 radial = outward(p, from, centre_, normal_);
  return {centre_ + radius_ * radial, normal_.cross(radial).normalized(), 0};
}

Vec3 CircleTrack::curvature(const TrackPoint& point, const Vec3& /*t*/) const {
  return -outward(point.position, point, centre_, normal_) / radius_;
}

CylinderTrack::CylinderTrack(const Vec3& point, const Vec3& axis, double radius)
    : point_(point), axis_(unit(axis)), radius_(radius) {
  assert(radius > 0.0);
}

TrackPoint CylinderTrack::nearest(const Vec3& p, const TrackPoint& from) const {
  const Vec3 radial = outward(p, from, point_, axis_);
  const Vec3 foot = point_ + axis_.dot(p - point_) * axis_;
  return {foot + radius_ * radial, radial, 0};
}

Vec3 CylinderTrack::curvature(const TrackPoint& point, const Vec3& t) const {
  const Vec3 radial = outward(point.position, point, point_, axis_);
  const double around = axis_.cross(radial).dot(t);
  return -(around * around / radius_) * radial;
}

SphereTrack::SphereTrack(const Vec3& centre, double radius) : centre_(centre), radius_(radius) {
  assert(radius > 0.0);
}

TrackPoint SphereTrack::nearest(const Vec3& p, const TrackPoint& from) const {
  const Vec3 radial = outward(p, from, centre_, Vec3::Zero());
  return {centre_ + radius_ * radial, radial, 0};
}

Vec3 SphereTrack::curvature(const TrackPoint& point, const Vec3& /*t*/) const {
  return -outward(point.position, point, centre_, Vec3::Zero()) / radius_;
}

// ---- whole tracks in planes --------------------------------------------------------------------

bool LineTrack::lies_in_plane(const TrackPoint&, const Vec3& normal) const {
  return std::abs(direction_.dot(normal)) <= kParallel;
}

bool PlaneTrack::lies_in_plane(const TrackPoint&, const Vec3& normal) const {
  return normal_.cross(normal).norm() <= kParallel;
}

bool CircleTrack::lies_in_plane(const TrackPoint&, const Vec3& normal) const {
  return normal_.cross(normal).norm() <= kParallel;
}

}  // namespace evenmesh
