// SPDX-License-Identifier: MIT
#include "evenmesh/solver/relax.h"

#include <cmath>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/problem/constraints.h"
#include "evenmesh/solver/global_laplacian.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::copy_of;
using testing_setup::farthest;
using testing_setup::only;
using testing_setup::problem_of;

std::vector<Method> classic_methods() {
  std::vector<Method> all;
  for (const std::string_view word : method_names()) all.push_back(method_of(std::string(word)));
  all.erase(all.begin());  // lagrange_newton
  return all;
}

// Without anything that looks after what a method does.
Report smooth_bare(Mesh& mesh, Problem problem, Options options) {
  problem.validity.demanded = false;
  options.judge = Judge::nothing;
  return smooth(mesh, problem, options);
}

class Classic : public ::testing::TestWithParam<Method> {
 protected:
  Options options(int iterations = 30) const {
    return {.method = GetParam(), .max_iterations = iterations};
  }
  bool has_forces() const {
    return GetParam() == Method::lennard_jones || GetParam() == Method::lennard_jones_printed ||
           GetParam() == Method::pliant;
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, Classic, ::testing::ValuesIn(classic_methods()),
                         [](const auto& of) { return std::string(name(of.param)); });

TEST_P(Classic, KeepsThePromiseOnAnIrregularMesh) {
  Mesh mesh = shapes::irregular_triangles(500, 0.35);
  const Mesh input = mesh;
  const Problem problem = problem_of(mesh, only("local"));
  const Report report = smooth(mesh, problem, options());
  EXPECT_EQ(report.method, GetParam());
  EXPECT_EQ(report.quality_before.inverted, 0u);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  for (const Metric metric : kMetrics) {
    EXPECT_FALSE(worse(metric, report.quality_after.of(metric).worst,
                       report.quality_before.of(metric).worst))
        << name(metric);
  }
  EXPECT_GE(report.quality_after.of(Metric::shape).mean,
            report.quality_before.of(Metric::shape).mean);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (problem.motion.freedom(v) != Motion::Freedom::fixed) continue;
    EXPECT_EQ(mesh.points()[v], input.points()[v]);
  }
  EXPECT_GT(report.moved, 0u);
}

TEST_P(Classic, ForcesFoldAnIrregularMeshWithoutTheGuard) {
  if (!has_forces()) return;  // others may or may not
  const Mesh input = shapes::irregular_triangles(500, 0.35);
  const Problem problem = problem_of(input, only("local"));
  Mesh bare = input;
  const Report without = smooth_bare(bare, problem, options());
  EXPECT_EQ(without.quality_before.inverted, 0u);
  EXPECT_GT(without.quality_after.inverted, 0u);
  EXPECT_EQ(without.inverted_unguarded, without.quality_after.inverted);
  EXPECT_EQ(without.history.back().inverted, without.quality_after.inverted);
  EXPECT_EQ(without.pulled_back, 0u);
  EXPECT_EQ(without.promise, Promise::lifted);

  Mesh guarded = input;
  const Report with = smooth(guarded, problem, options());
  EXPECT_EQ(with.inverted_unguarded, without.inverted_unguarded);
  EXPECT_EQ(with.quality_after.inverted, 0u);
  EXPECT_GT(with.pulled_back, 0u);
}

TEST_P(Classic, RecordsTheCostAndTheMoves) {
  Mesh mesh = shapes::irregular_triangles(200, 0.3);
  const Report report = smooth(mesh, problem_of(mesh, only("local")), options(5));
  ASSERT_GE(report.history.size(), 2u);
  EXPECT_EQ(report.history[0].cost, report.cost_before);
  EXPECT_EQ(report.history[0].gradient, 1.0);
  EXPECT_GT(report.history[1].max_move, 0.0);
  EXPECT_NE(report.history[1].cost, report.history[0].cost);
  EXPECT_EQ(report.newton_steps, 0);
  EXPECT_EQ(report.held, 0u);
}

TEST_P(Classic, NeedsNoCosts) {
  Mesh mesh = shapes::irregular_triangles(200, 0.3);
  Problem problem = problem_of(mesh, only("local"));
  Mesh with = mesh;
  smooth(with, problem, options(5));
  problem.terms.clear();
  const Report report = smooth(mesh, problem, options(5));
  EXPECT_EQ(copy_of(mesh.points()), copy_of(with.points()));
  EXPECT_EQ(report.cost_after, 0.0);
}

TEST_P(Classic, HasTheSameBitsForAnyNumberOfThreads) {
  Mesh one = shapes::irregular_triangles(2000, 0.3);
  Mesh two = one;
  const Problem problem = problem_of(one, only("local"));
  Options of_run = options(10);
  const Report first = smooth(one, problem, of_run);
  of_run.threads = 2;
  const Report second = smooth(two, problem, of_run);
  EXPECT_EQ(copy_of(one.points()), copy_of(two.points()));
  EXPECT_EQ(first.cost_after, second.cost_after);
}

