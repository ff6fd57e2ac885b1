// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/motion.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "evenmesh/geometry/analytic_tracks.h"
#include "evenmesh/geometry/curve_track.h"
#include "evenmesh/geometry/surface_track.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using Freedom = Motion::Freedom;

Motion motion_of(const Mesh& mesh, std::vector<char> fixed = {}) {
  fixed.resize(mesh.point_count(), 0);
  return Motion(mesh, find_orientation(mesh), fixed);
}

TEST(Motion, IsInThePlaneOfAPlanarMesh) {
  const Mesh mesh = shapes::rotated(shapes::triangle_grid(3), Vec3(1, 2, 3), 0.7);
  const Orientation orientation = find_orientation(mesh);
  const Motion motion = motion_of(mesh);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    EXPECT_EQ(motion.freedom(v), Freedom::plane);
    EXPECT_EQ(motion.normal(v), orientation.normal);
  }
  EXPECT_EQ(motion.moving(), mesh.point_count());
}

TEST(Motion, IsFreeInAVolume) {
  const Mesh mesh = shapes::hex_grid(2);
  const Motion motion = motion_of(mesh);
  EXPECT_EQ(motion.freedom(13), Freedom::free);
  EXPECT_EQ(motion.project(13, Vec3(1, 2, 3)), Vec3(1, 2, 3));
  EXPECT_TRUE(motion.normal(13).isZero(0.0));
}

TEST(Motion, IsNotForFixedVertices) {
  const Mesh mesh = shapes::quad_grid(2);
  Motion motion = motion_of(mesh, {1, 0, 1});
  EXPECT_EQ(motion.freedom(0), Freedom::fixed);
  EXPECT_EQ(motion.freedom(1), Freedom::plane);
  EXPECT_EQ(motion.moving(), mesh.point_count() - 2);
  EXPECT_EQ(motion.project(0, Vec3(1, 2, 3)), Vec3(Vec3::Zero()));
  motion.fix(1);
  EXPECT_EQ(motion.freedom(1), Freedom::fixed);
  EXPECT_EQ(motion.project(1, Vec3(1, 2, 3)), Vec3(Vec3::Zero()));
}

TEST(Motion, IsNotForVerticesThatNoCellUses) {
  const Mesh grid = shapes::quad_grid(2);
  std::vector<Vec3> points(grid.points().begin(), grid.points().end());
  points.emplace_back(3, 3, 0);
  const Motion motion = motion_of(Mesh(points, grid.cells()));
  EXPECT_EQ(motion.freedom(static_cast<Index>(points.size() - 1)), Freedom::fixed);
}

TEST(Motion, IsTangentToASphere) {
  const Mesh mesh = shapes::sphere_triangles(3);
  const Motion motion = motion_of(mesh);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    EXPECT_EQ(motion.freedom(v), Freedom::plane);
    EXPECT_GE(std::abs(motion.normal(v).dot(mesh.points()[v])), 0.995);  // 6 degrees
    EXPECT_NEAR(motion.normal(v).norm(), 1.0, 1e-15);
  }
}

TEST(Motion, DoesNotDependOnHowCellsAreWound) {
  const Mesh sphere = shapes::sphere_triangles(2);
  const Motion straight = motion_of(sphere);
  const Motion mixed =
      motion_of(shapes::reversed(sphere, [](std::size_t cell) { return cell % 2 == 0; }));
  for (Index v = 0; v < sphere.point_count(); ++v) {
    EXPECT_NEAR(std::abs(straight.normal(v).dot(mixed.normal(v))), 1.0, 1e-14);
  }
}

TEST(Motion, IsNotWhereTheSurfaceHasNoArea) {
  // A needle on a tent: vertices 5 and 6 belong to a triangle without area only.
  Cells cells;
  cells.add(CellKind::triangle, std::vector<Index>{0, 1, 2});
  cells.add(CellKind::triangle, std::vector<Index>{0, 2, 3});
  cells.add(CellKind::triangle, std::vector<Index>{4, 5, 6});
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}, {2, 0, 0}, {2, 0, 1}, {2, 0, 2}},
                  std::move(cells));
  const Motion motion = motion_of(mesh);
  EXPECT_EQ(motion.freedom(0), Freedom::plane);
  for (const Index v : {4, 5, 6}) EXPECT_EQ(motion.freedom(v), Freedom::fixed);
}

TEST(Motion, HasTheSameNormalsInAnyUnitOfLength) {
  const Mesh sphere = shapes::sphere_triangles(1);
  const Motion motion = motion_of(sphere);
  for (const double scale : {1e-300, 1e-160, 1e-90, 1e90, 1e160, 1e300}) {
    const Motion scaled = motion_of(shapes::scaled(sphere, scale));
    for (Index v = 0; v < sphere.point_count(); ++v) {
      ASSERT_EQ(scaled.freedom(v), Freedom::plane) << scale;
      EXPECT_NEAR(std::abs(scaled.normal(v).dot(motion.normal(v))), 1.0, 1e-12) << scale;
    }
  }
}

