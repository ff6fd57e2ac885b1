// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/track.h"
#include "evenmesh/geometry/unit_scale.h"

namespace evenmesh {

/// A polyline: a run between two ends, which no vertex leaves, or a closed loop.
///
/// Pieces are its segments. A point where two segments meet belongs to the one with the lesser
/// number. Segments without length are passed over; their tangent is that of the next one that has
/// one. A polyline of no length at all has the tangent zero.
class CurveTrack final : public Track {
 public:
  enum class Shape : std::uint8_t { open, closed };

  /// @param points  in order along the curve, finite; a closed one does not repeat the first
  /// @pre  at least two points, fewer than 2^32
  explicit CurveTrack(std::vector<Vec3> points, Shape shape = Shape::open);

  int dimension() const override { return 1; }

  /// Walks along the curve both ways as long as the points between segments are in the ball. O(1)
  /// for steps as long as a segment.
  /// @pre  from lies on this track
  TrackPoint nearest(const Vec3& p, const TrackPoint& from) const override;
  Vec3 curvature(const TrackPoint& point, const Vec3& t) const override;
  /// O(points).
  bool lies_in_plane(const TrackPoint& point, const Vec3& normal) const override;

  std::size_t segments() const { return tangents_.size(); }
  bool is_closed() const { return tangents_.size() == points_.size(); }
  /// The k-th of the points given.
  TrackPoint at(std::size_t k) const;

 private:
  const Vec3& start(std::size_t segment) const { return points_[segment]; }
  const Vec3& end(std::size_t segment) const {
    return points_[segment + 1 == points_.size() ? 0 : segment + 1];
  }

  UnitScale scale_;
  std::vector<Vec3> points_;  // times scale_.to_unit
  std::vector<Vec3> tangents_;
};

}  // namespace evenmesh
