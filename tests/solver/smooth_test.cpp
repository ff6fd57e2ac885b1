// SPDX-License-Identifier: MIT
//
// What holds for every run of smooth(), whatever the mesh: monotone cost, fixed bits, stops.
#include "evenmesh/solver/smooth.h"

#include <atomic>
#include <bit>
#include <cstring>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/solver/reorder.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::copy_of;
using testing_setup::corner_of;
using testing_setup::displaced;
using testing_setup::farthest;
using testing_setup::only;
using testing_setup::problem_of;
using testing_setup::with_points;

bool same_bits(Points a, Points b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

// Every mesh of the zoo, disturbed, with all but boundary, features and corners free to move.
std::vector<shapes::Named> disturbed_zoo() {
  std::vector<shapes::Named> all = shapes::zoo();
  for (auto& [name, mesh] : all) {
    const Problem problem = problem_of(mesh);
    mesh = with_points(mesh, displaced(mesh, problem.motion, 0.03, 11));
  }
  return all;
}

TEST(Smooth, NeverRaisesTheCost) {
  for (auto& [name, mesh] : disturbed_zoo()) {
    const Report report = smooth(mesh, problem_of(mesh));
    for (std::size_t i = 1; i < report.history.size(); ++i) {
      const double before = report.history[i - 1].cost;
      if (report.history[i].function != report.history[i - 1].function) continue;
      EXPECT_LE(report.history[i].cost, before + 1e-12 * before) << name << ", iteration " << i;
    }
  }
}

TEST(Smooth, KeepsThePromiseOnEveryMesh) {
  for (auto& [name, mesh] : disturbed_zoo()) {
    const Mesh input = mesh;
    const Problem problem = problem_of(mesh);
    const Report report = smooth(mesh, problem);
    EXPECT_LE(report.quality_after.inverted, report.quality_before.inverted) << name;
    for (const Metric metric : kMetrics) {
      if (report.quality_before.inverted > 0) break;  // getting rid of those comes first
      EXPECT_FALSE(worse(metric, report.quality_after.of(metric).worst,
                         report.quality_before.of(metric).worst))
          << name;
    }
    EXPECT_GE(report.quality_after.of(Metric::shape).mean,
              report.quality_before.of(Metric::shape).mean)
        << name;
    for (std::size_t v = 0; v < mesh.point_count(); ++v) {
      if (problem.motion.freedom(static_cast<Index>(v)) != Motion::Freedom::fixed) continue;
      EXPECT_TRUE(same_bits(mesh.points().subspan(v, 1), input.points().subspan(v, 1))) << name;
    }
  }
}

TEST(Smooth, ReportsTheQualityOfTheMeshItHandsBack) {
  Mesh mesh = shapes::irregular_triangles(500, 0.3, 1, 0.3);
  const Problem problem = problem_of(mesh);
  const Report report = smooth(mesh, problem);
  Workers workers;
  const QualitySummary now =
      summarize(workers, measure_cells(workers, mesh, mesh.points(), problem.orientation));
  for (const Metric metric : kMetrics) {
    EXPECT_EQ(report.quality_after.of(metric).worst, now.of(metric).worst);
    EXPECT_EQ(report.quality_after.of(metric).mean, now.of(metric).mean);
  }
  EXPECT_EQ(report.vertices, mesh.point_count());
  EXPECT_GE(report.movable, report.moved);
  EXPECT_GE(report.max_move, report.mean_move);
}

TEST(Smooth, KeepsTheSignOfAZeroInFixedVertices) {
  Mesh mesh = shapes::triangle_grid(4, 1.0, 0.2);
  std::vector<Vec3> points = copy_of(mesh.points());
  for (Vec3& p : points) p[2] = -0.0;
  mesh.set_points(points);
  const Problem problem = problem_of(mesh);
  smooth(mesh, problem);
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (problem.motion.freedom(static_cast<Index>(v)) != Motion::Freedom::fixed) continue;
    EXPECT_TRUE(std::signbit(mesh.points()[v][2])) << "vertex " << v;
  }
}

