// SPDX-License-Identifier: MIT
//
// What is demanded is met, or reported not to be; what it costs is what others find it costs.
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/constraint/function_of.h"
#include "evenmesh/constraint/keep.h"
#include "evenmesh/constraint/validity.h"
#include "evenmesh/geometry/analytic_tracks.h"
#include "evenmesh/solver/guard.h"
#include "evenmesh/solver/lagrangian.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/smooth.h"
#include "tests/solver/setup.h"
#include "tests/support/ipopt_minima.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::copy_of;
using testing_setup::displaced;
using testing_setup::farthest;
using testing_setup::only;
using testing_setup::problem_of;
using testing_setup::with_points;

std::vector<char> boundary_of(const Mesh& mesh) {
  return find_topology(mesh, find_orientation(mesh)).boundary;
}

void slide_on_unit_circle(const Mesh& mesh, Problem& problem) {
  const auto circle = std::make_shared<CircleTrack>(Vec3::Zero(), Vec3::UnitZ(), 1.0);
  const std::vector<char> boundary = boundary_of(mesh);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (!boundary[v]) continue;
    TrackPoint at;
    at.position = mesh.points()[v];
    problem.motion.put_on_track(v, circle, circle->nearest(at.position, at));
  }
}

double farthest_from_unit_circle(const Mesh& mesh) {
  const std::vector<char> boundary = boundary_of(mesh);
  double most = 0.0;
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (boundary[v]) most = std::max(most, std::abs(mesh.points()[v].norm() - 1.0));
  }
  return most;
}

double least_area(const Mesh& mesh) {
  double least = 1e300;
  const Orientation up = find_orientation(mesh);
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    least = std::min(least, 0.5 * testing_setup::corner_of(mesh, up, c, mesh.points()));
  }
  return least;
}

// ---- against Ipopt -----------------------------------------------------------------------------

class OfIpopt : public testing::TestWithParam<shapes::IpoptMinimum> {};

TEST_P(OfIpopt, MinimumIsFoundFromEveryStart) {
  const shapes::IpoptMinimum& known = GetParam();
  const bool disk = known.shape == "disk";
  Mesh mesh = disk ? shapes::disk_triangles(known.vertices, known.seed, known.noise)
                   : shapes::irregular_triangles(known.vertices, 0.3, known.seed, known.noise);
  Problem problem = problem_of(mesh, only("local"), "boundary");
  if (known.rim == "slide") slide_on_unit_circle(mesh, problem);
  problem.validity.min_size = known.least_area;
  Options options;
  options.judge = Judge::inversion;
  options.max_iterations = 2000;
  const Report report = smooth(mesh, problem, options);
  EXPECT_EQ(report.quality_before.inverted, known.inverted);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  EXPECT_NEAR(report.cost_after, known.cost, 1e-5 * known.cost);
  EXPECT_GE(least_area(mesh), (1.0 - 1e-4) * known.least_area);
  if (disk) {
    EXPECT_LE(farthest_from_unit_circle(mesh), 1e-12);
  }
}

std::vector<shapes::IpoptMinimum> small_minima() {
  std::vector<shapes::IpoptMinimum> result;
  for (const auto& known : shapes::kIpoptMinima) {
    if (known.vertices <= 1000 || known.rim == "fixed") result.push_back(known);
  }
  return result;
}

INSTANTIATE_TEST_SUITE_P(Minima, OfIpopt, testing::ValuesIn(small_minima()));

// ---- validity ----------------------------------------------------------------------------------

TEST(Validity, UntanglesPlanarMeshes) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const double noise : {0.7, 1.0, 2.0}) {
      Mesh mesh = shapes::irregular_triangles(2000, 0.3, seed, noise);
      const Report report = smooth(mesh, problem_of(mesh));
      ASSERT_GT(report.quality_before.inverted, 0u);
      EXPECT_EQ(report.quality_after.inverted, 0u) << "seed " << seed << ", noise " << noise;
      EXPECT_EQ(report.unmet, 0u);
    }
  }
}