TEST_P(Classic, StopsWhenItIsTold) {
  const Mesh input = shapes::irregular_triangles(200, 0.3);
  const Problem problem = problem_of(input, only("local"));
  Mesh mesh = input;
  Options few = options(2);
  few.tolerance = 1e-15;
  const Report limited = smooth(mesh, problem, few);
  EXPECT_EQ(limited.stop, Stop::iteration_limit);

  mesh = input;
  Options asks = few;
  asks.progress = [](const Iteration& i) { return i.number < 1; };
  EXPECT_EQ(smooth(mesh, problem, asks).stop, Stop::interrupted);

  mesh = input;
  Options hurries = few;
  hurries.time_limit_seconds = 1e-9;
  const Report hurried = smooth(mesh, problem, hurries);
  EXPECT_EQ(hurried.stop, Stop::time_limit);
  EXPECT_EQ(hurried.history.size(), 1u);
  EXPECT_EQ(copy_of(mesh.points()), copy_of(input.points()));
}

TEST_P(Classic, BearsEdgesWithoutLengthAndVerticesWithoutCells) {
  Mesh mesh = shapes::irregular_triangles(100, 0.3);
  const Problem with_area = problem_of(mesh, only("local"));
  std::vector<Vec3> points = copy_of(mesh.points());
  Index inside = 0;
  while (with_area.motion.freedom(inside) == Motion::Freedom::fixed) ++inside;
  points[inside + 1] = points[inside];
  Cells cells;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    cells.add(CellKind::triangle, mesh.cells().vertices(c));
  }
  cells.add(CellKind::triangle, std::vector<Index>{inside, inside, inside + 1});
  points.emplace_back(7, 7, 0);  // belongs to no cell
  mesh = Mesh(points, std::move(cells));
  smooth_bare(mesh, problem_of(mesh, only("local")), options(10));
  for (const Vec3& p : mesh.points()) EXPECT_TRUE(p.allFinite());
  EXPECT_EQ(mesh.points().back(), points.back());
}

TEST_P(Classic, KeepsThePromiseOnSurfacesAndVolumes) {
  int tried = 0;
  for (const auto& [called, input] : shapes::zoo()) {
    Mesh mesh = input;
    const Problem problem = problem_of(mesh);
    try {
      check_cells(GetParam(), mesh.cells());
    } catch (const InvalidOption&) {
      continue;
    }
    ++tried;
    const Report report = smooth(mesh, problem, options(5));
    EXPECT_LE(report.quality_after.inverted, report.quality_before.inverted) << called;
    for (const Vec3& p : mesh.points()) ASSERT_TRUE(p.allFinite()) << called;
  }
  EXPECT_GE(tried, 4);
}

TEST_P(Classic, KeepsLimitsOfMoves) {
  Mesh mesh = shapes::irregular_triangles(300, 0.35);
  const Mesh input = mesh;
  Problem problem = problem_of(mesh, only("local"));
  problem.max_move.assign(mesh.point_count(), 0.003);
  const Report report = smooth(mesh, problem, options());
  EXPECT_GT(report.max_move, 0.0);
  EXPECT_LE(farthest(mesh.points(), input.points()), 0.003);
}

TEST(Relax, ConvergedStaysConverged) {
  for (const Method method :
       {Method::laplacian, Method::global_laplacian, Method::optimal_delaunay}) {
    Mesh mesh = shapes::triangle_grid(6, 1.0, 0.2);
    const Problem problem = problem_of(mesh, only("local"));
    const Options options{.method = method, .tolerance = 1e-8, .max_iterations = 1000};
    EXPECT_EQ(smooth(mesh, problem, options).stop, Stop::converged) << name(method);
    const Mesh end = mesh;
    const Report again = smooth(mesh, problem, options);
    EXPECT_EQ(again.history.back().number, 1) << name(method);
    EXPECT_LT(farthest(mesh.points(), end.points()), 1e-8) << name(method);
  }
}

TEST(Relax, FindsThePerfectGrid) {
  // With a fixed boundary it is where all that look at symmetry alone come to rest.
  const auto error = [](Method method, Mesh mesh, const Mesh& perfect) {
    smooth(mesh, problem_of(mesh, only("local")),
           {.method = method, .tolerance = 1e-10, .max_iterations = 2000});
    return farthest(mesh.points(), perfect.points());
  };
  for (const Method method : {Method::laplacian, Method::global_laplacian, Method::angle_based,
                              Method::optimal_delaunay}) {
    EXPECT_LT(error(method, shapes::triangle_grid(6, 1.0, 0.2), shapes::triangle_grid(6)), 1e-8)
        << name(method);
  }
  for (const Method method :
       {Method::laplacian, Method::smart_laplacian, Method::global_laplacian}) {
    EXPECT_LT(error(method, shapes::quad_grid(6, 1.0, 0.3), shapes::quad_grid(6)), 1e-8)
        << name(method);
  }
}

// ---- global_laplacian ----