TEST(Smooth, StaysWhereItHasConverged) {
  const double h = 1.0 / 20.0;
  for (const std::string_view cost : {"local", "global"}) {
    Mesh mesh = shapes::irregular_triangles(400, 0.25);
    Problem problem = problem_of(mesh, only(cost));
    Options options;
    options.tolerance = 1e-8;
    options.judge = Judge::inversion;  // what the guard pulls back would start off again
    ASSERT_EQ(smooth(mesh, problem, options).stop, Stop::converged);
    const Mesh once = mesh;
    options.tolerance = 1e-6;
    const Report again = smooth(mesh, problem, options);
    EXPECT_LE(again.history.size(), 3u) << cost;  // the input and at most two steps
    EXPECT_LE(farthest(mesh.points(), once.points()), 1e-6 * h) << cost;
  }
}

TEST(Smooth, HasTheSameBitsForAnyNumberOfThreads) {
  // Ten chunks of vertices and of rows. In good order and in a poor one.
  const Mesh good = shapes::irregular_triangles(20000, 0.3, 1, 0.3);
  for (const Mesh& start : {good, shapes::shuffled(good, 3)}) {
    std::vector<Vec3> first;
    for (const int threads : {1, 2, 8}) {
      Mesh mesh = start;
      Options options;
      options.threads = threads;
      options.max_iterations = 8;
      smooth(mesh, problem_of(mesh), options);
      if (threads == 1) first = copy_of(mesh.points());
      EXPECT_TRUE(same_bits(mesh.points(), first)) << threads;
    }
  }
}

TEST(Smooth, HasTheSameBitsForAnyNumberOfThreadsOnTangledQuads) {
  const Mesh start = shapes::quad_grid(80, 1.0, 0.7);  // four chunks, many steps limited
  std::vector<Vec3> first;
  for (const int threads : {1, 2, 8}) {
    Mesh mesh = start;
    Options options;
    options.threads = threads;
    options.max_iterations = 8;
    smooth(mesh, problem_of(mesh), options);
    if (threads == 1) first = copy_of(mesh.points());
    EXPECT_TRUE(same_bits(mesh.points(), first)) << threads;
  }
}

// Another order rounds differently and aggregates differently on the way, to the same minimum.
TEST(Smooth, ComesToTheSameMeshInAnyOrder) {
  const Mesh start = shapes::irregular_triangles(20000, 0.2);
  shapes::Renumbering at;
  Mesh shuffled = shapes::shuffled(start, 5, &at);
  ASSERT_TRUE(reorder_if_poor(shuffled, problem_of(shuffled)).has_value());
  Mesh mesh = start;
  Options options;
  options.tolerance = 1e-11;
  options.judge = Judge::inversion;  // the guard decides cell by cell and may fall either way
  smooth(mesh, problem_of(mesh), options);
  smooth(shuffled, problem_of(shuffled), options);
  double most = 0.0;
  for (std::size_t v = 0; v < mesh.point_count(); ++v) {
    most = std::max(most, (shuffled.points()[at.vertices[v]] - mesh.points()[v]).norm());
  }
  EXPECT_LE(most, 1e-9);
  EXPECT_GT(farthest(mesh.points(), start.points()), 1e-4);
}

class Equivariance : public testing::TestWithParam<double> {};

TEST_P(Equivariance, UnderTurnsShiftsAndScaling) {
  const double scale = GetParam();
  const auto change = [&](const Mesh& mesh) {
    return shapes::scaled(shapes::moved(shapes::rotated(mesh, Vec3(1, 2, 3), 0.7), Vec3(1, -2, 3)),
                          scale);
  };
  for (const char* cost : {"local", "global"}) {
    const Mesh start = shapes::irregular_triangles(500, 0.25);
    Mesh mesh = start;
    Mesh other = change(start);
    Options options;
    options.tolerance = 1e-11;
    options.judge = Judge::inversion;
    smooth(mesh, problem_of(mesh, only(cost)), options);
    smooth(other, problem_of(other, only(cost)), options);
    EXPECT_LE(farthest(other.points(), change(mesh).points()), 1e-9 * scale) << cost;
  }
}

INSTANTIATE_TEST_SUITE_P(Scales, Equivariance, testing::Values(1.0, 1e-3, 1e6));

// ---- stops ----

Mesh jittered() { return shapes::irregular_triangles(500, 0.3); }

TEST(Stops, AtTheIterationLimit) {
  Mesh mesh = jittered();
  Options options;
  options.max_iterations = 3;
  const Report report = smooth(mesh, problem_of(mesh), options);
  EXPECT_EQ(report.stop, Stop::iteration_limit);
  EXPECT_EQ(report.history.size(), 4u);
}

