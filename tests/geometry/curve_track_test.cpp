// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/curve_track.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace evenmesh {
namespace {

std::vector<Vec3> helix(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i <= n; ++i) {
    const double t = 2.0 * std::numbers::pi * i / n;
    points.emplace_back(std::cos(t), std::sin(t), 0.3 * t);
  }
  return points;
}

double distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (a + t * ab - p).norm();
}

TEST(CurveTrack, FindsTheNearestPointWhereTheCurveIsSimple) {
  const std::vector<Vec3> points = helix(60);
  const CurveTrack track(points);
  shapes::Random random(1);
  for (int i = 0; i < 500; ++i) {
    const TrackPoint from = track.at(random.below(points.size()));
    const Vec3 p = from.position +
                   0.3 * Vec3(random.signed_unit(), random.signed_unit(), random.signed_unit());
    const TrackPoint found = track.nearest(p, from);
    double least = 1e9;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      least = std::min(least, distance_to_segment(points[k], points[k + 1], p));
    }
    EXPECT_NEAR((found.position - p).norm(), least, 1e-14);
    EXPECT_LE(distance_to_segment(points[found.piece], points[found.piece + 1], found.position),
              1e-15);
    EXPECT_EQ(found.direction, (points[found.piece + 1] - points[found.piece]).stableNormalized());
  }
}

TEST(CurveTrack, KeepsThePointsGivenToTheBit) {
  for (const double unit : {1e-140, 0.3, 1e140}) {
    std::vector<Vec3> points = helix(7);
    for (Vec3& p : points) p *= unit;
    const CurveTrack track(points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const TrackPoint at = track.at(k);
      EXPECT_EQ(at.position, points[k]);
      const TrackPoint again = track.nearest(points[k], at);
      EXPECT_EQ(again.position, points[k]);
      EXPECT_EQ(again.piece, at.piece);
      EXPECT_EQ(again.direction, at.direction);
    }
  }
}

TEST(CurveTrack, StopsAtItsEnds) {
  const CurveTrack track({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}});
  EXPECT_EQ(track.nearest({-5, 0, 0}, track.at(1)).position, Vec3(0, 0, 0));
  EXPECT_EQ(track.nearest({9, 9, 0}, track.at(0)).position, Vec3(2, 1, 0));
  EXPECT_FALSE(track.is_closed());
  EXPECT_EQ(track.segments(), 2u);
}

TEST(CurveTrack, GoesRoundAClosedLoop) {
  const CurveTrack square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, CurveTrack::Shape::closed);
  EXPECT_EQ(square.segments(), 4u);
  const TrackPoint found = square.nearest({-0.1, 0.25, 0}, square.at(0));
  EXPECT_EQ(found.position, Vec3(0, 0.25, 0));
  EXPECT_EQ(found.piece, 3u);
  EXPECT_EQ(found.direction, Vec3(0, -1, 0));
  EXPECT_EQ(square.nearest({0.75, -0.1, 0}, found).piece, 0u);
}

TEST(CurveTrack, DoesNotJumpAcrossAHairpin) {
  // Down one leg, a turn of width 0.1, up the other: a step to the side ends on the first leg.
  const CurveTrack track({{0, 5, 0}, {0, 2, 0}, {0, 0, 0}, {0.1, 0, 0}, {0.1, 2, 0}, {0.1, 5, 0}});
  const TrackPoint from = track.nearest({0, 1, 0}, track.at(1));
  const TrackPoint found = track.nearest({0.09, 1.2, 0}, from);
  EXPECT_EQ(found.position, Vec3(0, 1.2, 0));
  EXPECT_EQ(found.piece, 1u);
  // Near the turn, which is in the ball, the way round is open.
  EXPECT_EQ(track.nearest({0.2, 0.01, 0}, track.nearest({0, 0.05, 0}, track.at(2))).piece, 3u);
}

TEST(CurveTrack, DoesNotJumpBetweenSegmentsWhoseCommonPointIsFarAway) {
  // A needle: both its sides are in the ball, its point is not.
  const CurveTrack track({{0, 0, 0}, {100, 0.01, 0}, {0, 0.02, 0}});
  const TrackPoint from = track.nearest({50, 0, 0}, track.at(0));
  EXPECT_EQ(track.nearest({50.5, 1, 0}, from).piece, 0u);
}

TEST(CurveTrack, TakesTheLesserOfTwoSegmentsThatMeet) {
  const CurveTrack track({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  for (const std::size_t k : {0, 1, 2}) {
    const TrackPoint found = track.nearest({2, -1, 0}, track.at(k));
    EXPECT_EQ(found.position, Vec3(1, 0, 0));
    EXPECT_EQ(found.piece, 0u) << k;
    EXPECT_EQ(found.direction, Vec3(1, 0, 0));
  }
}

TEST(CurveTrack, PassesOverSegmentsWithoutLength) {
  const Vec3 a(0, 0, 0);
  const Vec3 b(1, 0, 0);
  const CurveTrack track({a, a, b, b, {2, 1, 0}, {2, 1, 0}});
  EXPECT_EQ(track.at(0).direction, Vec3(1, 0, 0));
  EXPECT_EQ(track.at(5).direction, Vec3(1, 1, 0).stableNormalized());
  EXPECT_EQ(track.nearest({1.5, 0.5, 0}, track.at(0)).position, Vec3(1.5, 0.5, 0));
  EXPECT_EQ(track.nearest({0.25, 0.1, 0}, track.at(5)).position, Vec3(0.25, 0, 0));
  const CurveTrack nothing({a, a}, CurveTrack::Shape::closed);
  EXPECT_EQ(nothing.nearest(b, nothing.at(1)).position, a);
  EXPECT_EQ(nothing.at(0).direction, Vec3::Zero());
  const CurveTrack loop({b, a, {0, 1, 0}, b}, CurveTrack::Shape::closed);
  EXPECT_EQ(loop.nearest(b, loop.at(3)).direction.norm(), 1.0);
}

TEST(CurveTrack, WalksALoopOfAThousandStepsWithoutJumping) {
  std::vector<Vec3> points = helix(40);
  points.pop_back();
  for (Vec3& p : points) p.z() = 0.2 * std::sin(3.0 * std::atan2(p.y(), p.x()));
  const CurveTrack track(points, CurveTrack::Shape::closed);
  shapes::Random random(2);
  TrackPoint at = track.at(0);
  double gone = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double step = 0.15 * (0.5 + random.signed_unit());
    const TrackPoint to = track.nearest(at.position + step * at.direction, at);
    EXPECT_LE((to.position - at.position).norm(), 2.0 * std::abs(step));
    gone += step;
    at = to;
  }
  EXPECT_GT(gone, 40.0);  // several times round
  EXPECT_NEAR(std::hypot(at.position.x(), at.position.y()), 1.0, 0.01);
}

}  // namespace
}  // namespace evenmesh
