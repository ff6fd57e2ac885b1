// SPDX-License-Identifier: MIT
//
// The paper's dense method on meshes: it and the solvers that scale come to the same minima and
// multipliers.
#include "evenmesh/solver/dense.h"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/constraint/function_of.h"
#include "evenmesh/constraint/keep.h"
#include "evenmesh/geometry/analytic_tracks.h"
#include "evenmesh/solver/lagrangian.h"
#include "evenmesh/solver/smooth.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::copy_of;
using testing_setup::displaced;
using testing_setup::farthest;
using testing_setup::only;
using testing_setup::problem_of;

Options by(SolverKind solver) {
  Options options;
  options.solver = solver;
  options.judge = Judge::inversion;  // the minimum itself is wanted
  options.tolerance = solver == SolverKind::dense ? 1e-6 : 1e-8;
  options.max_iterations = 2000;
  return options;
}

// Both solvers from the same start; compares their minima.
struct Both {
  Both(const Mesh& start, const Problem& problem) : dense_mesh(start), mesh(start) {
    dense = smooth(dense_mesh, problem, by(SolverKind::dense));
    other = smooth(mesh, problem, by(SolverKind::automatic));
    EXPECT_EQ(dense.solver, SolverKind::dense);
    EXPECT_EQ(dense.stop, Stop::converged);
    EXPECT_EQ(dense.unmet, 0u);
    EXPECT_EQ(dense.quality_after.inverted, 0u);
    EXPECT_NEAR(dense.cost_after, other.cost_after, 1e-6 * other.cost_after + 1e-12);
  }
  Mesh dense_mesh, mesh;
  Report dense, other;
};

// ---- rows --------------------------------------------------------------------------------------

TEST(LagrangianRows, HaveTheSlopesOfTheirValues) {
  std::size_t rows_of_all = 0;
  for (const auto& [name, mesh] : shapes::zoo()) {
    Problem problem = problem_of(mesh, only("global"), "none");
    problem.max_move.assign(mesh.point_count(), 0.1);
    problem.bounds.push_back(
        {function_of("length", {0, 1}, [](auto x) { return (x[1] - x[0]).norm(); }), 0.5, 2.0});
    Workers workers;
    Objective objective(mesh, problem);
    objective.constrain(workers, mesh, mesh.points());
    const Lagrangian& rows = *objective.lagrangian();
    const std::vector<Vec3> x = displaced(mesh, problem.motion, 0.03, 5);
    const std::vector<Vec3> direction = displaced(mesh, problem.motion, 1.0, 7);
    const double h = 1e-6;
    std::vector<double> values[2], slopes;
    for (int side = 0; side < 2; ++side) {
      std::vector<Vec3> there = x;
      for (std::size_t v = 0; v < x.size(); ++v) there[v] += (side == 0 ? -h : h) * direction[v];
      rows.for_each_row(there, [&](const Lagrangian::Row& r) { values[side].push_back(r.value); });
    }
    rows.for_each_row(x, [&](const Lagrangian::Row& row) {
      double slope = 0.0;
      for (std::size_t k = 0; k < row.vertices.size(); ++k) {
        slope += row.slope[k].dot(direction[row.vertices[k]]);
      }
      slopes.push_back(slope);
    });
    ASSERT_GE(slopes.size(), 2u) << name;
    rows_of_all += slopes.size();
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      ASSERT_NEAR(slopes[i], (values[1][i] - values[0][i]) / (2.0 * h),
                  1e-4 * (1.0 + std::abs(slopes[i])))
          << name << ", row " << i;
    }
  }
  EXPECT_GT(rows_of_all, 1000u);
}

// ---- the same minima ---------------------------------------------------------------------------

TEST(Dense, ComesToTheMinimumOfTrianglesAndQuads) {
  const Mesh triangles = shapes::irregular_triangles(200, 0.3, 2);
  Both(triangles, problem_of(triangles, only("local")));
  const Mesh quads = shapes::quad_grid(10, 1.0, 0.3, 4);
  ProblemOptions edges;
  edges.costs = {{"local", 0.3}, {"barycenter", 0.3}};
  const Both both(quads, problem_of(quads, edges));
  EXPECT_LE(farthest(both.dense_mesh.points(), both.mesh.points()), 1e-5);
}