TEST(Stops, BeforeTheFirstStepIfNoneIsAllowed) {
  Mesh mesh = jittered();
  const Mesh input = mesh;
  Options options;
  options.max_iterations = 0;
  const Report report = smooth(mesh, problem_of(mesh), options);
  EXPECT_EQ(report.stop, Stop::iteration_limit);
  EXPECT_TRUE(same_bits(mesh.points(), input.points()));
  EXPECT_EQ(report.moved, 0u);
}

TEST(Stops, AtTheTimeLimit) {
  Mesh mesh = jittered();
  Options options;
  options.time_limit_seconds = 1e-9;
  EXPECT_EQ(smooth(mesh, problem_of(mesh), options).stop, Stop::time_limit);
}

TEST(Stops, WhenTheCallbackSaysSo) {
  Mesh mesh = jittered();
  Options options;
  options.progress = [](const Iteration& iteration) { return iteration.number < 2; };
  const Report report = smooth(mesh, problem_of(mesh), options);
  EXPECT_EQ(report.stop, Stop::interrupted);
  EXPECT_EQ(report.history.back().number, 2);
  EXPECT_LT(report.cost_after, report.cost_before);  // what was reached is kept
}

TEST(Stops, AfterTheCallbackHasSeenEveryIteration) {
  Mesh mesh = jittered();
  std::vector<int> seen;
  Options options;
  options.progress = [&](const Iteration& iteration) {
    seen.push_back(iteration.number);
    return true;
  };
  const Report report = smooth(mesh, problem_of(mesh), options);
  ASSERT_EQ(report.stop, Stop::converged);
  ASSERT_EQ(seen.size(), report.history.size());
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], static_cast<int>(i));
}

TEST(Stops, WhenEveryVertexIsFixed) {
  Mesh mesh = jittered();
  const Mesh input = mesh;
  const Report report = smooth(mesh, problem_of(mesh, {}, "all"));
  EXPECT_EQ(report.stop, Stop::nothing_to_move);
  EXPECT_EQ(report.quality_after.cells, mesh.cells().size());
  EXPECT_TRUE(same_bits(mesh.points(), input.points()));
}

TEST(Stops, AtOnceOnAnEmptyMesh) {
  Mesh mesh;
  EXPECT_EQ(smooth(mesh, problem_of(mesh)).stop, Stop::nothing_to_move);
}

TEST(Stops, AtOnceOnAnIdealMesh) {
  Mesh mesh = shapes::quad_grid(8);
  const Mesh input = mesh;
  const Report report = smooth(mesh, problem_of(mesh));
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_EQ(report.history.size(), 1u);
  EXPECT_TRUE(same_bits(mesh.points(), input.points()));
}

TEST(Stops, WithoutDescentWhereTheCostIsNotANumber) {
  struct Broken final : Cost {
    std::string_view name() const override { return "broken"; }
    double evaluate(const CellBlock&, Points, double, std::span<Vec3>) const override {
      return std::numeric_limits<double>::quiet_NaN();
    }
  };
  Mesh mesh = jittered();
  const Mesh input = mesh;
  Problem problem = problem_of(mesh);
  problem.terms = {{1.0, std::make_shared<Broken>()}};
  EXPECT_EQ(smooth(mesh, problem).stop, Stop::no_descent);
  EXPECT_TRUE(same_bits(mesh.points(), input.points()));
}