// The limit of plain sweeps, and one solve.
void expect_the_same_limit(const Mesh& mesh, const Motion& motion, int solves, double tolerance) {
  const Orientation orientation = find_orientation(mesh);
  Workers workers;
  std::vector<Vec3> plain = copy_of(mesh.points());
  Motion::Places places = motion.start();
  const auto laplacian = make_relaxation(Method::laplacian, {mesh, orientation, motion, 1.0});
  for (int i = 0; i < 3000; ++i) laplacian->sweep(workers, plain, places);

  std::vector<Vec3> solved = copy_of(mesh.points());
  Motion::Places there = motion.start();
  GlobalLaplacian global(mesh, motion);
  for (int i = 0; i < solves; ++i) global.sweep(workers, solved, there);
  EXPECT_GT(farthest(solved, mesh.points()), 1e-3) << "nothing to do";
  EXPECT_LT(farthest(plain, solved), tolerance);
}

TEST(GlobalLaplacian, IsTheLimitOfPlainSweeps) {
  const Mesh mesh = shapes::irregular_triangles(400, 0.3);
  expect_the_same_limit(mesh, problem_of(mesh, only("local")).motion, 1, 1e-8);
  const Mesh tets = testing_setup::with_points(
      shapes::tet_grid(4),
      testing_setup::displaced(shapes::tet_grid(4), problem_of(shapes::tet_grid(4)).motion, 0.05,
                               3));
  expect_the_same_limit(tets, problem_of(tets).motion, 1, 1e-8);
}

TEST(GlobalLaplacian, IsTheLimitOfPlainSweepsWhereVerticesSlideAndAreTied) {
  const Mesh mesh = shapes::quad_grid(8, 1.0, 0.3);
  const Orientation orientation = find_orientation(mesh);
  std::vector<char> fixed(mesh.point_count(), 0);
  fixed[0] = fixed[8] = fixed[72] = fixed[80] = 1;
  Motion motion(mesh, orientation, fixed);
  for (Index i = 1; i < 8; ++i) {
    motion.keep_on_line(i, mesh.points()[i], Vec3(1, 0, 0));             // below
    motion.tie(9 * i + 8, 9 * i, mesh.points());                         // left and right
    motion.keep_in_plane(72 + i, mesh.points()[72 + i], Vec3(0, 1, 0));  // above
  }
  expect_the_same_limit(mesh, motion, 1, 1e-8);
}

TEST(GlobalLaplacian, IsTheLimitOfPlainSweepsOnACircle) {
  Mesh mesh = shapes::disk_triangles(200, 3);
  const Orientation orientation = find_orientation(mesh);
  const Topology topology = find_topology(mesh, orientation);
  Problem problem;
  problem.orientation = orientation;
  Constraints constraints;
  // Three vertices stay: fewer would let the others crowd at them.
  constraints.fixed = Selection{"three", std::vector<char>(mesh.point_count(), 0)};
  const auto on_circle =
      static_cast<std::size_t>(std::count(topology.boundary.begin(), topology.boundary.end(), 1));
  for (std::size_t k = 1; k <= 3; ++k) {
    constraints.fixed->vertices[mesh.point_count() - k * on_circle / 3] = 1;
  }
  constraints.slides = {{.selection = {"boundary", topology.boundary}, .on = SlideOn::circle}};
  apply(mesh, topology, constraints, problem);
  expect_the_same_limit(mesh, problem.motion, 60, 1e-7);
}

// ---- what is refused ----

std::string refusal(Method method, const Mesh& mesh, const Problem& problem) {
  Mesh copy = mesh;
  try {
    smooth(copy, problem, {.method = method});
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "";
}

TEST(Relax, RefusesDemandsThatAMethodCannotMeet) {
  const Mesh mesh = shapes::quad_grid(4, 1.0, 0.2);
  Problem problem = problem_of(mesh);
  problem.validity.min_jacobian = 0.1;
  EXPECT_NE(refusal(Method::pliant, mesh, problem)
                .find("the method pliant cannot keep cells above a least size or Jacobian; leave "
                      "the demand out, or choose lagrange_newton"),
            std::string::npos);
  problem = problem_of(mesh);
  EXPECT_NE(refusal(Method::optimal_delaunay, mesh, problem).find("cell 0 is a quad"),
            std::string::npos);
  EXPECT_EQ(refusal(Method::laplacian, mesh, problem), "");
}

TEST(Relax, RefusesToShrinkALooseMeshToAPoint) {
  const Mesh mesh = shapes::quad_grid(3);
  Problem problem;
  problem.orientation = find_orientation(mesh);
  problem.motion = Motion(mesh, problem.orientation, std::vector<char>(mesh.point_count(), 0));
  EXPECT_NE(refusal(Method::laplacian, mesh, problem).find("would shrink to a point"),
            std::string::npos);
  EXPECT_EQ(refusal(Method::lennard_jones, mesh, problem), "");
}

TEST(Relax, ReportsDemandsThatAMethodDoesNotMeet) {
  // The mean of an L's vertices lies outside it; nobody untangles what was given inverted.
  Mesh mesh = shapes::irregular_triangles(200, 0.3, 1, 0.95);
  const Report report =
      smooth(mesh, problem_of(mesh, only("local")), {.method = Method::lennard_jones});
  EXPECT_GT(report.quality_before.inverted, 0u);
  EXPECT_GT(report.quality_after.inverted, 0u);
  EXPECT_GE(report.unmet, report.quality_after.inverted);
}

}  // namespace
}  // namespace evenmesh