TEST(Dense, ComesToTheMinimumOfHexesAndWedges) {
  const Mesh hexes = shapes::hex_grid(3, 0.25);
  Both(hexes, problem_of(hexes));
  Mesh wedges = shapes::wedge_grid(3);
  wedges.set_points(displaced(wedges, problem_of(wedges).motion, 0.05, 3));
  Both(wedges, problem_of(wedges));
}

TEST(Dense, MeetsDemandsThatAreActive) {
  const Mesh mesh = shapes::irregular_triangles(150, 0.3, 1);
  Problem problem = problem_of(mesh, only("local"));
  problem.validity.min_jacobian = 0.8;
  const Both both(mesh, problem);
  ASSERT_GE(both.dense.holding.cells.size(), 3u);
  ASSERT_EQ(both.dense.holding.cells.size(), both.other.holding.cells.size());
  for (std::size_t i = 0; i < both.dense.holding.cells.size(); ++i) {
    const ActiveCell& mine = both.dense.holding.cells[i];
    const ActiveCell& others = both.other.holding.cells[i];
    EXPECT_EQ(mine.cell, others.cell);
    EXPECT_NEAR(mine.multiplier, others.multiplier, 0.02 * others.multiplier);
  }
}

TEST(Dense, UntanglesToTheSameMinimum) {
  const Mesh mesh = shapes::irregular_triangles(150, 0.3, 1, 0.7);
  const Both both(mesh, problem_of(mesh, only("local")));
  EXPECT_GT(both.dense.quality_before.inverted, 0u);
}

TEST(Dense, SlidesOnACircle) {
  const Mesh mesh = shapes::disk_triangles(120, 1, 0.0);
  Problem problem = problem_of(mesh, only("global"), "boundary");
  const auto circle = std::make_shared<CircleTrack>(Vec3::Zero(), Vec3::UnitZ(), 1.0);
  const std::vector<char> boundary = find_topology(mesh, find_orientation(mesh)).boundary;
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (!boundary[v]) continue;
    TrackPoint at;
    at.position = mesh.points()[v];
    problem.motion.put_on_track(v, circle, circle->nearest(at.position, at));
  }
  const Both both(mesh, problem);
  double along = 0.0;
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (!boundary[v]) continue;
    EXPECT_NEAR(both.dense_mesh.points()[v].norm(), 1.0, 1e-14);
    along = std::max(along, (both.dense_mesh.points()[v] - mesh.points()[v]).norm());
  }
  EXPECT_GT(along, 1e-3);
}

TEST(Dense, SlidesOnASphere) {
  Mesh mesh = shapes::sphere_triangles(2);
  Problem problem = problem_of(mesh, only("global"), "id:1-3");
  const auto sphere = std::make_shared<SphereTrack>(Vec3::Zero(), mesh.points()[0].norm());
  for (Index v = 3; v < mesh.point_count(); ++v) {
    TrackPoint at;
    at.position = mesh.points()[v];
    problem.motion.put_on_track(v, sphere, sphere->nearest(at.position, at));
  }
  const Both both(mesh, problem);
  for (const Vec3& p : both.dense_mesh.points()) {
    EXPECT_NEAR(p.norm(), mesh.points()[0].norm(), 1e-13);
  }
}