TEST(Validity, UntanglesQuadsAndHexes) {
  for (Mesh mesh : {shapes::quad_grid(12, 1.0, 0.8), shapes::hex_grid(5, 0.6)}) {
    const Report report = smooth(mesh, problem_of(mesh));
    ASSERT_GT(report.quality_before.inverted, 0u);
    EXPECT_EQ(report.quality_after.inverted, 0u);
  }
}

TEST(Validity, MinimumIsThatOfTheValidStart) {
  Mesh valid = shapes::irregular_triangles(1000, 0.3, 1, 0.0);
  Mesh tangled = shapes::irregular_triangles(1000, 0.3, 1, 0.9);
  smooth(valid, problem_of(valid));
  smooth(tangled, problem_of(tangled));
  EXPECT_LE(farthest(valid.points(), tangled.points()), 1e-4 / 30.0);
}

TEST(Validity, UntanglingIsPartOfTheRun) {
  const Mesh start = shapes::irregular_triangles(2000, 0.3, 1, 1.0);
  const Problem problem = problem_of(start, only("shape"));
  Options options;
  std::vector<int> numbers;
  options.progress = [&](const Iteration& iteration) {
    numbers.push_back(iteration.number);
    return true;
  };
  Mesh mesh = start;
  const Report report = smooth(mesh, problem, options);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_GT(report.history[0].inverted, 0u);
  EXPECT_EQ(report.history.back().inverted, 0u);
  for (std::size_t i = 0; i < report.history.size(); ++i) {
    EXPECT_EQ(report.history[i].number, static_cast<int>(i));
  }
  EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
  EXPECT_EQ(numbers.back(), report.history.back().number);
  EXPECT_GT(report.quality_after.of(Metric::shape).mean, 0.98);

  options.max_iterations = 4;
  mesh = start;
  EXPECT_EQ(smooth(mesh, problem, options).history.back().number, 4);
  options.progress = [](const Iteration& iteration) { return iteration.number < 1; };
  mesh = start;
  const Report stopped = smooth(mesh, problem, options);
  EXPECT_EQ(stopped.stop, Stop::interrupted);
  EXPECT_EQ(stopped.history.back().number, 1);
}

TEST(Validity, NamesTheCellsThatCannotBeHad) {
  // A square whose boundary is folded over: vertex 1 is dragged across the opposite side.
  Mesh mesh = shapes::triangle_grid(4);
  std::vector<Vec3> points = copy_of(mesh.points());
  points[2] = Vec3(0.5, 1.3, 0.0);
  mesh.set_points(points);
  const Problem problem = problem_of(mesh, {}, "boundary");
  const Report report = smooth(mesh, problem);
  EXPECT_GT(report.unmet, 0u);
  ASSERT_FALSE(report.holding.cells.empty());
  bool touches = false;
  for (const ActiveCell& active : report.holding.cells) {
    const auto cell = mesh.cells().vertices(active.cell);
    touches = touches || std::find(cell.begin(), cell.end(), Index{2}) != cell.end();
  }
  EXPECT_TRUE(touches) << "no cell at the folded vertex is named";
  EXPECT_EQ(mesh.points()[2], points[2]);
}

TEST(Validity, ReportsDemandsThatAreTooGreat) {
  Mesh mesh = shapes::irregular_triangles(500);
  Problem problem = problem_of(mesh);
  problem.validity.min_size = 1.5 * mean_size(mesh, problem.orientation);
  Options options;
  options.judge = Judge::inversion;
  const Report report = smooth(mesh, problem, options);
  EXPECT_GT(report.unmet, 100u);
  EXPECT_EQ(report.quality_after.inverted, 0u);
}

TEST(Validity, DoesNothingWhereItIsMetAnyway) {
  Mesh with = shapes::irregular_triangles(3000);
  Mesh without = with;
  Problem problem = problem_of(with);
  smooth(with, problem);
  problem.validity.demanded = false;
  smooth(without, problem);
  EXPECT_EQ(copy_of(with.points()), copy_of(without.points()));
}

