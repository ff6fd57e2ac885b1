// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/analytic_tracks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace evenmesh {
namespace {

Vec3 random_vec(shapes::Random& random) {
  return {random.signed_unit(), random.signed_unit(), random.signed_unit()};
}

struct Case {
  std::string name;
  std::shared_ptr<const Track> track;
  std::function<double(const Vec3&)> distance;  // of a point from the track
};

/// Every track, its size and place in some unit of length.
std::vector<Case> cases(const Vec3& centre, double r) {
  const Vec3 axis = Vec3(1.0, -2.0, 0.5).normalized();
  const auto across = [=](const Vec3& p) -> Vec3 {
    const Vec3 d = p - centre;
    return d - d.dot(axis) * axis;
  };
  return {
      {"line", std::make_shared<LineTrack>(centre, 3.0 * axis),
       [=](const Vec3& p) { return across(p).stableNorm(); }},
      {"plane", std::make_shared<PlaneTrack>(centre, 0.1 * axis),
       [=](const Vec3& p) { return std::abs((p - centre).dot(axis)); }},
      {"circle", std::make_shared<CircleTrack>(centre, 7.0 * axis, r),
       [=](const Vec3& p) {
         return std::hypot(across(p).stableNorm() - r, (p - centre).dot(axis));
       }},
      {"cylinder", std::make_shared<CylinderTrack>(centre, axis, r),
       [=](const Vec3& p) { return std::abs(across(p).stableNorm() - r); }},
      {"sphere", std::make_shared<SphereTrack>(centre, r),
       [=](const Vec3& p) { return std::abs((p - centre).stableNorm() - r); }},
  };
}

TEST(AnalyticTracks, PutPointsOnThemselvesWhateverTheUnit) {
  for (const double unit : {1e-150, 1e-6, 1.0, 1e6, 1e150}) {
    for (const double offset : {0.0, 1.0, 1e6}) {
      shapes::Random random(3);
      for (const Case& c : cases(offset * unit * Vec3(1, -1, 0.3), unit)) {
        for (int i = 0; i < 200; ++i) {
          const Vec3 p = unit * (offset * Vec3(1, -1, 0.3) + 3.0 * random_vec(random));
          const TrackPoint found = c.track->nearest(p, {});
          const double size = unit * std::max(1.0, offset);
          EXPECT_LE(c.distance(found.position), 1e-14 * size) << c.name << unit << " " << offset;
          EXPECT_NEAR(found.direction.norm(), 1.0, 1e-14) << c.name;
          EXPECT_EQ(found.piece, 0u);
        }
      }
    }
  }
}

TEST(AnalyticTracks, ProjectAlongTheirNormals) {
  // The nearest point is the one from which p lies straight above; and it is as far as it must be.
  shapes::Random random(5);
  for (const Case& c : cases({0.2, 0.1, -0.4}, 0.8)) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = 2.0 * random_vec(random);
      const TrackPoint found = c.track->nearest(p, {});
      const Vec3 away = p - found.position;
      EXPECT_NEAR(away.norm(), c.distance(p), 1e-14) << c.name;
      const double off = c.track->dimension() == 1 ? away.dot(found.direction)
                                                   : away.cross(found.direction).norm();
      EXPECT_NEAR(off, 0.0, 1e-14) << c.name;
    }
  }
}

TEST(AnalyticTracks, KeepDigitsWhereThePointIsFarAboveTheCircle) {
  const CircleTrack circle({0, 0, 0}, {1, 2, 3}, 1.0);
  const Vec3 n = Vec3(1, 2, 3).normalized();
  const Vec3 in_plane = n.cross(Vec3::UnitX()).normalized();
  const TrackPoint found = circle.nearest(1e6 * n + 1e-3 * in_plane, {});
  EXPECT_NEAR(found.position.dot(n), 0.0, 1e-15);
  EXPECT_NEAR(found.position.norm(), 1.0, 1e-15);
}

TEST(AnalyticTracks, GoToTheSideOfFromWhereAllIsEquallyNear) {
  const Vec3 centre(1e6, 2, -3);
  const CircleTrack circle(centre, {0, 0, 1}, 2.0);
  const CylinderTrack cylinder(centre, {0, 0, 1}, 2.0);
  const SphereTrack sphere(centre, 2.0);
  const TrackPoint from{centre + Vec3(0, -2, 0), {}, 0};
  EXPECT_EQ(circle.nearest(centre, from).position, from.position);
  EXPECT_EQ(circle.nearest(centre + Vec3(0, 0, 5), from).position, from.position);
  EXPECT_EQ(cylinder.nearest(centre + Vec3(0, 0, 5), from).position, from.position + Vec3(0, 0, 5));
  EXPECT_EQ(sphere.nearest(centre, from).position, from.position);
  // Even from the centre there is a point.
  for (const Track* track : {static_cast<const Track*>(&circle), static_cast<const Track*>(&sphere),
                             static_cast<const Track*>(&cylinder)}) {
    const Vec3 p = track->nearest(centre, {centre, {}, 0}).position;
    EXPECT_NEAR((p - centre).norm(), 2.0, 1e-9);
  }
}

TEST(AnalyticTracks, BendAsFiniteDifferencesSay) {
  // x(s) = nearest(x + s t) has the second derivative of a geodesic's, up to a tangential part.
  shapes::Random random(7);
  for (const Case& c : cases({0.2, 0.1, -0.4}, 0.8)) {
    for (int i = 0; i < 20; ++i) {
      const TrackPoint at = c.track->nearest(2.0 * random_vec(random), {});
      Vec3 t = at.direction;
      if (c.track->dimension() == 2) t = t.cross(random_vec(random)).normalized();
      const double h = 1e-4;
      const Vec3 forth = c.track->nearest(at.position + h * t, at).position;
      const Vec3 back = c.track->nearest(at.position - h * t, at).position;
      const Vec3 second = ((forth - at.position) - (at.position - back)) / (h * h);
      const Vec3 bend = c.track->curvature(at, t);
      EXPECT_LE((second - bend).norm(), 1e-6) << c.name;
      EXPECT_NEAR(bend.dot(t), 0.0, 1e-14) << c.name;
    }
  }
}

TEST(AnalyticTracks, BendTowardsTheirCentresByOneOverTheRadius) {
  const TrackPoint at{{0, 4, 0}, {0, 1, 0}, 0};
  EXPECT_EQ(SphereTrack({0, 0, 0}, 4.0).curvature(at, {1, 0, 0}), Vec3(0, -0.25, 0));
  const CylinderTrack cylinder({0, 0, 9}, {0, 0, 1}, 4.0);
  EXPECT_EQ(cylinder.curvature(at, {1, 0, 0}), Vec3(0, -0.25, 0));
  EXPECT_EQ(cylinder.curvature(at, {0, 0, 1}), Vec3::Zero());
  EXPECT_NEAR(cylinder.curvature(at, {std::sqrt(0.5), 0, std::sqrt(0.5)}).y(), -0.125, 1e-15);
  EXPECT_EQ(CircleTrack({0, 0, 0}, {0, 0, 1}, 4.0).curvature(at, {1, 0, 0}), Vec3(0, -0.25, 0));
}

TEST(AnalyticTracks, TurnACircleCounterClockwiseAboutItsNormal) {
  EXPECT_EQ(CircleTrack({0, 0, 0}, {0, 0, 2}, 1.0).nearest({5, 0, 1}, {}).direction, Vec3(0, 1, 0));
}

}  // namespace
}  // namespace evenmesh