TEST(Dense, MovesTiedVerticesAlike) {
  const int n = 6;
  Mesh mesh = shapes::triangle_grid(n, 1.0, 0.2);
  const auto at = [&](int i, int j) { return static_cast<Index>(j * (n + 1) + i); };
  std::vector<Vec3> points = copy_of(mesh.points());
  for (int j = 1; j < n; ++j) {  // both sides out of line alike
    for (const int i : {0, n}) points[at(i, j)].x() += 0.05 * std::sin(9.0 * j);
  }
  mesh.set_points(points);
  Problem problem = problem_of(mesh, only("local"), "boundary");
  std::vector<char> fixed(mesh.point_count(), 0);
  for (int i = 0; i <= n; ++i) fixed[at(i, 0)] = fixed[at(i, n)] = 1;
  problem.motion = Motion(mesh, problem.orientation, fixed);
  for (int j = 1; j < n; ++j) problem.motion.tie(at(n, j), at(0, j), mesh.points());
  const Both both(mesh, problem);
  double moved = 0.0;
  for (int j = 1; j < n; ++j) {
    const Vec3 left = both.dense_mesh.points()[at(0, j)] - mesh.points()[at(0, j)];
    const Vec3 right = both.dense_mesh.points()[at(n, j)] - mesh.points()[at(n, j)];
    EXPECT_LE((left - right).norm(), 1e-15);
    moved = std::max(moved, left.norm());
  }
  EXPECT_GT(moved, 1e-3);
}

// ---- functions and limits ----------------------------------------------------------------------

TEST(Dense, KeepsTheTotalAreaAndFindsItsMultiplier) {
  const Mesh mesh = shapes::triangle_grid(6, 1.0, 0.2);
  Problem problem = problem_of(mesh, only("global"), "none");
  problem.bounds.push_back(make_keep(mesh, problem.orientation, Keep::area, {}, 1.1));
  const Both both(mesh, problem);
  EXPECT_NEAR(problem.bounds[0].function->at(both.dense_mesh.points()), 1.1, 1e-8);
  ASSERT_EQ(both.dense.holding.bounds.size(), 1u);
  const double expected = both.other.holding.bounds.at(0).multiplier;
  EXPECT_NEAR(both.dense.holding.bounds[0].multiplier, expected, 0.01 * std::abs(expected));
}

TEST(Dense, KeepsMovesWithinTheirLimit) {
  const Mesh mesh = shapes::quad_grid(6, 1.0, 0.25, 3);
  Problem problem = problem_of(mesh);
  problem.max_move.assign(mesh.point_count(), std::numeric_limits<double>::infinity());
  problem.max_move[24] = 0.02;
  const Both both(mesh, problem);
  EXPECT_LE((both.dense_mesh.points()[24] - mesh.points()[24]).norm(), 0.02);
  ASSERT_EQ(both.dense.holding.moves.size(), 1u);
  const double expected = both.other.holding.moves.at(0).multiplier;
  EXPECT_NEAR(both.dense.holding.moves[0].multiplier, expected, 0.01 * expected);
}

// ---- how it goes about it ----------------------------------------------------------------------

TEST(Dense, StopsByEtaAndReportsItsTerms) {
  Mesh mesh = shapes::quad_grid(6, 1.0, 0.3, 4);
  Options options = by(SolverKind::dense);
  options.eta = 1e-4;
  const Report report = smooth(mesh, problem_of(mesh), options);
  ASSERT_GE(report.history.size(), 3u);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_LT(report.history.back().eta.sum(), 1e-4);
  EXPECT_GE(report.history[report.history.size() - 2].eta.sum(), 1e-4);
  for (std::size_t i = 1; i < report.history.size(); ++i) {
    EXPECT_EQ(report.history[i].number, static_cast<int>(i));
    EXPECT_GT(report.history[i].eta.model, 0.0);
    EXPECT_GT(report.history[i].max_move, 0.0);
  }
}

TEST(Dense, DoesNotDependOnTheUnitOfLength) {
  const Mesh unit = shapes::quad_grid(6, 1.0, 0.3, 4);
  for (const Scaling scaling : {Scaling::absolute, Scaling::scale_free}) {
    ProblemOptions costs = only("local");
    costs.costs.push_back({"barycenter", 1.0});
    costs.scaling = scaling;
    Mesh large = unit;
    smooth(large, problem_of(large, costs), by(SolverKind::dense));
    Mesh small = shapes::scaled(unit, 1e-4);
    const Report report = smooth(small, problem_of(small, costs), by(SolverKind::dense));
    EXPECT_EQ(report.stop, Stop::converged);
    EXPECT_LE(farthest(shapes::scaled(small, 1e4).points(), large.points()), 1e-4);
  }
}

