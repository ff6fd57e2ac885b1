// SPDX-License-Identifier: MIT
#include "evenmesh/problem/constraints.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/problem/constraint_text.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using Freedom = Motion::Freedom;

// A mesh with the constraints of a text.
struct Constrained {
  Mesh mesh;
  Orientation orientation;
  Topology topology;
  Problem problem;
  std::vector<ConstraintSummary> summary;

  explicit Constrained(Mesh m, const ConstraintText& text = {},
                       const std::vector<std::string>& groups = {})
      : mesh(std::move(m)),
        orientation(find_orientation(mesh)),
        topology(find_topology(mesh, orientation)) {
    problem.orientation = orientation;
    const ConstraintSetting setting{
        .mesh = mesh,
        .orientation = orientation,
        .topology = topology,
        .names = {.groups = groups},
        .read_mesh = [](const std::string&) { return shapes::sphere_triangles(3); },
        .read_text = [](const std::string&) { return std::string("id,dx,dy,dz\n5,0,0.1,0\n"); },
        .displacement =
            [](const std::string&) { return [](const Vec3& p) { return Vec3(p / 10); }; }};
    summary = apply(mesh, topology, understand(text, setting), problem);
  }

  Freedom freedom(Index v) const { return problem.motion.freedom(v); }
  std::size_t count(Freedom freedom) const {
    std::size_t number = 0;
    for (Index v = 0; v < mesh.point_count(); ++v) number += problem.motion.freedom(v) == freedom;
    return number;
  }
  std::size_t on_tracks() const {
    std::size_t number = 0;
    for (Index v = 0; v < mesh.point_count(); ++v) number += problem.motion.track(v) != nullptr;
    return number;
  }
  const ConstraintSummary& line(const std::string& kind, const std::string& text) const {
    for (const ConstraintSummary& s : summary) {
      if (s.kind == kind && s.text == text) return s;
    }
    ADD_FAILURE() << "no " << kind << " by " << text;
    return summary.at(0);
  }
};

std::string message_of(const Mesh& mesh, const ConstraintText& text,
                       const std::vector<std::string>& groups = {}) {
  try {
    const Constrained result(mesh, text, groups);
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "no error";
}

void expect_message(const Mesh& mesh, const ConstraintText& text,
                    const std::vector<std::string>& parts) {
  const std::string message = message_of(mesh, text);
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' in: " << message;
  }
}

// Quads around a disk of radius 1, the outermost ring last.
Mesh disk(int around) {
  std::vector<Vec3> points;
  for (const double r : {0.25, 0.6, 1.0}) {
    for (int k = 0; k < around; ++k) {
      const double t = 2 * std::numbers::pi * k / around;
      points.emplace_back(r * std::cos(t), r * std::sin(t), 0);
    }
  }
  Cells cells;
  const auto n = static_cast<Index>(around);
  for (Index r = 0; r < 2; ++r) {
    for (Index k = 0; k < n; ++k) {
      const Index next = (k + 1) % n;
      cells.add(CellKind::quad,
                std::array<Index, 4>{r * n + k, (r + 1) * n + k, (r + 1) * n + next, r * n + next});
    }
  }
  return Mesh(points, std::move(cells));
}

// ---- defaults -----------------------------------------------------------------------------------

TEST(DefaultConstraints, LetTheSidesOfASquareSlideBetweenItsCorners) {
  const Constrained square(shapes::quad_grid(4));
  EXPECT_EQ(square.count(Freedom::fixed), 4u);
  EXPECT_EQ(square.count(Freedom::line), 12u);
  EXPECT_EQ(square.count(Freedom::plane), 9u);
  EXPECT_EQ(square.problem.motion.project(2, Vec3(1, 1, 1)), Vec3(1, 0, 0));
  EXPECT_EQ(square.problem.motion.project(5, Vec3(1, 1, 1)), Vec3(0, 1, 0));
  EXPECT_EQ(square.line("fixed", "default").count, 4u);
  EXPECT_EQ(square.line("slide on line", "default").count, 12u);
  EXPECT_TRUE(std::isinf(square.problem.max_deviation));
}