TEST(Validity, SizesAroundDoNotDependOnTangling) {
  const Mesh valid = shapes::irregular_triangles(2000, 0.2, 1, 0.0);
  const Mesh tangled = shapes::irregular_triangles(2000, 0.2, 1, 1.0);
  const auto a = reference_sizes(valid, find_orientation(valid));
  const auto b = reference_sizes(tangled, find_orientation(tangled));
  for (std::size_t c = 0; c < a.size(); ++c) {
    EXPECT_GT(b[c], 0.3 * a[c]);
    EXPECT_LT(b[c], 3.0 * a[c]);
  }
}

// ---- the function ------------------------------------------------------------------------------

TEST(Lagrangian, HasTheGradientOfItsValue) {
  Workers workers;
  for (const auto& [name, mesh] : shapes::zoo()) {
    Problem problem = problem_of(mesh, only("global"), "none");
    problem.validity.min_jacobian = 1.05;  // nearly all rows active
    problem.max_move.assign(mesh.point_count(), 0.01);
    problem.bounds.push_back(
        {function_of("length", {0, 1}, [](auto x) { return (x[1] - x[0]).norm(); }), 2.0, 2.0});
    Objective objective(mesh, problem);
    objective.constrain(workers, mesh, mesh.points());
    std::vector<Vec3> x = displaced(mesh, problem.motion, 0.03, 5);
    for (int round = 0; round < 5; ++round) {
      std::vector<Vec3> gradient(x.size());
      objective.evaluate(workers, x, gradient);
      double size = 0.0;
      for (const Vec3& g : gradient) size = std::max(size, g.norm());
      for (std::size_t v = 0; v < x.size(); v += 5) {
        for (int axis = 0; axis < 3; ++axis) {
          const double at = x[v][axis];
          const double h = 1e-7;
          x[v][axis] = at + h;
          const double after = objective.evaluate(workers, x, {});
          x[v][axis] = at - h;
          const double before = objective.evaluate(workers, x, {});
          x[v][axis] = at;
          ASSERT_NEAR(gradient[v][axis], (after - before) / (2.0 * h), 2e-5 * size)
              << name << ", round " << round;
        }
      }
      // Through the stages of the penalty to the multipliers.
      objective.lagrangian()->advance(workers, x, 100, true);
    }
    EXPECT_EQ(objective.lagrangian()->mode(), Lagrangian::Mode::multipliers) << name;
  }
}

TEST(Lagrangian, HasTheSameBitsForAnyNumberOfThreads) {
  const Mesh input = shapes::irregular_triangles(20000, 0.3, 1, 0.9);
  Mesh first = input;
  Options options;
  options.max_iterations = 25;
  smooth(first, problem_of(first), options);
  for (const int threads : {2, 5}) {
    Mesh mesh = input;
    options.threads = threads;
    smooth(mesh, problem_of(mesh), options);
    EXPECT_EQ(copy_of(mesh.points()), copy_of(first.points())) << threads;
  }
}

// ---- moves, functions --------------------------------------------------------------------------

TEST(MoveLimit, IsKeptAndReported) {
  Mesh mesh = shapes::irregular_triangles(1000);
  const Mesh input = mesh;
  Problem problem = problem_of(mesh);
  problem.max_move.assign(mesh.point_count(), 0.002);
  problem.max_move[500] = std::numeric_limits<double>::infinity();
  const Report report = smooth(mesh, problem);
  EXPECT_GT(report.moved, 500u);
  EXPECT_GT(report.holding.moves.size(), 100u);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    const double move = (mesh.points()[v] - input.points()[v]).norm();
    EXPECT_LE(move, problem.max_move[v] * (1.0 + 1e-6));
  }
  for (const ActiveBound& active : report.holding.moves) EXPECT_GE(active.multiplier, 0.0);
}

TEST(MoveLimit, HasTheMultiplierThatDifferencesGive) {
  const auto cost_with = [](double limit, Report& report) {
    Mesh mesh = shapes::quad_grid(6, 1.0, 0.25, 3);
    Problem problem = problem_of(mesh);
    problem.max_move.assign(mesh.point_count(), std::numeric_limits<double>::infinity());
    problem.max_move[24] = limit;
    Options options;
    options.judge = Judge::inversion;
    options.tolerance = 1e-9;
    report = smooth(mesh, problem, options);
    return report.cost_after;
  };
  Report at, other;
  cost_with(0.02, at);
  ASSERT_EQ(at.holding.moves.size(), 1u);
  const double h = 1e-4;
  const double gain = (cost_with(0.02 - h, other) - cost_with(0.02 + h, other)) / (2.0 * h);
  EXPECT_NEAR(at.holding.moves[0].multiplier, gain, 0.01 * gain);
}

