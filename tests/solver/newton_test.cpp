// SPDX-License-Identifier: MIT
#include "evenmesh/solver/newton.h"

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <numeric>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "evenmesh/geometry/analytic_tracks.h"
#include "evenmesh/solver/second_derivatives.h"
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

/// factor * the sum of x^power over some vertices.
class SumOfX final : public Function {
 public:
  SumOfX(std::vector<Index> vertices, int power) : vertices_(std::move(vertices)), power_(power) {}
  std::string_view name() const override { return "sum of x"; }
  std::span<const Index> vertices() const override { return vertices_; }
  double evaluate(Points own, std::span<Vec3> gradient) const override {
    double sum = 0.0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      sum += std::pow(own[i].x(), power_);
      if (!gradient.empty()) {
        gradient[i] = Vec3(power_ * std::pow(own[i].x(), power_ - 1), 0.0, 0.0);
      }
    }
    return sum;
  }

 private:
  std::vector<Index> vertices_;
  int power_;
};

/// The function that is minimised, along the moves that a problem allows.
class Landscape {
 public:
  Landscape(const Mesh& mesh, const Problem& problem) : objective(mesh, problem) {
    objective.constrain(workers, mesh, mesh.points());
  }

  std::vector<Vec3> gradient(Points x, const Motion::Places& places) {
    std::vector<Vec3> g(x.size());
    objective.evaluate(workers, x, g);
    objective.motion().reduce(workers, places, g);
    return g;
  }
  /// The derivative of the gradient in a direction, where nothing slides on tracks.
  std::vector<Vec3> bend(Points x, Points direction) {
    const double h = 1e-6 / std::max(1e-300, largest(direction));
    const Motion::Places& places = objective.motion().start();
    std::vector<Vec3> ahead = gradient(moved(x, h, direction), places);
    const std::vector<Vec3> behind = gradient(moved(x, -h, direction), places);
    for (std::size_t v = 0; v < ahead.size(); ++v) ahead[v] = (ahead[v] - behind[v]) / (2.0 * h);
    return ahead;
  }
  /// A step along p, tied vertices too, and back onto tracks.
  std::vector<Vec3> moved(Points x, double h, Points p) {
    std::vector<Vec3> result = copy_of(x);
    for (std::size_t v = 0; v < x.size(); ++v) result[v] += h * p[v];
    Motion::Places places = objective.motion().start();
    objective.motion().retract(workers, x, objective.motion().start(), result, places);
    return result;
  }
  static double largest(Points p) {
    double most = 0.0;
    for (const Vec3& step : p) most = std::max(most, step.norm());
    return most;
  }

  Workers workers;
  Objective objective;
};

Eigen::VectorXd random_unknowns(std::size_t count, std::uint64_t seed) {
  shapes::Random random(seed);
  Eigen::VectorXd y(static_cast<Eigen::Index>(count));
  for (double& value : y) value = random.signed_unit();
  return y;
}

/// Compares the matrix with differences of the whole gradient, in a few random directions.
void expect_second_derivatives(Landscape& land, Points x, const std::string& name) {
  NewtonSystem system(land.objective, x);
  system.assemble(land.workers, x, land.objective.motion().start(), NewtonSystem::Kind::exact);
  const ReducedMatrix& matrix = system.matrix();
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Eigen::VectorXd y = random_unknowns(matrix.unknowns(), seed);
    const Eigen::VectorXd product = matrix.upper().selfadjointView<Eigen::Upper>() * y;
    std::vector<Vec3> step(x.size());
    matrix.expand(y, step);
    const Eigen::VectorXd expected = matrix.reduced(land.bend(x, step));
    EXPECT_LE((product - expected).norm(), 1e-6 * expected.norm()) << name;
  }
}

std::vector<Index> first_moving(const Motion& motion, std::size_t count) {
  std::vector<Index> result;
  for (Index v = 0; v < motion.size() && result.size() < count; ++v) {
    if (motion.freedom(v) != Motion::Freedom::fixed) result.push_back(v);
  }
  return result;
}

template <typename Predicate>
Problem with_fixed(const Mesh& mesh, const Predicate& is_fixed) {
  std::vector<char> fixed(mesh.point_count());
  for (Index v = 0; v < fixed.size(); ++v) fixed[v] = is_fixed(v) ? 1 : 0;
  return make_problem(mesh, find_orientation(mesh), fixed);
}

// ---- the matrix -----------------------------------------------------------------------------