TEST(DefaultConstraints, FixACircle) {
  const Constrained round(disk(24));
  EXPECT_EQ(round.count(Freedom::fixed), 48u);
  EXPECT_EQ(round.on_tracks(), 0u);
}

TEST(DefaultConstraints, LetACircleSlideOnItselfWithADeviation) {
  const Constrained round(disk(24), {.max_deviation = "1%"});
  EXPECT_EQ(round.count(Freedom::fixed), 0u);
  EXPECT_EQ(round.on_tracks(), 48u);
  EXPECT_NEAR(round.problem.max_deviation, 0.01 * std::sqrt(8.0), 1e-9);
}

TEST(DefaultConstraints, LetStraightPartsSlideThoughTheirEndsAreRounded) {
  // A stadium: two half circles joined by straight sides without a corner.
  std::vector<Vec3> outline;
  for (int k = 0; k < 6; ++k) outline.emplace_back(0.5 * k, -1, 0);
  for (int k = 0; k < 12; ++k) {
    const double t = std::numbers::pi * (k / 12.0 - 0.5);
    outline.emplace_back(3 + std::cos(t), std::sin(t), 0);
  }
  for (int k = 0; k < 6; ++k) outline.emplace_back(3 - 0.5 * k, 1, 0);
  for (int k = 0; k < 12; ++k) {
    const double t = std::numbers::pi * (k / 12.0 + 0.5);
    outline.emplace_back(std::cos(t), std::sin(t), 0);
  }
  const auto n = static_cast<Index>(outline.size());
  outline.emplace_back(1.5, 0, 0);
  Cells cells;
  for (Index k = 0; k < n; ++k) {
    cells.add(CellKind::triangle, std::array<Index, 3>{k, (k + 1) % n, n});
  }
  const Constrained stadium(Mesh(outline, std::move(cells)));
  EXPECT_EQ(stadium.count(Freedom::line), 10u);  // five within each side
  EXPECT_EQ(stadium.freedom(0), Freedom::fixed);
  EXPECT_EQ(stadium.freedom(1), Freedom::line);
  EXPECT_EQ(stadium.problem.motion.project(1, Vec3(1, 1, 0)), Vec3(1, 0, 0));
}

TEST(DefaultConstraints, LetASurfaceSlideOnItself) {
  const Constrained cube(shapes::cube_surface(4));
  EXPECT_EQ(cube.count(Freedom::fixed), 8u);
  EXPECT_EQ(cube.count(Freedom::line), 36u);
  EXPECT_EQ(cube.count(Freedom::plane), 54u);
  EXPECT_NEAR(cube.problem.max_deviation, 0.005 * std::sqrt(3.0), 1e-12);
  const Constrained sphere(shapes::sphere_triangles(2));
  EXPECT_EQ(sphere.on_tracks(), sphere.mesh.point_count());
}

TEST(DefaultConstraints, LetTheFlatSkinOfAVolumeSlide) {
  const Constrained cube(shapes::hex_grid(3));
  EXPECT_EQ(cube.count(Freedom::fixed), 8u);
  EXPECT_EQ(cube.count(Freedom::line), 24u);
  EXPECT_EQ(cube.count(Freedom::plane), 24u);
  EXPECT_EQ(cube.count(Freedom::free), 8u);
  EXPECT_EQ(cube.on_tracks(), 0u);
}

TEST(DefaultConstraints, TurnWithTheMesh) {
  const Mesh turned = shapes::rotated(shapes::hex_grid(3), Vec3(1, 2, 3), 0.7);
  const Constrained cube(turned);
  EXPECT_EQ(cube.count(Freedom::fixed), 8u);
  EXPECT_EQ(cube.count(Freedom::line), 24u);
  EXPECT_EQ(cube.count(Freedom::plane), 24u);
}