TEST(Function, IsKeptEqual) {
  Mesh mesh = shapes::quad_grid(10, 1.0, 0.2);
  Problem problem = problem_of(mesh);
  const auto length = function_of("length", {60, 61}, [](auto x) { return (x[1] - x[0]).norm(); });
  problem.bounds.push_back({length, 0.15, 0.15});
  Options options;
  options.judge = Judge::inversion;
  const Report report = smooth(mesh, problem, options);
  EXPECT_NEAR(length->at(mesh.points()), 0.15, 1e-6);
  ASSERT_EQ(report.holding.bounds.size(), 1u);

  // The multiplier is the derivative of the least cost with respect to the bound.
  const double h = 1e-3;
  double cost[2];
  for (int i = 0; i < 2; ++i) {
    Mesh other = shapes::quad_grid(10, 1.0, 0.2);
    const double value = 0.15 + (i == 0 ? -h : h);
    problem.bounds = {{length, value, value}};
    cost[i] = smooth(other, problem, options).cost_after;
  }
  const double derivative = (cost[1] - cost[0]) / (2.0 * h);
  EXPECT_NEAR(report.holding.bounds[0].multiplier, derivative, 0.01 * std::abs(derivative));
}

TEST(Function, IsKeptBetweenBothSidesOfAnInterval) {
  for (const auto& [lower, upper, expected] :
       {std::array{0.12, 0.14, 0.12}, std::array{0.05, 0.08, 0.08}, std::array{0.05, 0.2, 0.1}}) {
    Mesh mesh = shapes::quad_grid(10, 1.0, 0.2);
    Problem problem = problem_of(mesh);
    const auto length =
        function_of("length", {60, 61}, [](auto x) { return (x[1] - x[0]).norm(); });
    problem.bounds.push_back({length, lower, upper});
    Options options;
    options.judge = Judge::inversion;
    smooth(mesh, problem, options);
    EXPECT_NEAR(length->at(mesh.points()), expected, 1e-5);
    EXPECT_GE(length->at(mesh.points()), lower * (1.0 - 1e-6));
    EXPECT_LE(length->at(mesh.points()), upper * (1.0 + 1e-6));
  }
}

TEST(Function, OfVerticesThatAreNotThereIsRefused) {
  Mesh mesh = shapes::quad_grid(2);
  Problem problem = problem_of(mesh);
  problem.bounds.push_back({function_of("reach", {3, 99}, [](auto x) { return x[1][0]; })});
  EXPECT_THROW(smooth(mesh, problem), InvalidOption);
  problem.bounds = {{function_of("height", {3}, [](auto x) { return x[0][1]; }), 2.0, 1.0}};
  EXPECT_THROW(smooth(mesh, problem), InvalidOption);
}

TEST(Keep, TotalAreaOfAFreeMeshStays) {
  Mesh mesh = shapes::triangle_grid(12, 1.0, 0.2);
  Problem problem = problem_of(mesh, only("global"), "none");
  const Orientation orientation = find_orientation(mesh);
  problem.bounds.push_back(make_keep(mesh, orientation, Keep::area, {}, 1.3));
  Options options;
  options.judge = Judge::inversion;
  smooth(mesh, problem, options);
  EXPECT_NEAR(problem.bounds[0].function->at(mesh.points()), 1.3, 1e-5);
}

// ---- tied vertices, symmetry -------------------------------------------------------------------