TEST(Dense, HasTheSameBitsForAnyNumberOfThreads) {
  Mesh first = shapes::quad_grid(8, 1.0, 0.3, 4);
  Mesh second = first;
  Options options = by(SolverKind::dense);
  smooth(first, problem_of(first), options);
  options.threads = 2;
  smooth(second, problem_of(second), options);
  EXPECT_EQ(copy_of(first.points()), copy_of(second.points()));
}

TEST(Dense, CanBeInterruptedAndLimited) {
  Mesh mesh = shapes::quad_grid(6, 1.0, 0.3, 4);
  Options options = by(SolverKind::dense);
  options.progress = [](const Iteration& i) { return i.number < 2; };
  Report report = smooth(mesh, problem_of(mesh), options);
  EXPECT_EQ(report.stop, Stop::interrupted);
  EXPECT_EQ(report.history.back().number, 2);

  mesh = shapes::quad_grid(6, 1.0, 0.3, 4);
  options = by(SolverKind::dense);
  options.max_iterations = 3;
  report = smooth(mesh, problem_of(mesh), options);
  EXPECT_EQ(report.stop, Stop::iteration_limit);
  EXPECT_EQ(report.history.back().number, 3);

  mesh = shapes::quad_grid(6, 1.0, 0.3, 4);
  options = by(SolverKind::dense);
  options.time_limit_seconds = 1e-9;
  EXPECT_EQ(smooth(mesh, problem_of(mesh), options).stop, Stop::time_limit);
}

// A step whose quadratic program takes many changes of the active set is not waited for.
TEST(Dense, CanBeStoppedWithinAStep) {
  const Mesh input = shapes::irregular_triangles(150, 0.3, 1);
  Problem problem = problem_of(input, only("local"));
  problem.validity.min_jacobian = 0.8;
  int asked = 0;
  Mesh mesh = input;
  Options options = by(SolverKind::dense);
  options.interrupted = [&] { return ++asked > 5; };
  const Report report = smooth(mesh, problem, options);
  EXPECT_EQ(report.stop, Stop::interrupted);
  EXPECT_EQ(asked, 6);  // nobody goes on after that
  EXPECT_LT(report.history.size(), 7u);

  mesh = input;
  int steps = 0;
  options.interrupted = {};
  options.progress = [&](const Iteration&) { return ++steps > 0; };
  options.time_limit_seconds = 1e-9;
  EXPECT_EQ(smooth(mesh, problem, options).stop, Stop::time_limit);
  EXPECT_EQ(steps, 1);
}

TEST(Dense, TakesNoStepWhereNoneIsAllowed) {
  const Mesh start = shapes::quad_grid(6, 1.0, 0.3, 4);
  const Mesh tangled_start = shapes::quad_grid(6, 1.0, 0.8, 4);
  for (const Mesh& input : {start, tangled_start}) {
    Mesh mesh = input;
    Options options = by(SolverKind::dense);
    options.max_iterations = 0;
    const Report report = smooth(mesh, problem_of(mesh), options);
    EXPECT_EQ(report.stop, Stop::iteration_limit);
    EXPECT_EQ(report.history.size(), 1u);
    EXPECT_EQ(copy_of(mesh.points()), copy_of(input.points()));
  }
}

TEST(Dense, RefusesMeshesThatTakeTooMuchMemory) {
  Mesh mesh = shapes::quad_grid(100, 1.0, 0.2);
  const std::vector<Vec3> before = copy_of(mesh.points());
  try {
    smooth(mesh, problem_of(mesh), by(SolverKind::dense));
    FAIL() << "was not refused";
  } catch (const InvalidOption& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("19602 unknowns"), std::string::npos) << message;
    EXPECT_NE(message.find("GB"), std::string::npos) << message;
    EXPECT_NE(message.find("multigrid"), std::string::npos) << message;
  }
  EXPECT_EQ(copy_of(mesh.points()), before);
  Options options;
  options.eta = -1.0;
  EXPECT_THROW(check(options), InvalidOption);
}

}  // namespace
}  // namespace evenmesh