/// Vertices of surfaces move in fixed planes: on tracks, directions change from triangle to
/// triangle and differences with them.
Problem in_tangent_planes(const Mesh& mesh) {
  Problem problem = problem_of(mesh);
  std::vector<char> fixed(mesh.point_count());
  for (Index v = 0; v < fixed.size(); ++v) {
    fixed[v] = problem.motion.freedom(v) == Motion::Freedom::fixed;
  }
  problem.motion = Motion(mesh, problem.orientation, fixed);
  return problem;
}

TEST(NewtonSystem, HasTheSecondDerivativesOfTheCosts) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    Problem problem = in_tangent_planes(mesh);
    if (problem.terms.empty()) continue;
    problem.validity.demanded = false;
    Landscape land(mesh, problem);
    expect_second_derivatives(land, displaced(mesh, problem.motion, 0.02, 3), name);
  }
}

TEST(NewtonSystem, HasTheSecondDerivativesOfTheConstraints) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    Problem problem = in_tangent_planes(mesh);
    if (problem.terms.empty()) continue;
    problem.validity.min_jacobian = 0.95;  // active almost everywhere
    problem.max_move.assign(mesh.point_count(), 0.015);
    problem.bounds.push_back(
        {std::make_shared<SumOfX>(first_moving(problem.motion, 5), 2), 0.1, 0.1});
    Landscape land(mesh, problem);
    expect_second_derivatives(land, displaced(mesh, problem.motion, 0.02, 3), name);
  }
}

TEST(NewtonSystem, SharesTheUnknownsOfTiedVertices) {
  const Mesh mesh = shapes::triangle_grid(4, 1.0, 0.2);
  Problem problem = with_fixed(mesh, [](Index v) { return v < 5 || v >= 20; });
  for (Index j = 1; j < 4; ++j) problem.motion.tie(5 * j + 4, 5 * j, mesh.points());
  Landscape land(mesh, problem);
  const std::vector<Vec3> x = copy_of(mesh.points());
  expect_second_derivatives(land, x, "tied");
  const NewtonSystem system(land.objective, mesh.points());
  EXPECT_EQ(system.matrix().unknowns(), 2u * 3u * 4u);
  EXPECT_EQ(system.matrix().first(9), system.matrix().first(5));
}

TEST(NewtonSystem, KnowsTheSizeOfTheFactor) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Problem problem = problem_of(mesh);
    const Objective objective(mesh, problem);
    NewtonSystem system(objective, mesh.points());
    if (system.matrix().unknowns() == 0) continue;
    Workers workers;
    system.assemble(workers, mesh.points(), problem.motion.start(), NewtonSystem::Kind::clamped);
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Upper,
                               Eigen::NaturalOrdering<int>>
        factor(system.matrix().upper());
    ASSERT_EQ(factor.info(), Eigen::Success) << name;
    const Eigen::SparseMatrix<double> L = factor.matrixL();
    EXPECT_EQ(system.matrix().factor_entries(), static_cast<double>(L.nonZeros())) << name;
  }
}

TEST(NewtonSystem, IsExactWhereItCanBeAndClampedElsewhere) {
  Mesh mesh = shapes::irregular_triangles(400);
  const Problem problem = problem_of(mesh, only("local"));
  Landscape land(mesh, problem);
  NewtonSystem system(land.objective, mesh.points());
  std::vector<Vec3> p(mesh.point_count());
  const auto slope_at = [&](Points x) {
    EXPECT_TRUE(system.update(land.workers, x, problem.motion.start()));
    const std::vector<Vec3> g = land.gradient(x, problem.motion.start());
    system.solve(g, p);
    return std::inner_product(g.begin(), g.end(), p.begin(), 0.0, std::plus<>(),
                              [](const Vec3& a, const Vec3& b) { return a.dot(b); });
  };
  EXPECT_LT(slope_at(mesh.points()), 0.0);
  EXPECT_EQ(system.kind(), NewtonSystem::Kind::clamped);
  Options options;
  options.tolerance = 1e-3;
  smooth(mesh, problem, options);
  EXPECT_LT(slope_at(mesh.points()), 0.0);
  EXPECT_EQ(system.kind(), NewtonSystem::Kind::exact);
}