TEST(DefaultConstraints, AreLiftedWhereFree) {
  const Constrained square(shapes::quad_grid(4), {.free = {"id:1-3"}});
  EXPECT_EQ(square.count(Freedom::fixed), 3u);
  EXPECT_EQ(square.freedom(0), Freedom::plane);
  EXPECT_EQ(square.freedom(1), Freedom::plane);
}

TEST(DefaultConstraints, AreLiftedOnASurfaceWithoutLeavingIt) {
  const Constrained sphere(shapes::sphere_triangles(2), {.free = {"id:1-10"}});
  EXPECT_EQ(sphere.on_tracks(), sphere.mesh.point_count());
  EXPECT_EQ(sphere.line("max_deviation", "default").count, sphere.mesh.point_count());
}

TEST(DefaultConstraints, LetAFreeCornerGoOntoEveryFaceAroundIt) {
  const Constrained cube(shapes::cube_surface(4), {.free = {"box:-0.1,-0.1,-0.1,0.1,0.1,0.1"}});
  EXPECT_EQ(cube.count(Freedom::fixed), 7u);
  const Motion& motion = cube.problem.motion;
  for (Index v = 0; v < cube.mesh.point_count(); ++v) {
    if (!cube.mesh.points()[v].isZero(1e-12)) continue;
    ASSERT_NE(motion.track(v), nullptr);
    for (const Vec3& p : {Vec3(0.1, 0.05, 0), Vec3(0, 0.1, 0.05), Vec3(0.05, 0, 0.1)}) {
      const Vec3 there = motion.track(v)->nearest(p, motion.start()[motion.slot(v)]).position;
      EXPECT_NEAR((there - p).norm(), 0.0, 1e-12);
    }
  }
}

TEST(DefaultConstraints, GiveWayToTheOnesThatAreFixed) {
  const Constrained square(shapes::quad_grid(4), {.fix = "id:1,5"});
  EXPECT_EQ(square.count(Freedom::fixed), 2u);
  EXPECT_EQ(square.count(Freedom::plane), 23u);
  const Constrained cube(shapes::cube_surface(4), {.fix = "none"});
  EXPECT_EQ(cube.count(Freedom::fixed), 8u);  // which have nothing to slide on
  EXPECT_EQ(cube.count(Freedom::line), 36u);
}

TEST(DefaultConstraints, LetAPointBeAPoint) {
  Cells cells;
  cells.add(CellKind::triangle, std::array<Index, 3>{0, 1, 2});
  const Constrained point(Mesh(std::vector<Vec3>(3, Vec3(1, 2, 3)), std::move(cells)));
  EXPECT_EQ(point.count(Freedom::fixed), 3u);
}

// ---- slides -------------------------------------------------------------------------------------

TEST(Slides, FitACircleToEachPiece) {
  const Constrained round(disk(24), {.slide = {"boundary on circle"}});
  EXPECT_EQ(round.on_tracks(), 48u);
  EXPECT_TRUE(round.problem.targets.empty());
  const Track* inner = round.problem.motion.track(0);
  const Track* outer = round.problem.motion.track(48);
  ASSERT_NE(inner, outer);
  // 1 / radius.
  const Motion& motion = round.problem.motion;
  const TrackPoint& at = motion.start()[motion.slot(0)];
  EXPECT_NEAR(inner->curvature(at, at.direction).norm(), 4.0, 1e-9);
}

TEST(Slides, NameTheVertexThatDoesNotFit) {
  Mesh mesh = disk(24);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  points[50] *= 1.01;
  mesh.set_points(points);
  expect_message(mesh, {.slide = {"boundary on circle"}},
                 {"--slide 'boundary on circle'", "vertex 50 is 0.00", "off the circle"});
}

