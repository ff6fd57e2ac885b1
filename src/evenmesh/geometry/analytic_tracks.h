// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/track.h"

namespace evenmesh {

// Curves and surfaces with a formula. nearest() is the exact projection; the part of such a track
// within any ball is connected, so `from` decides only where many points are equally near: of the
// points of a circle, cylinder or sphere around its centre or axis, the one on the side of `from`.
// Any unit of length will do. Directions need not be unit vectors; those given back are.

/// The straight line through a point, without ends.
class LineTrack final : public Track {
 public:
  /// @pre  direction is not zero
  LineTrack(const Vec3& point, const Vec3& direction);

  int dimension() const override { return 1; }
  TrackPoint nearest(const Vec3& p, const TrackPoint& from) const override;
  Vec3 curvature(const TrackPoint& point, const Vec3& t) const override;
  bool lies_in_plane(const TrackPoint& point, const Vec3& normal) const override;

  const Vec3& point() const { return point_; }
  const Vec3& direction() const { return direction_; }

 private:
  Vec3 point_;
  Vec3 direction_;
};

/// The plane through a point.
class PlaneTrack final : public Track {
 public:
  /// @pre  normal is not zero
  PlaneTrack(const Vec3& point, const Vec3& normal);

  int dimension() const override { return 2; }
  TrackPoint nearest(const Vec3& p, const TrackPoint& from) const override;
  Vec3 curvature(const TrackPoint& point, const Vec3& t) const override;
  bool lies_in_plane(const TrackPoint& point, const Vec3& normal) const override;

  const Vec3& point() const { return point_; }
  const Vec3& normal() const { return normal_; }

 private:
  Vec3 point_;
  Vec3 normal_;
};

/// A circle; its tangent is counter-clockwise seen from the tip of the normal.
class CircleTrack final : public Track {
 public:
  /// @pre  normal is not zero, radius > 0
  CircleTrack(const Vec3& centre, const Vec3& normal, double radius);

  int dimension() const override { return 1; }
  TrackPoint nearest(const Vec3& p, const TrackPoint& from) const override;
  Vec3 curvature(const TrackPoint& point, const Vec3& t) const override;
  bool lies_in_plane(const TrackPoint& point, const Vec3& normal) const override;

  const Vec3& centre() const { return centre_; }
  const Vec3& normal() const { return normal_; }
  double radius() const { return radius_; }

 private:
  Vec3 centre_;
  Vec3 normal_;
  double radius_;
};

/// A circular cylinder without ends; its normal points outward.
class CylinderTrack final : public Track {
 public:
  /// @param point  on the axis
  /// @pre  axis is not zero, radius > 0
  CylinderTrack(const Vec3& point, const Vec3& axis, double radius);

  int dimension() const override { return 2; }
  TrackPoint nearest(const Vec3& p, const TrackPoint& from) const override;
  Vec3 curvature(const TrackPoint& point, const Vec3& t) const override;
  bool lies_in_plane(const TrackPoint&, const Vec3&) const override { return false; }

  const Vec3& point() const { return point_; }
  const Vec3& axis() const { return axis_; }
  double radius() const { return radius_; }

 private:
  Vec3 point_;
  Vec3 axis_;
  double radius_;
};

/// A sphere; its normal points outward.
class SphereTrack final : public Track {
 public:
  /// @pre  radius > 0
  SphereTrack(const Vec3& centre, double radius);

  int dimension() const override { return 2; }
  TrackPoint nearest(const Vec3& p, const TrackPoint& from) const override;
  Vec3 curvature(const TrackPoint& point, const Vec3& t) const override;
  bool lies_in_plane(const TrackPoint&, const Vec3&) const override { return false; }

  const Vec3& centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  Vec3 centre_;
  double radius_;
};

}  // namespace evenmesh