TEST(Periodic, SidesStayImagesOfEachOther) {
  const int n = 12;
  Mesh mesh = shapes::triangle_grid(n, 1.0, 0.2);
  std::vector<Vec3> points = copy_of(mesh.points());
  for (Vec3& p : points) p[1] += 0.1 * std::sin(2.0 * std::numbers::pi * p[0]);
  for (int j = 1; j < n; ++j) {  // left and right side moved alike
    const double shift = 0.03 * std::sin(9.0 * j);
    points[static_cast<std::size_t>(j * (n + 1))][0] += shift;
    points[static_cast<std::size_t>(j * (n + 1) + n)][0] += shift;
  }
  mesh.set_points(points);
  std::vector<char> fixed(mesh.point_count(), 0);  // the rows below and above
  std::fill(fixed.begin(), fixed.begin() + n + 1, 1);
  std::fill(fixed.end() - n - 1, fixed.end(), 1);
  Problem problem = make_problem(mesh, find_orientation(mesh), fixed);
  for (int j = 1; j < n; ++j) {
    problem.motion.tie(static_cast<Index>(j * (n + 1) + n), static_cast<Index>(j * (n + 1)),
                       mesh.points());
  }
  const Report report = smooth(mesh, problem);
  EXPECT_EQ(report.stop, Stop::converged);
  double moved = 0.0;
  for (int j = 0; j <= n; ++j) {
    const Vec3& left = mesh.points()[static_cast<std::size_t>(j * (n + 1))];
    const Vec3& right = mesh.points()[static_cast<std::size_t>(j * (n + 1) + n)];
    EXPECT_NEAR((right - left - Vec3::UnitX()).norm(), 0.0, 1e-14);
    moved = std::max(moved, (left - points[static_cast<std::size_t>(j * (n + 1))]).norm());
  }
  EXPECT_GT(moved, 0.01);
}

TEST(Periodic, SidesGoBackTogether) {
  const int n = 10;
  Workers workers;
  std::size_t pulled_back = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Mesh mesh = shapes::triangle_grid(n, 1.0, 0.2, seed);
    std::vector<char> fixed(mesh.point_count(), 0);
    std::fill(fixed.begin(), fixed.begin() + n + 1, 1);
    Problem problem = make_problem(mesh, find_orientation(mesh), fixed, only("global"));
    for (Index j = 1; j <= n; ++j) {
      problem.motion.tie(j * (n + 1) + n, j * (n + 1), mesh.points());
    }
    Guard guard(workers, mesh, problem.orientation);
    guard.set_motion(&problem.motion);
    std::vector<Vec3> there = displaced(mesh, problem.motion, 0.5 / n, seed + 100);
    Motion::Places places;
    problem.motion.retract(workers, mesh.points(), problem.motion.start(), there, places);
    pulled_back += guard.enforce(workers, there, Judge::quality_and_inversion).pulled_back;
    for (Index j = 1; j <= n; ++j) {
      ASSERT_NEAR((there[j * (n + 1) + n] - there[j * (n + 1)] - Vec3::UnitX()).norm(), 0.0, 1e-14)
          << "seed " << seed;
    }
  }
  EXPECT_GT(pulled_back, 100u);
}

TEST(Guard, SendsVerticesBackAlongTheirTrack) {
  Workers workers;
  const Mesh mesh = shapes::disk_triangles(300);
  Problem problem = problem_of(mesh, only("local"), "boundary");
  slide_on_unit_circle(mesh, problem);
  Guard guard(workers, mesh, problem.orientation);
  guard.set_motion(&problem.motion);
  std::vector<Vec3> there = displaced(mesh, problem.motion, 0.08, 3);
  Motion::Places places;
  problem.motion.retract(workers, mesh.points(), problem.motion.start(), there, places);
  EXPECT_GT(guard.enforce(workers, there, Judge::quality_and_inversion).pulled_back, 10u);
  EXPECT_LE(farthest_from_unit_circle(with_points(mesh, there)), 1e-15);
}

