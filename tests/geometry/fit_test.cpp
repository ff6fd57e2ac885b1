// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/fit.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "evenmesh/geometry/perpendicular.h"
#include "tests/support/random.h"

namespace evenmesh {
namespace {

constexpr double kTight = 1e-12;

Vec3 random_vec(shapes::Random& random) {
  return {random.signed_unit(), random.signed_unit(), random.signed_unit()};
}

/// Where to put a track, and how large.
struct Setting {
  Vec3 centre;
  Vec3 axis;
  double radius;

  /// What rounding of the coordinates may leave of a length.
  double allowed() const { return kTight * (radius + centre.norm()); }
  Vec3 on_cylinder(double angle, double along) const {
    const Vec3 u = perpendicular(axis);
    const Vec3 v = axis.cross(u);
    return centre + radius * (std::cos(angle) * u + std::sin(angle) * v + along * axis);
  }
};

std::vector<Setting> settings() {
  std::vector<Setting> result;
  const Vec3 axis = Vec3(1, -2, 0.5).normalized();
  for (const double unit : {1e-120, 1e-3, 1.0, 1e120}) {
    for (const double offset : {0.0, 10.0, 1e6}) {
      result.push_back({offset * unit * Vec3(1, 0.5, -1), axis, 0.7 * unit});
    }
  }
  return result;
}

/// Of two unit vectors of any sign.
double angle_between(const Vec3& a, const Vec3& b) { return a.cross(b).norm(); }

TEST(Fit, FindsTheLineOfPointsOnIt) {
  for (const Setting& s : settings()) {
    std::vector<Vec3> points;
    for (const double t : {-2.0, 0.5, 1.0, 3.0}) points.push_back(s.centre + t * s.radius * s.axis);
    const auto fit = fit_line(points);
    ASSERT_TRUE(fit);
    EXPECT_LE(fit->greatest_distance, s.allowed());
    EXPECT_LE(angle_between(fit->track.direction(), s.axis), s.allowed() / s.radius);
  }
}

TEST(Fit, FindsThePlaneOfPointsInIt) {
  for (const Setting& s : settings()) {
    std::vector<Vec3> points;
    for (const double t : {0.1, 0.2, 2.0, 4.0}) points.push_back(s.on_cylinder(t, 0.0));
    points.push_back(s.centre);
    const auto fit = fit_plane(points);
    ASSERT_TRUE(fit);
    EXPECT_LE(fit->greatest_distance, s.allowed());
    EXPECT_LE(angle_between(fit->track.normal(), s.axis), s.allowed() / s.radius);
  }
}

TEST(Fit, FindsTheCircleOfPointsOnIt) {
  for (const Setting& s : settings()) {
    for (const double arc : {6.0, 2.0}) {
      std::vector<Vec3> points;
      for (int i = 0; i < 20; ++i) points.push_back(s.on_cylinder(arc * i / 20.0, 0.0));
      const auto fit = fit_circle(points);
      ASSERT_TRUE(fit);
      EXPECT_LE(fit->greatest_distance, s.allowed());
      EXPECT_LE((fit->track.centre() - s.centre).stableNorm(), s.allowed());
      EXPECT_NEAR(fit->track.radius(), s.radius, s.allowed());
      EXPECT_LE(angle_between(fit->track.normal(), s.axis), s.allowed() / s.radius);
    }
  }
}

TEST(Fit, FindsTheSphereOfPointsOnIt) {
  for (const Setting& s : settings()) {
    for (const bool cap : {false, true}) {
      shapes::Random random(1);
      std::vector<Vec3> points;
      for (int i = 0; i < 30; ++i) {
        Vec3 out = random_vec(random);
        if (cap) out += Vec3(2, 0, 0);
        points.push_back(s.centre + s.radius * out.normalized());
      }
      const auto fit = fit_sphere(points);
      ASSERT_TRUE(fit);
      EXPECT_LE(fit->greatest_distance, s.allowed());
      EXPECT_LE((fit->track.centre() - s.centre).stableNorm(), 10.0 * s.allowed());
      EXPECT_NEAR(fit->track.radius(), s.radius, 10.0 * s.allowed());
    }
  }
}

TEST(Fit, FindsTheCylinderOfPointsOnIt) {
  for (const Setting& s : settings()) {
    // Long and short, whole and half.
    for (const double length : {0.5, 2.0, 20.0}) {
      for (const double arc : {6.28, 3.0}) {
        shapes::Random random(2);
        std::vector<Vec3> points;
        for (int i = 0; i < 60; ++i) {
          points.push_back(
              s.on_cylinder(arc * random.signed_unit() / 2.0, length * random.signed_unit() / 2.0));
        }
        const auto fit = fit_cylinder(points);
        ASSERT_TRUE(fit);
        EXPECT_LE(fit->greatest_distance, s.allowed()) << length << " " << arc;
        EXPECT_NEAR(fit->track.radius(), s.radius, 20.0 * s.allowed());
        EXPECT_LE(angle_between(fit->track.axis(), s.axis), 20.0 * s.allowed() / s.radius);
        const Vec3 d = fit->track.point() - s.centre;
        EXPECT_LE((d - d.dot(s.axis) * s.axis).stableNorm(), 20.0 * s.allowed());
      }
    }
  }
}

TEST(Fit, TakesANarrowCylindersAxisFromItsNormals) {
  const Setting s{{1, 2, 3}, Vec3(1, -2, 0.5).normalized(), 1.0};
  shapes::Random random(3);
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.2 * random.signed_unit();
    points.push_back(s.on_cylinder(angle, 0.3 * random.signed_unit()));
    normals.push_back(s.on_cylinder(angle, 0.0) - s.centre);
    if (i % 2 == 0) normals.back() *= -1.0;
  }
  const auto fit = fit_cylinder(points, normals);
  ASSERT_TRUE(fit);
  EXPECT_LE(angle_between(fit->track.axis(), s.axis), 1e-10);
  EXPECT_NEAR(fit->track.radius(), 1.0, 1e-10);
}

/// The sum of squares of the distances from a track.
template <class FittedTrack>
double squares(const FittedTrack& track, const std::vector<Vec3>& points) {
  double sum = 0.0;
  for (const Vec3& p : points) sum += (track.nearest(p, {}).position - p).squaredNorm();
  return sum;
}

TEST(Fit, IsALeastSquaresOneForNoisyPoints) {
  const Setting s{{1, 2, 3}, Vec3(1, -2, 0.5).normalized(), 1.0};
  shapes::Random random(4);
  std::vector<Vec3> round;
  std::vector<Vec3> ball;
  std::vector<Vec3> flat;
  for (int i = 0; i < 200; ++i) {
    const Vec3 noise = 0.05 * random_vec(random);
    round.push_back(s.on_cylinder(3.0 * random.signed_unit(), random.signed_unit()) + noise);
    ball.push_back(s.centre + random_vec(random).normalized() + noise);
    flat.push_back(s.on_cylinder(3.0 * random.signed_unit(), 0.0) + noise);
  }
  const auto cylinder = fit_cylinder(round);
  const auto sphere = fit_sphere(ball);
  const auto plane = fit_plane(flat);
  const auto line = fit_line(round);
  ASSERT_TRUE(cylinder && sphere && plane && line);
  EXPECT_LT(cylinder->greatest_distance, 0.1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 d = 1e-3 * random_vec(random);
    const Vec3 e = 1e-3 * random_vec(random);
    const CylinderTrack& c = cylinder->track;
    EXPECT_LT(squares(c, round),
              squares(CylinderTrack(c.point() + d, c.axis() + e, c.radius() + d.x()), round));
    const SphereTrack& b = sphere->track;
    EXPECT_LT(squares(b, ball), squares(SphereTrack(b.centre() + d, b.radius() + e.x()), ball));
    const PlaneTrack& p = plane->track;
    EXPECT_LT(squares(p, flat), squares(PlaneTrack(p.point() + d, p.normal() + e), flat));
    const LineTrack& l = line->track;
    EXPECT_LT(squares(l, round), squares(LineTrack(l.point() + d, l.direction() + e), round));
  }
  // The circle is the best in its plane.
  const auto circle = fit_circle(flat);
  ASSERT_TRUE(circle);
  const Vec3 n = circle->track.normal();
  EXPECT_LE(angle_between(n, plane->track.normal()), 1e-12);
  for (int i = 0; i < 100; ++i) {
    const Vec3 d = 1e-3 * n.cross(random_vec(random));
    EXPECT_LT(squares(circle->track, flat),
              squares(CircleTrack(circle->track.centre() + d, n,
                                  circle->track.radius() + 1e-3 * random.signed_unit()),
                      flat));
  }
}

TEST(Fit, SaysHowFarTheFarthestPointIs) {
  const std::vector<Vec3> points{{0, 0, 1}, {1, 0, -1}, {1, 1, 1}, {0, 1, -1}};
  EXPECT_NEAR(fit_plane(std::vector<Vec3>{{0, 0, 0.1}, {9, 0, -0.1}, {9, 9, 0.1}, {0, 9, -0.1}})
                  ->greatest_distance,
              0.1, 1e-15);
  EXPECT_NEAR(fit_circle(std::vector<Vec3>{{5, 0, 0.1}, {0, 5, -0.1}, {-5, 0, 0.1}, {0, -5, -0.1}})
                  ->greatest_distance,
              0.1, 1e-14);
  EXPECT_LE(fit_sphere(points)->greatest_distance, 1e-14);  // four points always lie on one
}

TEST(Fit, GivesNothingWherePointsDoNotSay) {
  const Vec3 a(1, 2, 3);
  const Vec3 b(4, 6, 9);
  const auto along = [&](double t) -> Vec3 { return a + t * (b - a); };
  const std::vector<Vec3> same(20, a);
  const std::vector<Vec3> collinear{a,           b,          along(0.3), along(0.9),
                                    along(-4.7), along(7.1), along(2.0)};
  std::vector<Vec3> planar;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) planar.push_back(a + i * Vec3(1, 0, 0.3) + j * Vec3(0.1, 1, 0.7));
  }
  for (const std::vector<Vec3>& points : {std::vector<Vec3>{}, std::vector<Vec3>{a}, same}) {
    EXPECT_FALSE(fit_line(points));
    EXPECT_FALSE(fit_plane(points));
    EXPECT_FALSE(fit_circle(points));
    EXPECT_FALSE(fit_sphere(points));
    EXPECT_FALSE(fit_cylinder(points));
  }
  EXPECT_TRUE(fit_line(std::vector<Vec3>{a, b}));
  EXPECT_FALSE(fit_plane(std::vector<Vec3>{a, b}));
  EXPECT_FALSE(fit_plane(std::vector<Vec3>{a, b, b, a}));
  EXPECT_FALSE(fit_circle(std::vector<Vec3>{a, b}));
  EXPECT_TRUE(fit_circle(std::vector<Vec3>{a, b, {0, 0, 1}}));
  EXPECT_FALSE(fit_sphere(std::vector<Vec3>{a, b, {0, 0, 1}}));
  for (const double far : {0.0, 1e6}) {
    std::vector<Vec3> moved = collinear;
    for (Vec3& p : moved) p += Vec3::Constant(far);
    EXPECT_TRUE(fit_line(moved));
    EXPECT_FALSE(fit_plane(moved)) << far;
    EXPECT_FALSE(fit_circle(moved)) << far;
    EXPECT_FALSE(fit_sphere(moved)) << far;
    EXPECT_FALSE(fit_cylinder(moved)) << far;
    moved = planar;
    for (Vec3& p : moved) p += Vec3::Constant(far);
    EXPECT_TRUE(fit_plane(moved)) << far;
    EXPECT_FALSE(fit_sphere(moved)) << far;
    EXPECT_FALSE(fit_cylinder(moved)) << far;
  }
}

TEST(Fit, GivesNoLineThroughACubeAndNoPlaneEither) {
  std::vector<Vec3> cube;
  for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  EXPECT_FALSE(fit_line(cube));
  EXPECT_FALSE(fit_plane(cube));
  EXPECT_NEAR(fit_sphere(cube)->track.radius(), std::sqrt(0.75), 1e-14);
  EXPECT_LE(fit_cylinder(cube)->greatest_distance, 1e-14);
}

}  // namespace
}  // namespace evenmesh