TEST(NewtonSystem, SolvesWithBoundsOnManyVertices) {
  const Mesh mesh = shapes::triangle_grid(12, 1.0, 0.02);
  Problem problem = problem_of(mesh, only("global"));
  const std::vector<Index> many = first_moving(problem.motion, 100);
  ASSERT_GT(many.size(), NewtonSystem::kFewVertices);
  problem.bounds.push_back({std::make_shared<SumOfX>(many, 1), 51.0, 51.0});
  problem.bounds.push_back(
      {std::make_shared<SumOfX>(std::vector<Index>(many.begin(), many.begin() + 60), 1), 30.0});
  Landscape land(mesh, problem);
  NewtonSystem system(land.objective, mesh.points());
  const std::vector<Vec3> x = copy_of(mesh.points());
  ASSERT_TRUE(system.update(land.workers, x, problem.motion.start()));
  ASSERT_EQ(system.kind(), NewtonSystem::Kind::exact);
  const std::vector<Vec3> g = land.gradient(x, problem.motion.start());
  std::vector<Vec3> p(x.size());
  system.solve(g, p);
  // H p = -g
  const std::vector<Vec3> change = land.bend(x, p);
  for (std::size_t v = 0; v < x.size(); ++v) {
    EXPECT_LE((change[v] + g[v]).norm(), 1e-6 * Landscape::largest(g)) << v;
  }
}

TEST(ClampEigenvalues, LeavesTheNearestMatrixWithoutNegativeOnes) {
  Eigen::MatrixXd matrix(2, 2);
  matrix << 1.0, 2.0, 2.0, 1.0;  // 3 along (1, 1) and -1 along (1, -1)
  clamp_eigenvalues(matrix);
  EXPECT_LE((matrix - Eigen::MatrixXd::Constant(2, 2, 1.5)).norm(), 1e-14);
  Eigen::MatrixXd definite = 2.0 * Eigen::MatrixXd::Identity(3, 3);
  clamp_eigenvalues(definite);
  EXPECT_EQ(definite, Eigen::MatrixXd(2.0 * Eigen::MatrixXd::Identity(3, 3)));
}

// ---- tracks ---------------------------------------------------------------------------------

/// Quads between circles of radius 1, 1.3 and 1.6; the innermost vertices stay, the outermost slide
/// on their circle.
struct Ring {
  Mesh mesh;
  Problem problem;
};

Ring disturbed_ring() {
  constexpr Index kAround = 24;
  shapes::Random random(7);
  std::vector<Vec3> points;
  for (int ring = 0; ring < 3; ++ring) {
    for (Index i = 0; i < kAround; ++i) {
      const double wobble = ring > 0 ? 0.3 * random.signed_unit() : 0.0;
      const double angle = 2.0 * std::numbers::pi * (i + wobble) / kAround;
      const double radius = 1.0 + 0.3 * ring + (ring == 1 ? 0.05 * random.signed_unit() : 0.0);
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  }
  Cells cells;
  for (Index ring = 0; ring < 2; ++ring) {
    for (Index i = 0; i < kAround; ++i) {
      const Index a = ring * kAround + i;
      const Index b = ring * kAround + (i + 1) % kAround;
      cells.add(CellKind::quad, {{a, a + kAround, b + kAround, b}});
    }
  }
  Ring result{Mesh(points, std::move(cells)), {}};
  result.problem = with_fixed(result.mesh, [](Index v) { return v < kAround; });
  const auto circle = std::make_shared<CircleTrack>(Vec3::Zero(), Vec3::UnitZ(), 1.6);
  for (Index i = 0; i < kAround; ++i) {
    const Index v = 2 * kAround + i;
    const TrackPoint at = circle->nearest(points[v], {points[v], Vec3::Zero(), 0});
    result.problem.motion.put_on_track(v, circle, at);
  }
  return result;
}

// The second derivative of the cost along the path on which a retraction leads.
void expect_second_derivatives_along_tracks(const Mesh& mesh, const Problem& problem) {
  Landscape land(mesh, problem);
  NewtonSystem system(land.objective, mesh.points());
  const Points x = mesh.points();
  system.assemble(land.workers, x, problem.motion.start(), NewtonSystem::Kind::exact);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Eigen::VectorXd y = random_unknowns(system.matrix().unknowns(), seed);
    std::vector<Vec3> step(x.size());
    system.matrix().expand(y, step);
    const double h = 1e-4;
    const auto f = [&](double by) {
      return land.objective.evaluate(land.workers, land.moved(x, by, step), {});
    };
    const double expected = (f(h) - 2.0 * f(0.0) + f(-h)) / (h * h);
    const double found = y.dot(system.matrix().upper().selfadjointView<Eigen::Upper>() * y);
    EXPECT_NEAR(found, expected, 1e-4 * std::abs(expected));
  }
}

