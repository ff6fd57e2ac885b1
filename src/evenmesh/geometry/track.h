// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// A point of a track and the track's direction there.
struct TrackPoint {
  Vec3 position = Vec3::Zero();
  /// Curve: unit tangent. Surface: unit normal.
  Vec3 direction = Vec3::Zero();
  /// Which part of the track it lies on (a segment, a triangle); 0 where there is but one.
  std::uint32_t piece = 0;
};

/// A curve or surface that vertices slide on.
///
/// Solvers take a step along the tangent (or in the tangent plane) and bring the vertex back with
/// nearest(): a retraction. Implementations are const and safe to call from several threads.
class Track {
 public:
  virtual ~Track() = default;

  /// 1: a curve. 2: a surface.
  virtual int dimension() const = 0;

  /// The point of the track nearest to p among those that can be reached from `from` without
  /// leaving the ball around p through `from.position`: a vertex never jumps to another sheet, wall
  /// or turn of the track that merely comes near. Of equally near points always the same one.
  virtual TrackPoint nearest(const Vec3& p, const TrackPoint& from) const = 0;

  /// How the track bends: the second derivative of a path along it at unit speed in direction t,
  /// a vector normal to the track (1/radius for a circle). Zero where it is made of straight
  /// pieces.
  /// @param t  unit vector tangent to the track at the point
  virtual Vec3 curvature(const TrackPoint& point, const Vec3& t) const = 0;

  /// True if all that can be reached from a point of the track lies in the plane through it.
  /// @param normal  unit
  virtual bool lies_in_plane(const TrackPoint& point, const Vec3& normal) const = 0;

  /// True for a surface of triangles: what is minimised on it has kinks at their edges, at which
  /// methods that rely on second derivatives get stuck.
  virtual bool has_kinks() const { return false; }
};

}  // namespace evenmesh