TEST(Stops, RefusesOptionsOutsideTheirRange) {
  Mesh mesh = jittered();
  const Problem problem = problem_of(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [&](auto change) {
    Options options;
    change(options);
    EXPECT_THROW(smooth(mesh, problem, options), InvalidOption);
  };
  for (const double bad : {0.0, 1.0, -1e-6, nan}) {
    refuses([&](Options& options) { options.tolerance = bad; });
  }
  for (const double bad : {-1.0, nan}) {
    refuses([&](Options& options) { options.time_limit_seconds = bad; });
  }
  refuses([](Options& options) { options.max_iterations = -1; });
  refuses([](Options& options) { options.threads = -1; });
}

// ---- hostile numbers ----

class Sizes : public testing::TestWithParam<double> {};

TEST_P(Sizes, DoNotMakeItFail) {
  Mesh mesh = shapes::scaled(shapes::triangle_grid(6, 1.0, 0.3), GetParam());
  const Report report = smooth(mesh, problem_of(mesh));
  for (const Vec3& p : mesh.points()) EXPECT_TRUE(p.allFinite());
  EXPECT_EQ(report.quality_after.inverted, 0u);
  EXPECT_GE(report.quality_after.of(Metric::shape).mean,
            report.quality_before.of(Metric::shape).mean);
}

INSTANTIATE_TEST_SUITE_P(Extreme, Sizes, testing::Values(1e99, 1e30, 1e-30, 1e-99));

TEST(Smooth, RefusesSizesWhoseSquaresLeaveTheRangeOfDouble) {
  for (const double size : {1e300, 1e160, 1e101, 1e-101, 1e-160, 1e-300}) {
    Mesh mesh = shapes::scaled(shapes::triangle_grid(6, 1.0, 0.3), size);
    const std::vector<Vec3> before = copy_of(mesh.points());
    EXPECT_THROW(smooth(mesh, problem_of(mesh)), InvalidOption) << size;
    EXPECT_EQ(copy_of(mesh.points()), before);
  }
}

// A valid mesh that one long wave bends until areas differ by a factor of 20: the step to the
// minimiser is many cells long, and no single vertex is to blame where cells would turn over.
TEST(Smooth, StraightensABentMesh) {
  Mesh mesh = shapes::irregular_triangles(20000);
  const Problem problem = problem_of(mesh);
  std::vector<Vec3> points = copy_of(mesh.points());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double shift = 0.12 * std::sin(2.0 * std::numbers::pi * points[v].x()) *
                         std::sin(2.0 * std::numbers::pi * points[v].y());
    points[v] += problem.motion.project(static_cast<Index>(v), shift * Vec3(1.0, 0.7, 0.0));
  }
  Mesh straight = mesh;
  smooth(straight, problem, {.judge = Judge::inversion});
  mesh.set_points(std::move(points));
  const Report report = smooth(mesh, problem);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_EQ(report.held, 0u);
  EXPECT_EQ(report.quality_before.inverted, 0u);
  EXPECT_LT(farthest(mesh.points(), straight.points()), 1e-4 / std::sqrt(20000.0));
}

TEST(Smooth, SurvivesCellsWithoutSize) {
  // A quad grid, one column of which is squeezed to nothing, and a vertex listed twice in a cell.
  for (const bool scale_free : {false, true}) {
    Mesh grid = shapes::triangle_grid(6, 1.0, 0.1);
    std::vector<Vec3> points = copy_of(grid.points());
    points[8] = points[9] = points[15];
    points[24] = points[25] + Vec3(1e-30, 0, 0);
    Cells cells;
    for (std::size_t c = 0; c < grid.cells().size(); ++c) {
      cells.add(grid.cells().kind(c), grid.cells().vertices(c));
    }
    cells.add(CellKind::triangle, std::vector<Index>{16, 16, 17});
    Mesh mesh(points, std::move(cells));
    ProblemOptions options;
    if (scale_free) options.scaling = Scaling::scale_free;
    const Report report = smooth(mesh, problem_of(mesh, options));
    EXPECT_LE(report.quality_after.inverted, report.quality_before.inverted);
    EXPECT_LT(report.cost_after, report.cost_before);
    for (const Vec3& p : mesh.points()) EXPECT_TRUE(p.allFinite());
  }
}

// A piece that nothing holds has no place of its own: only its shape is to change.
TEST(Smooth, DoesNotCarryFreePiecesAway) {
  for (const int n : {3, 24}) {
    Mesh mesh = shapes::two_components(n);
    const Orientation orientation = find_orientation(mesh);
    // The first piece is held at its boundary, the second nowhere.
    std::vector<char> fixed(mesh.point_count(), 0);
    const Topology topology = find_topology(mesh, orientation);
    for (std::size_t v = 0; v < fixed.size() / 2; ++v) fixed[v] = topology.boundary[v];
    const auto middle = [&] {
      Vec3 sum = Vec3::Zero();
      for (std::size_t v = fixed.size() / 2; v < fixed.size(); ++v) sum += mesh.points()[v];
      return Vec3(sum / static_cast<double>(fixed.size() - fixed.size() / 2));
    };
    const Problem problem = make_problem(mesh, orientation, fixed, only("global"));
    mesh = with_points(mesh, displaced(mesh, problem.motion, 0.1 / n, 2));
    const Vec3 before = middle();
    Options options;
    options.judge = Judge::inversion;
    smooth(mesh, problem, options);
    EXPECT_LE((middle() - before).norm(), 0.05 / n) << n;  // a twentieth of a cell
  }
}

}  // namespace
}  // namespace evenmesh