TEST(Slides, MoveVerticesOntoAFigureWithNumbers) {
  const Constrained round(disk(24), {.slide = {"id:49-72 on circle:0,0,0,0,0,1,1.25"}});
  ASSERT_EQ(round.problem.targets.size(), 24u);
  EXPECT_EQ(round.problem.targets[0].vertex, 48u);
  EXPECT_NEAR((round.problem.targets[0].position - Vec3(1.25, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_NE(round.summary.at(1).note.find("from up to 0.25 away"), std::string::npos)
      << round.summary.at(1).note;
}

TEST(Slides, KeepCornersAndEdges) {
  // Corners of the square stay; the sides are lines between them.
  const Constrained square(shapes::quad_grid(4), {.slide = {"boundary on line"}});
  EXPECT_EQ(square.count(Freedom::fixed), 4u);
  EXPECT_EQ(square.count(Freedom::line), 12u);
  const Constrained all(shapes::quad_grid(4), {.fix = "corners", .slide = {"boundary on line"}});
  EXPECT_EQ(all.count(Freedom::line), 12u);
}

TEST(Slides, OnTwoPlanesGoAlongTheirLine) {
  const Constrained cube(
      shapes::hex_grid(2),
      {.fix = "none", .slide = {"box:0,0,0,0,1,1 on plane", "box:0,0,0,1,0,1 on plane:y=0"}});
  EXPECT_EQ(cube.count(Freedom::line), 3u);
  EXPECT_EQ(cube.problem.motion.project(9, Vec3(1, 1, 1)), Vec3(0, 0, 1));
  EXPECT_EQ(cube.count(Freedom::plane), 12u);
}

TEST(Slides, GoOntoAnotherSurface) {
  const Mesh sphere = shapes::scaled(shapes::sphere_triangles(2), 1.1);
  const Constrained on(sphere, {.surface = "sphere.obj"});
  ASSERT_EQ(on.problem.targets.size(), sphere.point_count());
  for (const Target& target : on.problem.targets) EXPECT_LT(target.position.norm(), 1.0 + 1e-9);
  EXPECT_EQ(on.on_tracks(), sphere.point_count());
}

TEST(Slides, OntoAnotherSurfaceAreMeasuredFromWhereTheyWereBrought) {
  const Mesh sphere = shapes::scaled(shapes::sphere_triangles(2), 1.1);
  const Constrained on(sphere, {.surface = "sphere.obj"});
  const std::string& note = on.line("max_deviation", "default").note;
  EXPECT_NE(note.find("of where it was brought"), std::string::npos) << note;
  const Constrained own(sphere);
  EXPECT_NE(own.line("max_deviation", "default").note.find("from the input"), std::string::npos);
}

TEST(Slides, OntoAnotherSurfaceLeaveEdgesWhereTheyAre) {
  const Constrained on(shapes::cube_surface(4), {.surface = "sphere.obj"});
  EXPECT_EQ(on.problem.targets.size(), 54u);
  EXPECT_EQ(on.count(Freedom::line), 36u);
  EXPECT_EQ(on.count(Freedom::fixed), 8u);
}

TEST(Slides, OfAPlanarMeshStayInItsPlane) {
  expect_message(disk(24), {.slide = {"boundary on sphere"}}, {"planar mesh", "not on a sphere"});
  expect_message(disk(24), {.slide = {"boundary on circle:0,0,0,1,0,0,1"}},
                 {"would leave the plane of the mesh"});
}

TEST(Slides, AreOnWhatTheyAreSaidToBeOn) {
  expect_message(shapes::cube_surface(3), {.slide = {"all on boundary"}},
                 {"is not on the boundary"});
  const Constrained cube(shapes::cube_surface(3), {.slide = {"features on features"}});
  EXPECT_EQ(cube.line("slide on features", "--slide 'features on features'").count, 24u);
}

// ---- symmetry and periodicity -------------------------------------------------------------------

TEST(Symmetry, KeepsVerticesInThePlane) {
  const Constrained square(shapes::quad_grid(4), {.fix = "id:1,5", .symmetry = {"x=0"}});
  EXPECT_EQ(square.freedom(5), Freedom::line);
  EXPECT_EQ(square.problem.motion.project(5, Vec3(1, 1, 0)), Vec3(0, 1, 0));
  EXPECT_EQ(square.line("symmetry", "--symmetry x=0").count, 5u);
  expect_message(shapes::quad_grid(4), {.symmetry = {"x=-1"}},
                 {"--symmetry x=-1", "no vertex lies in this plane", "is 1 away"});
}

TEST(Symmetry, ComposesWithAnother) {
  const Constrained cube(shapes::hex_grid(2), {.fix = "none", .symmetry = {"x=0", "y=0", "z=0"}});
  EXPECT_EQ(cube.freedom(0), Freedom::fixed);
  EXPECT_EQ(cube.count(Freedom::line), 6u);
  EXPECT_EQ(cube.count(Freedom::plane), 12u);
}

TEST(PeriodicSides, MoveAlike) {
  const Constrained square(shapes::quad_grid(4), {.fix = "corners", .periodic = {"x=0 x=1"}});
  EXPECT_EQ(square.problem.motion.leader(9), 5u);
  EXPECT_EQ(square.problem.motion.leader(14), 10u);
  EXPECT_EQ(square.line("periodic", "--periodic 'x=0 x=1'").count, 10u);
  const Constrained by_box(shapes::quad_grid(4), {.periodic = {"box:0,0,0,0,1,0 box:1,0,0,1,1,0"}});
  EXPECT_EQ(by_box.problem.motion.leader(9), 5u);
}

TEST(PeriodicSides, NameWhatHasNoImage) {
  Mesh mesh = shapes::quad_grid(4);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  points[9].y() += 0.0625;
  mesh.set_points(points);
  expect_message(mesh, {.periodic = {"x=0 x=1"}},
                 {"2 of 5 and 5", "the first is vertex 5", "is 0.0625 away"});
  expect_message(mesh, {.periodic = {"x=0 y=1"}}, {"not parallel"});
}

TEST(PeriodicSides, HavePairs) {
  const Mesh square = shapes::quad_grid(4);
  expect_message(square, {.periodic = {"x=0 x=0"}}, {"--periodic 'x=0 x=0'", "its own image"});
  std::vector<Vec3> points(square.points().begin(), square.points().end());
  points.emplace_back(0, 0, 0);
  points.emplace_back(1, 0, 0);
  expect_message(Mesh(points, square.cells()), {.periodic = {"id:26 id:27"}},
                 {"--periodic 'id:26 id:27'", "no vertex of a cell"});
}

// ---- prescribed places and limits ---------------------------------------------------------------

TEST(Prescribed, PlacesAreTargetsOfFixedVertices) {
  const Constrained square(shapes::quad_grid(4), {.prescribe = {"id:5,25 = formulas,are,stubbed"}});
  ASSERT_EQ(square.problem.targets.size(), 2u);
  EXPECT_EQ(square.problem.targets[1].vertex, 24u);
  EXPECT_EQ(square.problem.targets[1].position, Vec3(1.1, 1.1, 0));
  EXPECT_EQ(square.freedom(24), Freedom::fixed);
  EXPECT_EQ(square.line("fixed", "default").count, 2u);
  const Constrained table(shapes::quad_grid(4), {.prescribe = {"all = moves.csv"}});
  ASSERT_EQ(table.problem.targets.size(), 1u);
  EXPECT_NEAR(table.problem.targets[0].position.y(), 0.1, 1e-15);
}

TEST(Prescribed, TakeTheirImagesAlong) {
  const Constrained square(
      shapes::quad_grid(4),
      {.fix = "none", .periodic = {"x=0 x=1"}, .prescribe = {"id:5 = moves.csv"}});
  ASSERT_EQ(square.problem.targets.size(), 2u);
  EXPECT_EQ(square.problem.targets[0].vertex, 0u);
  EXPECT_NEAR(square.problem.targets[0].position.y(), 0.1, 1e-15);
}

TEST(Prescribed, TakeAllTheirImagesAlong) {
  const auto expect_moved = [](const std::vector<std::string>& periodic,
                               const std::vector<Index>& images) {
    const Constrained square(
        shapes::quad_grid(4),
        {.fix = "none", .periodic = periodic, .prescribe = {"id:5 = moves.csv"}});
    ASSERT_EQ(square.problem.targets.size(), images.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
      const Target& target = square.problem.targets[i];
      EXPECT_EQ(target.vertex, images[i]);
      const Vec3 moved = target.position - square.mesh.points()[target.vertex];
      EXPECT_NEAR((moved - Vec3(0, 0.1, 0)).norm(), 0.0, 1e-15);
      EXPECT_EQ(square.freedom(target.vertex), Freedom::fixed);
    }
  };
  expect_moved({"x=0 x=0.5", "x=0.5 x=1"}, {0, 2, 4});
  expect_moved({"x=0 x=1", "y=0 y=1"}, {0, 4, 20, 24});
}

TEST(Prescribed, PlacesWhereVerticesAreFixThemAndMoveNothing) {
  // The stub moves by a tenth of the place, which is nothing at the origin.
  const Constrained square(shapes::quad_grid(4), {.fix = "none", .prescribe = {"id:1 = a,b,c"}});
  EXPECT_TRUE(square.problem.targets.empty());
  EXPECT_EQ(square.freedom(0), Freedom::fixed);
  EXPECT_EQ(square.count(Freedom::fixed), 1u);
  expect_message(
      shapes::quad_grid(4),
      {.fix = "none", .periodic = {"x=0 x=1"}, .prescribe = {"id:1 = a,b,c", "id:5 = moves.csv"}},
      {"--periodic 'x=0 x=1' and --prescribe", "would move differently, by 0.1"});
}

TEST(Prescribed, ByATableWhateverTheCaseOfItsSuffix) {
  const Constrained square(shapes::quad_grid(4), {.prescribe = {"all = MOVES.CSV"}});
  EXPECT_EQ(square.problem.targets.size(), 1u);
}

TEST(EqualSpacing, KeepsTheEndsOfItsCurves) {
  const Constrained open(shapes::quad_grid(4), {.fix = "none", .equal_spacing = {"id:2-4"}});
  EXPECT_EQ(open.count(Freedom::fixed), 3u);
  for (const std::string deviation : {"", "1%"}) {
    const Constrained loops(disk(24), {.max_deviation = deviation, .equal_spacing = {"boundary"}});
    EXPECT_EQ(loops.count(Freedom::fixed), 48u);
    EXPECT_EQ(loops.line("equal_spacing", "--equal-spacing boundary").count, 48u);
  }
}

TEST(EqualSpacing, CountsAnEndOfTwoCurvesOnce) {
  const Constrained square(shapes::quad_grid(4), {.equal_spacing = {"boundary"}});
  EXPECT_EQ(square.line("equal_spacing", "--equal-spacing boundary").count, 16u);
}

TEST(EqualSpacing, MovesVerticesAlongTheirSide) {
  Mesh mesh = shapes::quad_grid(4);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  points[1].x() = 0.1;
  mesh.set_points(points);
  const Constrained even(mesh, {.equal_spacing = {"id:1-5"}});
  EXPECT_EQ(even.line("equal_spacing", "--equal-spacing id:1-5").count, 5u);
  EXPECT_NEAR(even.problem.targets.at(0).position.x(), 0.25, 1e-12);
}

TEST(Limits, AreLengthsOrPartsOfTheEdgesAround) {
  const Constrained square(shapes::quad_grid(4),
                           {.max_move = "0.2h", .limit = {"id:1 max-move 0.01"}});
  EXPECT_EQ(square.problem.max_move[0], 0.01);
  EXPECT_NEAR(square.problem.max_move[12], 0.05, 1e-12);
}

TEST(Limits, AreLengthsInAUnitThatMakesSense) {
  const Mesh mesh = shapes::quad_grid(2);
  const Orientation orientation = find_orientation(mesh);
  const Topology topology = find_topology(mesh, orientation);
  const auto expect_refused = [&](const Constraints& constraints, const std::string& option) {
    Problem problem;
    problem.orientation = orientation;
    try {
      apply(mesh, topology, constraints, problem);
      ADD_FAILURE() << option;
    } catch (const InvalidOption& error) {
      EXPECT_NE(std::string(error.what()).find(option), std::string::npos) << error.what();
    }
  };
  using Unit = Length::Unit;
  const double nan = std::nan("");
  expect_refused({.max_deviation = Length{-1.0}}, "--max-deviation");
  expect_refused({.max_deviation = Length{nan}}, "--max-deviation");
  expect_refused({.max_deviation = Length{0.1, Unit::of_edges}}, "--max-deviation");
  expect_refused({.min_size = Length{0.0}}, "--min-area");
  expect_refused({.min_size = Length{0.1, Unit::of_diagonal}}, "--min-area");
  expect_refused({.min_jacobian = nan}, "--min-jacobian");
  const Selection all{"limit", std::vector<char>(mesh.point_count(), 1)};
  expect_refused({.move_limits = {{all, Length{HUGE_VAL}}}}, "limit");
  expect_refused({.move_limits = {{all, Length{0.1, Unit::of_mean_size}}}}, "limit");
}

TEST(Limits, OfAnEarlierApplicationAreForgotten) {
  Constrained square(shapes::quad_grid(4), {.max_move = "0.2",
                                            .max_deviation = "0.1",
                                            .min_area = "0.001",
                                            .min_jacobian = "0.1",
                                            .keep = {"area"},
                                            .prescribe = {"id:5 = moves.csv"}});
  apply(square.mesh, square.topology, {}, square.problem);
  EXPECT_EQ(square.problem.validity.min_size, 0.0);
  EXPECT_EQ(square.problem.validity.min_jacobian, 0.0);
  EXPECT_TRUE(square.problem.bounds.empty());
  EXPECT_TRUE(square.problem.max_move.empty());
  EXPECT_TRUE(square.problem.targets.empty());
  EXPECT_TRUE(std::isinf(square.problem.max_deviation));
}

TEST(Limits, HoldForAPointToo) {
  Cells cells;
  cells.add(CellKind::triangle, std::array<Index, 3>{0, 1, 2});
  const Constrained point(Mesh(std::vector<Vec3>(3, Vec3(1, 2, 3)), std::move(cells)),
                          {.slide = {"all on boundary"},
                           .symmetry = {"x=1"},
                           .max_move = "0.5",
                           .min_jacobian = "0.1"});
  EXPECT_EQ(point.count(Freedom::fixed), 3u);
  EXPECT_EQ(point.problem.validity.min_jacobian, 0.1);
  EXPECT_EQ(point.problem.max_move.size(), 3u);
  EXPECT_EQ(point.line("max_move", "--max-move 0.5").count, 3u);
}

TEST(Limits, OfCellsBecomeValidity) {
  const Constrained square(shapes::quad_grid(4), {.min_area = "0.2m", .min_jacobian = "0.1"});
  EXPECT_NEAR(square.problem.validity.min_size, 0.2 / 16, 1e-12);
  EXPECT_EQ(square.problem.validity.min_jacobian, 0.1);
  expect_message(shapes::quad_grid(2), {.min_volume = "1"}, {"--min-area"});
  expect_message(shapes::hex_grid(1), {.min_area = "1"}, {"--min-volume"});
  expect_message(shapes::hex_grid(1), {.min_jacobian = "1"}, {"between 0 and 1"});
}

TEST(Keep, BecomesABound) {
  const Constrained square(shapes::quad_grid(4), {.keep = {"area"}});
  ASSERT_EQ(square.problem.bounds.size(), 1u);
  EXPECT_NEAR(square.problem.bounds[0].lower, 1.0, 1e-12);
  EXPECT_EQ(square.line("area", "--keep area").entry, Entry::bordered);
  expect_message(shapes::quad_grid(4), {.keep = {"area of wall"}},
                 {"--keep 'area of wall'", "no group 'wall'"});
}

TEST(Keep, TakesANameInQuotationMarks) {
  const Mesh mesh =
      shapes::grouped(shapes::quad_grid(2), [](std::size_t c) { return c < 2 ? 1u : 2u; });
  const Constrained left(mesh, {.keep = {"area of 'left side'"}}, {"", "left side", "right"});
  EXPECT_EQ(left.line("area", "--keep 'area of 'left side''").count, 6u);
  const std::string message =
      message_of(mesh, {.keep = {"volume of right"}}, {"", "left side", "right"});
  EXPECT_EQ(message.find("group 2"), std::string::npos) << message;
}

// ---- contradictions -----------------------------------------------------------------------------

TEST(Contradictions, NameBothSidesAndAVertex) {
  const Mesh square = shapes::quad_grid(4);
  expect_message(square, {.fix = "boundary", .prescribe = {"id:5 = moves.csv"}},
                 {"--fix boundary and --prescribe 'id:5 = moves.csv' contradict",
                  "vertex 4 is fixed", "move by 0.1"});
  expect_message(square, {.fix = "boundary", .free = {"corners"}},
                 {"--fix boundary and --free corners contradict", "vertex 0"});
  expect_message(square, {.prescribe = {"id:5 = moves.csv", "id:5 = a,b,c"}},
                 {"--prescribe 'id:5 = moves.csv' and --prescribe 'id:5 = a,b,c'", "vertex 4"});
  expect_message(square, {.symmetry = {"y=0"}, .prescribe = {"id:5 = moves.csv"}},
                 {"--symmetry y=0 and --prescribe", "leave the plane by 0.1"});
  expect_message(square, {.max_move = "0.05", .prescribe = {"id:5 = moves.csv"}},
                 {"--max-move 0.05 and --prescribe", "has to move by 0.1"});
  expect_message(square, {.slide = {"id:2-4 on line:0,0,0,1,0,0", "id:3 on line:0,0.5,0,1,0,0"}},
                 {"--slide 'id:2-4 on line:0,0,0,1,0,0' and --slide 'id:3 on line:0,0.5,0,1,0,0'",
                  "vertex 2 cannot be on both", "0.5 apart"});
  expect_message(square,
                 {.slide = {"id:2-4 on line"}, .prescribe = {"id:3 = a,b,c", "id:4 = a,b,c"}},
                 {"no error"});
}

TEST(Contradictions, NameThePhraseThatTiesAPair) {
  expect_message(shapes::quad_grid(4),
                 {.fix = "none",
                  .periodic = {"x=0 x=1", "y=0 y=1"},
                  .prescribe = {"id:5 = moves.csv", "id:25 = a,b,c"}},
                 {"--periodic 'y=0 y=1' and --prescribe", "vertex 4", "vertex 24", "by 0.1"});
}

TEST(Contradictions, IncludeSelectionsWithoutVertices) {
  const Mesh square = shapes::quad_grid(4);
  expect_message(square, {.free = {"none"}}, {"--free none", "selects no vertex"});
  expect_message(square, {.slide = {"features on features"}}, {"selects no vertex"});
  expect_message(square, {.limit = {"none max-move 1"}}, {"--limit", "selects no vertex"});
  expect_message(square, {.prescribe = {"none = a,b,c"}}, {"moves no vertex"});
  expect_message(square, {.periodic = {"x=5 x=6"}}, {"selects no vertex"});
}

TEST(Groups, AreSelectedByAnyOfTheirNames) {
  const Mesh mesh =
      shapes::grouped(shapes::quad_grid(2), [](std::size_t c) { return c < 2 ? 1u : 2u; });
  const std::vector<std::string> names{"", "o part, g left side", "o part, g right"};
  const Constrained left(mesh, {.fix = "group:left side"}, names);
  EXPECT_EQ(left.count(Freedom::fixed), 6u);
  const Constrained part(mesh, {.fix = "group:part - group:\"g right\""}, names);
  EXPECT_EQ(part.count(Freedom::fixed), 3u);
  EXPECT_NE(message_of(mesh, {.fix = "group:rihgt"}, names).find("did you mean 'right'?"),
            std::string::npos);
}

}  // namespace
}  // namespace evenmesh