TEST(NewtonSystem, CountsHowCurvesBend) {
  const Ring ring = disturbed_ring();
  expect_second_derivatives_along_tracks(ring.mesh, ring.problem);
}

TEST(NewtonSystem, CountsHowSurfacesBend) {
  const Mesh mesh = shapes::sphere_triangles(2);
  Problem problem = problem_of(mesh, only("global"), "none");
  const auto sphere = std::make_shared<SphereTrack>(Vec3::Zero(), 1.0);
  const auto cylinder = std::make_shared<CylinderTrack>(Vec3::Zero(), Vec3::UnitZ(), 0.5);
  std::vector<Vec3> points = copy_of(mesh.points());
  for (Index v = 0; v < points.size(); ++v) {
    // One of them elsewhere, and on what bends in one direction only.
    if (v == 60) points[v] = Vec3(0.3, 0.4, 0.2);
    const std::shared_ptr<const Track> track =
        v == 60 ? std::shared_ptr<const Track>(cylinder) : sphere;
    const TrackPoint at = track->nearest(points[v], {points[v], Vec3::Zero(), 0});
    points[v] = at.position;
    problem.motion.put_on_track(v, track, at);
  }
  expect_second_derivatives_along_tracks(testing_setup::with_points(mesh, points), problem);
}

// ---- smoothing with it ----------------------------------------------------------------------

Report smooth_with(SolverKind solver, Mesh& mesh, const Problem& problem, double tolerance,
                   int most = 400) {
  Options options;
  options.solver = solver;
  options.tolerance = tolerance;
  options.max_iterations = most;
  options.judge = Judge::inversion;
  return smooth(mesh, problem, options);
}

std::size_t iterations(const Report& report) { return report.history.size() - 1; }

TEST(Newton, ConvergesQuadraticallyToTheSameMinimum) {
  Mesh mesh = shapes::irregular_triangles(2000);
  Mesh other = mesh;
  const Problem problem = problem_of(mesh, only("local"));
  const Report report = smooth_with(SolverKind::newton, mesh, problem, 1e-10);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_EQ(report.solver, SolverKind::newton);
  EXPECT_LE(iterations(report), 7u);
  EXPECT_EQ(report.newton_steps, static_cast<int>(iterations(report)));
  const auto& last = report.history.back();
  const auto& before = report.history[report.history.size() - 2];
  EXPECT_LE(last.gradient, 10.0 * before.gradient * before.gradient + 1e-13);
  const Report slow = smooth_with(SolverKind::multigrid, other, problem, 1e-10);
  EXPECT_EQ(slow.solver, SolverKind::multigrid);
  EXPECT_EQ(slow.newton_steps, 0);
  EXPECT_NEAR(report.cost_after, slow.cost_after, 1e-9 * slow.cost_after);
  EXPECT_LE(farthest(mesh.points(), other.points()), 1e-6);
}

TEST(Newton, DoesNotMindQuadsThatShearFreely) {
  Mesh mesh = shapes::quad_grid(40, 1.0, 0.2);
  Mesh other = mesh;
  const Problem problem = problem_of(mesh, only("local"));
  const Report report = smooth_with(SolverKind::newton, mesh, problem, 1e-10);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_LE(iterations(report), 12u);
  const Report slow = smooth_with(SolverKind::multigrid, other, problem, 1e-10);
  EXPECT_GE(iterations(slow), 10 * iterations(report));
}

TEST(Newton, ConvergesQuadraticallyOnTracks) {
  Ring ring = disturbed_ring();
  const Report report = smooth_with(SolverKind::newton, ring.mesh, ring.problem, 1e-10);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_LE(iterations(report), 8u);
  const std::size_t n = report.history.size();
  EXPECT_LE(report.history[n - 1].gradient,
            10.0 * std::pow(report.history[n - 2].gradient, 2) + 1e-13);
  for (std::size_t v = 48; v < 72; ++v) EXPECT_NEAR(ring.mesh.points()[v].norm(), 1.6, 1e-14);
}

TEST(Newton, UntanglesToTheSameMinimum) {
  Mesh mesh = shapes::irregular_triangles(500, 0.3, 1, 1.0);
  Mesh other = mesh;
  const Problem problem = problem_of(mesh, only("local"));
  const Report report = smooth_with(SolverKind::newton, mesh, problem, 1e-9);
  const Report slow = smooth_with(SolverKind::multigrid, other, problem, 1e-9);
  EXPECT_GT(report.quality_before.inverted, 100u);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_NEAR(report.cost_after, slow.cost_after, 1e-8 * slow.cost_after);
}