TEST(MoveLimit, OfTiedVerticesIsTheLeastOfBoth) {
  const Index n = 8;
  Mesh mesh = shapes::triangle_grid(8, 1.0, 0.2);
  const Mesh input = mesh;
  std::vector<char> fixed(mesh.point_count(), 0);
  for (std::size_t i = 0; i <= n; ++i) fixed[i] = fixed[fixed.size() - 1 - i] = 1;
  Problem problem = make_problem(mesh, find_orientation(mesh), fixed);
  problem.max_move.assign(mesh.point_count(), 1.0);
  for (Index j = 1; j < n; ++j) {
    problem.motion.tie(j * (n + 1), j * (n + 1) + n, mesh.points());  // followers come first
    problem.max_move[j * (n + 1)] = 1e-3;
  }
  Options options;
  options.max_iterations = 3;  // before the limits are met
  options.judge = Judge::inversion;
  smooth(mesh, problem, options);
  for (Index j = 1; j < n; ++j) {
    for (const Index v : {j * (n + 1), j * (n + 1) + n}) {
      EXPECT_LE((mesh.points()[v] - input.points()[v]).norm(), 1e-3 * (1.0 + 1e-9));
    }
  }
}

// ---- targets -----------------------------------------------------------------------------------

TEST(Targets, AreReachedAndTheInteriorFollows) {
  Mesh mesh = shapes::irregular_triangles(2000);
  const std::vector<char> boundary = boundary_of(mesh);
  Problem problem = problem_of(mesh, {}, "boundary");
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (!boundary[v]) continue;
    const Vec3& p = mesh.points()[v];  // the lower side bulges up to half the height
    const double lift = 0.5 * std::sin(std::numbers::pi * p[0]) * (1.0 - p[1]);
    problem.targets.push_back({v, p + Vec3(0.0, lift, 0.0)});
  }
  const Report report = smooth(mesh, problem);
  EXPECT_GE(report.target_steps, 1);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  for (const Target& target : problem.targets) {
    EXPECT_EQ(mesh.points()[target.vertex], target.position);
  }
}

TEST(Targets, LeaveLimitsOfMovesCountingFromTheInput) {
  Mesh mesh = shapes::irregular_triangles(1000);
  const Mesh input = mesh;
  const std::vector<char> boundary = boundary_of(mesh);
  Problem problem = problem_of(mesh, {}, "boundary");
  problem.max_move.assign(mesh.point_count(), std::numeric_limits<double>::infinity());
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (!boundary[v]) {
      problem.max_move[v] = 0.05;
    } else {
      problem.targets.push_back({v, mesh.points()[v] + Vec3(0.06, 0.0, 0.0)});
    }
  }
  const Report report = smooth(mesh, problem);
  ASSERT_GE(report.target_steps, 1);
  std::size_t at_limit = 0;
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (boundary[v]) continue;
    const double move = (mesh.points()[v] - input.points()[v]).norm();
    EXPECT_LE(move, 0.05 * (1.0 + 1e-9));
    at_limit += move > 0.0499 ? 1 : 0;
  }
  EXPECT_GT(at_limit, 100u);
}

TEST(Targets, CanBeInterruptedOnTheWay) {
  Mesh mesh = shapes::irregular_triangles(500);
  Problem problem = problem_of(mesh, {}, "boundary");
  problem.targets.push_back({0, mesh.points()[0] - Vec3(0.3, 0.3, 0.0)});
  Options options;
  int calls = 0;
  options.progress = [&](const Iteration&) { return ++calls < 2; };
  EXPECT_EQ(smooth(mesh, problem, options).stop, Stop::interrupted);
  EXPECT_LE(calls, 4);
}

TEST(Targets, ARotatedHoleTakesTheMeshAlong) {
  // The inner rim of a ring turned by 90 degrees: far more than a cell's width.
  const int around = 48;
  const int across = 10;
  std::vector<Vec3> points;
  Cells cells;
  for (int j = 0; j <= across; ++j) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / around;
      const double radius = 0.4 + 0.6 * j / across;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  }
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < around; ++i) {
      const auto at = [&](int k, int l) { return static_cast<Index>(l * around + k % around); };
      cells.add(CellKind::triangle, std::array{at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      cells.add(CellKind::triangle, std::array{at(i, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  Mesh mesh(points, std::move(cells));
  Problem problem = problem_of(mesh, {}, "boundary");
  for (Index v = 0; v < around; ++v) {
    problem.targets.push_back({v, Vec3(-points[v][1], points[v][0], 0.0)});
  }
  const Report report = smooth(mesh, problem);
  EXPECT_EQ(report.quality_after.inverted, 0u) << report.target_steps << " steps";
}

}  // namespace
}  // namespace evenmesh
