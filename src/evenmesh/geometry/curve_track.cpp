// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/curve_track.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "evenmesh/geometry/ball.h"
#include "evenmesh/geometry/closest_point.h"

namespace evenmesh {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Gives segments without length the tangent of the next one that has one, or of the last.
void fill_gaps(std::vector<Vec3>& tangents, bool closed) {
  const std::size_t n = tangents.size();
  Vec3 known = Vec3::Zero();
  for (std::size_t k = n; k-- > 0;) {
    if (tangents[k].isZero(0.0)) tangents[k] = known;
    known = tangents[k];
  }
  // What is left is at the end; beyond it comes the start of a closed curve.
  known = Vec3::Zero();
  for (Vec3& t : tangents) {
    if (t.isZero(0.0)) t = closed ? tangents[0] : known;
    known = t;
  }
}

}  // namespace

CurveTrack::CurveTrack(std::vector<Vec3> points, Shape shape)
    : scale_(unit_scale(points)), points_(std::move(points)) {
  assert(points_.size() >= 2);
  for (Vec3& p : points_) p *= scale_.to_unit;
  tangents_.resize(points_.size() - (shape == Shape::open ? 1 : 0));
  for (std::size_t k = 0; k < tangents_.size(); ++k) {
    tangents_[k] = (end(k) - start(k)).stableNormalized();
  }
  fill_gaps(tangents_, is_closed());
}

TrackPoint CurveTrack::at(std::size_t k) const {
  assert(k < points_.size());
  // The segment that ends there has the lesser number, except for a closed curve's first point.
  const std::size_t segment = k == 0 ? 0 : k - 1;
  return {scale_.from_unit * points_[k], tangents_[segment], static_cast<std::uint32_t>(segment)};
}

TrackPoint CurveTrack::nearest(const Vec3& p, const TrackPoint& from) const {
  assert(from.piece < segments());
  const Vec3 x = scale_.to_unit * p;
  const Ball ball(x, scale_.to_unit * from.position);
  ClosestPoint best;
  std::size_t piece = kNone;
  const auto consider = [&](std::size_t segment) {
    const ClosestPoint found = closest_on_segment(start(segment), end(segment), x);
    const bool nearer = piece == kNone || found.squared_distance < best.squared_distance ||
                        (found.squared_distance == best.squared_distance && segment < piece);
    if (!nearer) return;
    best = found;
    piece = segment;
  };
  const std::size_t n = segments();
  std::size_t k = from.piece;
  consider(k);
  std::size_t left = n - 1;  // segments not yet seen
  for (; left > 0 && ball.contains(end(k)); --left) {
    if (k + 1 == n && !is_closed()) break;
    k = k + 1 == n ? 0 : k + 1;
    consider(k);
  }
  k = from.piece;
  for (; left > 0 && ball.contains(start(k)); --left) {
    if (k == 0 && !is_closed()) break;
    k = k == 0 ? n - 1 : k - 1;
    consider(k);
  }
  return {scale_.from_unit * best.position, tangents_[piece], static_cast<std::uint32_t>(piece)};
}

Vec3 CurveTrack::curvature(const TrackPoint& /*point*/, const Vec3& /*t*/) const {
  return Vec3::Zero();
}

bool CurveTrack::lies_in_plane(const TrackPoint&, const Vec3& normal) const {
  double size = 0.0;
  double off = 0.0;
  for (const Vec3& p : points_) {
    const Vec3 d = p - points_[0];
    size = std::max(size, d.norm());
    off = std::max(off, std::abs(normal.dot(d)));
  }
  return off <= kFlatTolerance * size;
}

}  // namespace evenmesh