TEST(Motion, ProjectsOntoThePlaneAndNoFurther) {
  const Mesh mesh = shapes::mixed_surface(4);
  const Motion motion = motion_of(mesh);
  shapes::Random random(1);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    const Vec3 d(random.signed_unit(), random.signed_unit(), random.signed_unit());
    const Vec3 once = motion.project(v, d);
    EXPECT_NEAR(once.dot(motion.normal(v)), 0.0, 1e-15);
    EXPECT_NEAR((motion.project(v, once) - once).norm(), 0.0, 1e-15);
    EXPECT_NEAR((d - once).cross(motion.normal(v)).norm(), 0.0, 1e-15);
  }
}

TEST(Motion, GoesWithItsVerticesWhenTheyAreRenumbered) {
  for (const Mesh& mesh : {shapes::mixed_surface(4), shapes::quad_grid(4), shapes::hex_grid(2)}) {
    const Motion motion = motion_of(mesh, {0, 1, 0, 1});
    std::vector<Index> order(mesh.point_count());
    for (Index v = 0; v < order.size(); ++v) order[v] = v;
    shapes::Random(1).shuffle(order);
    const Motion renumbered = motion.renumbered(order);
    ASSERT_EQ(renumbered.size(), motion.size());
    for (Index k = 0; k < order.size(); ++k) {
      EXPECT_EQ(renumbered.freedom(k), motion.freedom(order[k]));
      EXPECT_EQ(renumbered.normal(k), motion.normal(order[k]));
    }
  }
}

TEST(Motion, OfNothingIsNothing) { EXPECT_EQ(motion_of(Mesh()).moving(), 0u); }

TEST(Motion, MovesTiedVerticesTogether) {
  const Mesh mesh = shapes::triangle_grid(3);
  Motion motion = motion_of(mesh);
  motion.tie(3, 0, mesh.points());
  motion.tie(15, 12, mesh.points());
  motion.tie(12, 0, mesh.points());  // two pairs become one class
  for (const Index v : {0, 3, 12, 15}) {
    EXPECT_EQ(motion.leader(v), 0u);
    std::vector<Index> together;
    motion.for_tied(v, [&](Index u) { together.push_back(u); });
    std::sort(together.begin(), together.end());
    EXPECT_EQ(together, (std::vector<Index>{0, 3, 12, 15}));
  }
  Workers workers;
  std::vector<Vec3> gradient(mesh.point_count(), Vec3(1, 2, 0));
  motion.reduce(workers, motion.start(), gradient);
  EXPECT_EQ(gradient[0], Vec3(4, 8, 0));
  EXPECT_EQ(gradient[15], Vec3(0, 0, 0));
  motion.fix(15);
  for (const Index v : {0, 3, 12, 15}) EXPECT_EQ(motion.freedom(v), Freedom::fixed);
}

TEST(Motion, LeavesATrackInAPlaneOnlyIfAllOfItIsThere) {
  const Mesh mesh = shapes::tet_grid(1);
  const auto circle = std::make_shared<CircleTrack>(Vec3::Zero(), Vec3::UnitZ(), 1.0);
  const TrackPoint at{Vec3::UnitX(), Vec3::UnitY(), 0};
  Motion motion = motion_of(mesh);
  motion.put_on_track(0, circle, at);
  motion.keep_in_plane(0, at.position, Vec3::UnitZ());
  EXPECT_EQ(motion.freedom(0), Freedom::line);
  motion.keep_in_plane(0, at.position, Vec3::UnitX());  // tangent here, and nowhere else
  EXPECT_EQ(motion.freedom(0), Freedom::fixed);

  // A strip that is flat at first and then bends up: one patch.
  const auto strip = std::make_shared<SurfaceTrack>(
      std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0.3}, {2, 1, 0.3}},
      std::vector<VertexTriple>{{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}});
  motion.put_on_track(1, strip, strip->at(0, 0));
  motion.keep_in_plane(1, Vec3::Zero(), Vec3::UnitZ());
  EXPECT_EQ(motion.freedom(1), Freedom::fixed);
  const auto flat =
      std::make_shared<SurfaceTrack>(std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                                     std::vector<VertexTriple>{{0, 2, 1}, {1, 2, 3}});
  motion.put_on_track(2, flat, flat->at(0, 0));
  motion.keep_in_plane(2, Vec3::Zero(), Vec3::UnitZ());
  EXPECT_EQ(motion.freedom(2), Freedom::plane);
  const auto arc =
      std::make_shared<CurveTrack>(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 3, 0}});
  for (const auto& [normal, freedom] : {std::pair{Vec3(Vec3::UnitZ()), Freedom::line},
                                        std::pair{Vec3(Vec3::UnitY()), Freedom::fixed}}) {
    motion.put_on_track(3, arc, arc->at(0));
    motion.keep_in_plane(3, Vec3::Zero(), normal);
    EXPECT_EQ(motion.freedom(3), freedom);
  }
}

}  // namespace
}  // namespace evenmesh