TEST(Newton, MeetsDemandsThatAreActive) {
  Mesh mesh = shapes::irregular_triangles(500);
  Mesh other = mesh;
  Problem problem = problem_of(mesh, only("local"));
  problem.validity.min_jacobian = 0.6;
  const Report report = smooth_with(SolverKind::newton, mesh, problem, 1e-8);
  const Report slow = smooth_with(SolverKind::multigrid, other, problem, 1e-8);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_NEAR(report.cost_after, slow.cost_after, 1e-5 * slow.cost_after);
  EXPECT_LT(iterations(report), iterations(slow));
}

TEST(Newton, GetsByWithSpringsInHugePolygons) {
  // A polygon of 80 vertices, with triangles between it and a square of fixed vertices.
  constexpr Index kAround = 80;
  shapes::Random random(3);
  std::vector<Vec3> points;
  std::vector<Index> polygon;
  Cells cells;
  for (Index i = 0; i < kAround; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kAround;
    const Vec3 direction(std::cos(angle), std::sin(angle), 0.0);
    points.push_back((1.0 + 0.01 * random.signed_unit()) * direction);
    points.push_back(1.1 * direction);
    polygon.push_back(2 * i);
    const Index next = (2 * i + 2) % (2 * kAround);
    cells.add(CellKind::triangle, {{2 * i, 2 * i + 1, next + 1}});
    cells.add(CellKind::triangle, {{2 * i, next + 1, next}});
  }
  cells.add(CellKind::polygon, polygon);
  Mesh mesh(points, std::move(cells));
  Mesh other = mesh;
  const Problem problem = problem_of(mesh, only("local"));
  const Report report = smooth_with(SolverKind::newton, mesh, problem, 1e-6);
  const Report slow = smooth_with(SolverKind::multigrid, other, problem, 1e-6);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_NEAR(report.cost_after, slow.cost_after, 1e-8 * slow.cost_after);
}

TEST(Newton, ConvergesOnEveryMesh) {
  for (auto& [name, mesh] : shapes::zoo()) {
    mesh = testing_setup::with_points(mesh, displaced(mesh, problem_of(mesh).motion, 0.03, 11));
    const Problem problem = problem_of(mesh);
    Mesh other = mesh;
    const Report report = smooth_with(SolverKind::newton, mesh, problem, 1e-6, 60);
    const Report slow = smooth_with(SolverKind::multigrid, other, problem, 1e-6);
    // At kinks it gets stuck, and is therefore not chosen.
    if (problem.motion.has_kinks()) {
      EXPECT_EQ(slow.solver, SolverKind::multigrid);
      continue;
    }
    EXPECT_LE(report.cost_after, 1.001 * slow.cost_after + 1e-9 * slow.cost_before) << name;
    EXPECT_EQ(report.stop, slow.stop) << name;
    EXPECT_LE(report.history.size(), slow.history.size() + 5) << name;
  }
}

TEST(Newton, FinishesWhatMultigridWouldNot) {
  Mesh mesh = shapes::quad_grid(40, 1.0, 0.2);
  const Problem problem = problem_of(mesh, only("local"));
  const Report report = smooth_with(SolverKind::automatic, mesh, problem, 1e-9, 80);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_EQ(report.solver, SolverKind::newton);
  EXPECT_GT(report.newton_steps, 0);
  EXPECT_LT(report.newton_steps, 10);
}

TEST(Newton, IsNotCalledWhereMultigridWillDo) {
  Mesh mesh = shapes::irregular_triangles(1000);
  const Report report = smooth_with(SolverKind::automatic, mesh, problem_of(mesh), 1e-6);
  EXPECT_EQ(report.solver, SolverKind::multigrid);
  EXPECT_EQ(report.newton_steps, 0);
}

TEST(Newton, HasTheSameBitsForAnyNumberOfThreads) {
  const Mesh start = shapes::irregular_triangles(6000);  // three chunks
  const Problem problem = problem_of(start);
  std::vector<Vec3> first;
  for (const int threads : {1, 2}) {
    Mesh mesh = start;
    Options options;
    options.solver = SolverKind::newton;
    options.threads = threads;
    options.max_iterations = 2;
    smooth(mesh, problem, options);
    if (threads == 1) first = copy_of(mesh.points());
    ASSERT_EQ(first.size(), mesh.point_count());
    EXPECT_EQ(std::memcmp(first.data(), mesh.points().data(), mesh.points().size_bytes()), 0);
  }
}

}  // namespace
}  // namespace evenmesh
