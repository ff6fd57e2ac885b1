// SPDX-License-Identifier: MIT
#include "evenmesh/solver/guard.h"

#include <memory>
#include <string_view>

#include <gtest/gtest.h>

#include "evenmesh/solver/reorder.h"
#include "evenmesh/solver/smooth.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::copy_of;
using testing_setup::displaced;
using testing_setup::only;
using testing_setup::problem_of;

constexpr Judge kAll = Judge::quality_and_inversion;

std::vector<Vec3> in_single_precision(Points points) {
  std::vector<Vec3> result;
  // One by one: g++ 12 takes Eigen's cast to float and back for nothing.
  const auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  for (const Vec3& p : points) result.emplace_back(rounded(p[0]), rounded(p[1]), rounded(p[2]));
  return result;
}

// A square of four triangles whose centre is vertex 4, judged against a given place of it.
class Square : public testing::Test {
 protected:
  Square() : Square(shapes::fig5(0.1, 0.0)) {}
  explicit Square(const Mesh& mesh)
      : mesh_(mesh), orientation_(find_orientation(mesh_)), guard_(workers_, mesh_, orientation_) {}

  std::vector<Vec3> centre_at(double x, double y) const {
    std::vector<Vec3> points = copy_of(mesh_.points());
    points[4] = Vec3(x, y, 0.0);
    return points;
  }

  Workers workers_;
  Mesh mesh_;
  Orientation orientation_;
  Guard guard_;
};

TEST_F(Square, TheInputItselfIsNoBreach) {
  EXPECT_EQ(guard_.find_breach(workers_, mesh_.points(), kAll), "");
}

TEST_F(Square, FoldsWhereNothingIsJudged) {
  std::vector<Vec3> points = centre_at(1.5, 0.5);
  const std::vector<Vec3> wanted = points;
  EXPECT_EQ(guard_.find_breach(workers_, points, Judge::nothing), "");
  const Guard::Result result = guard_.enforce(workers_, points, Judge::nothing);
  EXPECT_EQ(points, wanted);
  EXPECT_EQ(result.promise, Promise::lifted);
  EXPECT_EQ(result.pulled_back, 0u);
  EXPECT_EQ(result.after.inverted, 1u);
}

TEST_F(Square, ABetterPlaceIsKeptToTheBit) {
  std::vector<Vec3> points = centre_at(0.5, 0.5);
  const std::vector<Vec3> wanted = points;
  const Guard::Result result = guard_.enforce(workers_, points, kAll);
  EXPECT_EQ(result.promise, Promise::kept);
  EXPECT_EQ(result.pulled_back, 0u);
  EXPECT_EQ(points, wanted);
  EXPECT_EQ(result.after.inverted, 0u);
}

TEST_F(Square, AnInversionIsABreach) {
  const std::vector<Vec3> points = centre_at(1.2, 0.5);
  EXPECT_NE(guard_.find_breach(workers_, points, kAll), "");
  EXPECT_NE(guard_.find_breach(workers_, points, Judge::inversion).find("inverted"),
            std::string::npos);
}

TEST_F(Square, AWorseWorstIsABreachOfQualityAlone) {
  const std::vector<Vec3> points = centre_at(0.8, 0.5);
  EXPECT_NE(guard_.find_breach(workers_, points, kAll).find("worse"), std::string::npos);
  EXPECT_EQ(guard_.find_breach(workers_, points, Judge::inversion), "");
}

TEST_F(Square, AStepThatInvertsIsPulledBack) {
  std::vector<Vec3> points = centre_at(-0.1, 0.5);  // through the wall; half-way 0.25, then 0.425
  const Guard::Result result = guard_.enforce(workers_, points, kAll);
  EXPECT_EQ(result.promise, Promise::pulled_back);
  EXPECT_EQ(result.pulled_back, 1u);
  EXPECT_EQ(guard_.find_breach(workers_, points, kAll), "");
  EXPECT_NEAR(points[4][0], 0.425, 1e-12);
}

TEST_F(Square, WhatCannotBeKeptGoesBackToTheBit) {
  std::vector<Vec3> points = centre_at(0.9, 0.5);  // the way there is worse from the first inch
  const Guard::Result result = guard_.enforce(workers_, points, kAll);
  EXPECT_EQ(result.promise, Promise::unimproved);
  EXPECT_EQ(points, copy_of(mesh_.points()));
}

TEST_F(Square, LiftedQualityLetsItGetWorseButNotTurnOver) {
  std::vector<Vec3> points = centre_at(0.9, 0.5);
  const std::vector<Vec3> wanted = points;
  EXPECT_EQ(guard_.enforce(workers_, points, Judge::inversion).promise, Promise::lifted);
  EXPECT_EQ(points, wanted);
  points = centre_at(1.2, 0.5);
  const Guard::Result result = guard_.enforce(workers_, points, Judge::inversion);
  EXPECT_EQ(result.promise, Promise::lifted);
  EXPECT_EQ(result.after.inverted, 0u);
  EXPECT_NEAR(points[4][0], 0.9, 1e-12);  // half-way
}

TEST_F(Square, RoundingIsHonoured) {
  std::vector<Vec3> points = centre_at(0.5 + 1e-9, 0.5 - 1e-9);
  guard_.enforce(workers_, points, kAll, in_single_precision);
  EXPECT_EQ(points[4], Vec3(0.5, 0.5, 0.0));
}

TEST_F(Square, WhatWouldBeSpoiltGoesBack) {
  const auto right_of = [](double x) {
    return [x](Points points) {
      return points[4].x() > x ? std::vector<Index>{4} : std::vector<Index>();
    };
  };
  std::vector<Vec3> points = centre_at(0.5, 0.5);  // it starts at 0.6
  EXPECT_EQ(guard_.enforce(workers_, points, kAll, {}, right_of(0.7)).pulled_back, 0u);
  points = centre_at(0.5, 0.5);
  const auto left_of = [&](Points at) {
    return at[4].x() < 0.54 ? std::vector<Index>{4} : std::vector<Index>();
  };
  EXPECT_EQ(guard_.enforce(workers_, points, kAll, {}, left_of).pulled_back, 1u);
  EXPECT_NEAR(points[4].x(), 0.55, 1e-12);  // half-way
}

// The centre outside the square: the triangle at the wall is inverted from the start.
class Tangled : public Square {
 protected:
  Tangled() : Square(shapes::fig5(0.6, 0.0)) {}
};

TEST_F(Tangled, FurtherOverIsABreach) {
  ASSERT_EQ(guard_.before().inverted, 1u);
  EXPECT_NE(guard_.find_breach(workers_, centre_at(1.2, 0.5), Judge::inversion), "");
  EXPECT_EQ(guard_.find_breach(workers_, centre_at(1.05, 0.5), Judge::inversion), "");
}

// One hex, a cube of size 10 unless it is given; and one that is positive at its corners and along
// its edges, but not between them.
class OneHex : public testing::Test {
 protected:
  static Mesh mesh_of(std::vector<Vec3> points) {
    Cells cells;
    cells.add(CellKind::hex, std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7});
    return Mesh(std::move(points), std::move(cells));
  }
  static std::vector<Vec3> cube() {
    std::vector<Vec3> points;
    for (const auto& p : traits(CellKind::hex).ideal) {
      points.emplace_back(10.0 * p[0], 10.0 * p[1], 10.0 * p[2]);
    }
    return points;
  }
  static std::vector<Vec3> folded(double size = 1.0) {
    std::vector<Vec3> points{{-5, -2, 6},  {5, 6, -6},  {13, 3, 5}, {3, 5, 5},
                             {-2, -5, 12}, {15, -1, 4}, {5, 3, 10}, {-5, 12, 9}};
    for (Vec3& p : points) p *= size;
    return points;
  }

  explicit OneHex(std::vector<Vec3> points)
      : mesh_(mesh_of(std::move(points))),
        orientation_(find_orientation(mesh_)),
        guard_(workers_, mesh_, orientation_) {}
  OneHex() : OneHex(cube()) {}

  Workers workers_;
  Mesh mesh_;
  Orientation orientation_;
  Guard guard_;
};

TEST_F(OneHex, ThatWouldBeInvertedOnlyBetweenItsCornersIsPulledBack) {
  std::vector<Vec3> points = folded();
  ASSERT_GT(testing_setup::corner_of(mesh_, orientation_, 0, points), 0.0);
  EXPECT_NE(guard_.find_breach(workers_, points, Judge::inversion).find("inverted"),
            std::string::npos);
  const Guard::Result result = guard_.enforce(workers_, points, Judge::inversion);
  EXPECT_EQ(result.inverted_unguarded, 1u);
  EXPECT_EQ(result.pulled_back, 8u);
  EXPECT_EQ(result.after.inverted, 0u);
  EXPECT_NE(points, copy_of(mesh_.points()));
  EXPECT_EQ(guard_.find_breach(workers_, points, Judge::inversion), "");
}

// Least where every vertex is in a place of its own.
class Places final : public Cost {
 public:
  explicit Places(std::vector<Vec3> places) : places_(std::move(places)) {}
  std::string_view name() const override { return "places"; }
  double evaluate(const CellBlock& cells, Points x, double weight,
                  std::span<Vec3> gradient) const override {
    double sum = 0.0;
    for (const Index v : cells.vertices) {
      const Vec3 away = x[v] - places_[v];
      sum += away.squaredNorm();
      if (!gradient.empty()) gradient[v] += 2.0 * weight * away;
    }
    return weight * sum;
  }

 private:
  std::vector<Vec3> places_;
};

TEST_F(OneHex, IsNotHandedBackFoldedWhereTheCostIsLeastSo) {
  Mesh mesh = mesh_;
  Problem problem = problem_of(mesh, {}, "none");
  problem.terms = {{1.0, std::make_shared<Places>(folded())}};
  const Report report = smooth(mesh, problem, {.judge = Judge::inversion});
  EXPECT_EQ(report.inverted_unguarded, 1u);
  EXPECT_EQ(report.pulled_back, 8u);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  EXPECT_LT(report.cost_after, report.cost_before);
}

class FoldedHex : public OneHex {
 protected:
  FoldedHex() : OneHex(folded()) {}
};

TEST_F(FoldedHex, IsJudgedByItsInsideAsLongAsItsCornersAreGood) {
  ASSERT_EQ(guard_.before().inverted, 1u);
  EXPECT_EQ(guard_.find_breach(workers_, mesh_.points(), kAll), "");
  // A smaller one has lower corners, but is less inverted inside; with a larger one it is the
  // other way round.
  EXPECT_EQ(guard_.find_breach(workers_, folded(0.9), kAll), "");
  EXPECT_NE(guard_.find_breach(workers_, folded(1.1), kAll).find("more so"), std::string::npos);
  EXPECT_EQ(guard_.find_breach(workers_, cube(), kAll), "");
  std::vector<Vec3> points = cube();
  std::swap(points[0], points[1]);  // a corner turned over
  EXPECT_NE(guard_.find_breach(workers_, points, kAll), "");
}

TEST_F(FoldedHex, IsUnfoldedBySmoothing) {
  Mesh mesh = mesh_;
  const Report report = smooth(mesh, problem_of(mesh, {}, "id:1"));
  EXPECT_EQ(report.quality_before.inverted, 1u);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_EQ(report.promise, Promise::kept);
  EXPECT_GT(report.quality_after.of(Metric::shape).worst, 0.99);
  for (std::size_t i = 0; i < report.history.size(); ++i) {
    EXPECT_EQ(report.history[i].number, static_cast<int>(i));
  }
}

TEST(Guard, NamesABreachOfTheMeanOfShape) {
  // Two squares side by side, both with a centre off its place: improve the bad one a little and
  // spoil the good one a lot, short of the worst.
  Cells cells;
  std::vector<Vec3> points;
  for (const double left : {0.0, 5.0}) {
    const auto first = static_cast<Index>(points.size());
    const Mesh square = shapes::fig5(left == 0.0 ? 0.4 : 0.0, 0.0);
    for (const Vec3& p : square.points()) points.emplace_back(p + Vec3(left, 0, 0));
    for (std::size_t c = 0; c < 4; ++c) {
      std::vector<Index> vertices;
      for (const Index v : square.cells().vertices(c)) vertices.push_back(first + v);
      cells.add(CellKind::triangle, vertices);
    }
  }
  const Mesh mesh(points, std::move(cells));
  const Orientation orientation = find_orientation(mesh);
  Workers workers;
  const Guard guard(workers, mesh, orientation);
  points[4][0] -= 0.05;
  points[9][0] += 0.30;
  EXPECT_NE(guard.find_breach(workers, points, kAll).find("mean of shape"), std::string::npos);
  std::vector<Vec3> kept = points;
  const Guard::Result result = guard.enforce(workers, kept, kAll);
  EXPECT_EQ(guard.find_breach(workers, kept, kAll), "");
  EXPECT_EQ(result.promise, Promise::pulled_back);
  EXPECT_EQ(kept[4], points[4]);  // what improved stays
  EXPECT_GE(result.after.of(Metric::shape).mean, guard.before().of(Metric::shape).mean);
}

class GuardOfTheZoo : public testing::TestWithParam<double> {};

// Whatever it is given, what it gives back holds.
TEST_P(GuardOfTheZoo, ResultAlwaysKeepsThePromise) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Orientation orientation = find_orientation(mesh);
    const Motion motion(mesh, orientation, std::vector<char>(mesh.point_count(), 0));
    Workers workers(2);
    const Guard guard(workers, mesh, orientation);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      for (const Judge judge : {kAll, Judge::inversion}) {
        for (const bool rounded : {false, true}) {
          std::vector<Vec3> points = displaced(mesh, motion, GetParam(), seed);
          // Only what moved is rounded: the input holds no more than the file did.
          const auto rounding = [&](Points x) {
            std::vector<Vec3> result = in_single_precision(x);
            for (std::size_t v = 0; v < x.size(); ++v) {
              if (x[v] == mesh.points()[v]) result[v] = x[v];
            }
            return result;
          };
          const Guard::Result result =
              guard.enforce(workers, points, judge, rounded ? rounding : Guard::Rounding());
          EXPECT_EQ(guard.find_breach(workers, points, judge), "") << name;
          EXPECT_LE(result.after.inverted, guard.before().inverted) << name;
          if (rounded) {
            EXPECT_EQ(points, rounding(points)) << name;
          }
          if (result.promise == Promise::unimproved) {
            EXPECT_EQ(points, copy_of(mesh.points())) << name;
          }
          const QualitySummary now =
              summarize(workers, measure_cells(workers, mesh, points, orientation));
          EXPECT_EQ(result.after.of(Metric::shape).mean, now.of(Metric::shape).mean) << name;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Displacements, GuardOfTheZoo,
                         testing::Values(1e-9, 1e-3, 0.05, 0.5, 10.0));

// Perfect squares beside a few that are turned over: whoever makes room for these has a lower mean.
TEST(Guard, LetsTheMeanFallWhereATangledMeshBecomesValid) {
  Mesh mesh = shapes::quad_grid(10);
  std::vector<Vec3> wanted = displaced(mesh, problem_of(mesh).motion, 0.02, 3);
  std::vector<Vec3> points = copy_of(mesh.points());
  points[5 * 11 + 5] += Vec3(0.15, 0.0, 0.0);
  mesh.set_points(points);
  const Orientation orientation = find_orientation(mesh);
  Workers workers;
  const Guard guard(workers, mesh, orientation);
  ASSERT_GT(guard.before().inverted, 0u);
  const std::vector<Vec3> valid = wanted;
  ASSERT_LT(guard.mean_shape_at(workers, valid), guard.before().of(Metric::shape).mean);
  EXPECT_EQ(guard.find_breach(workers, valid, kAll), "");
  const Guard::Result result = guard.enforce(workers, wanted, kAll);
  EXPECT_EQ(result.promise, Promise::kept);
  EXPECT_FALSE(result.mean_fell);
  EXPECT_EQ(wanted, valid);
  EXPECT_EQ(result.after.inverted, 0u);
}

TEST(Guard, JudgesTheMeanThatTheReportShows) {
  // More cells than one range of a sum: the order in which the mean adds up matters.
  const Mesh mesh = shapes::triangle_grid(120, 1.0, 0.2);
  const Orientation orientation = find_orientation(mesh);
  Workers workers;
  const Guard guard(workers, mesh, orientation);
  const Motion motion(mesh, orientation, std::vector<char>(mesh.point_count(), 0));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    // Changes so small that the mean moves by little more than its rounding.
    const std::vector<Vec3> points = displaced(mesh, motion, 3e-15, seed);
    const QualitySummary after =
        summarize(workers, measure_cells(workers, mesh, points, orientation));
    const bool fell = after.of(Metric::shape).mean < guard.before().of(Metric::shape).mean;
    const std::string breach = guard.find_breach(workers, points, kAll);
    if (!breach.empty() && breach.find("mean") == std::string::npos) continue;
    EXPECT_EQ(breach.find("mean") != std::string::npos, fell) << seed;
  }
}

TEST(Smooth, RoundsWhatItJudges) {
  Mesh mesh = shapes::irregular_triangles(500, 0.3);
  std::vector<Vec3> start = in_single_precision(mesh.points());
  mesh.set_points(start);
  Options options;
  options.representable = in_single_precision;
  const Report report = smooth(mesh, problem_of(mesh), options);
  EXPECT_EQ(copy_of(mesh.points()), in_single_precision(mesh.points()));
  EXPECT_LT(report.cost_after, report.cost_before);
  EXPECT_GT(report.moved, 300u);
}

TEST(Smooth, AsksInTheNumbersOfTheMeshWhatWouldBeSpoilt) {
  // Shuffled, so that the mesh is renumbered on the way.
  const Mesh start = shapes::shuffled(shapes::irregular_triangles(20000, 0.3, 1, 0.6), 1);
  ASSERT_TRUE(reorder_if_poor(start, problem_of(start)).has_value());
  Options options;
  options.max_iterations = 3;
  Mesh free = start;
  smooth(free, problem_of(start), options);
  Index held = 0;
  while ((free.points()[held] - start.points()[held]).norm() < 1e-4) ++held;
  options.spoilt = [&](Points points) {
    return points[held] != start.points()[held] ? std::vector<Index>{held} : std::vector<Index>();
  };
  Mesh kept = start;
  smooth(kept, problem_of(start), options);
  EXPECT_EQ(kept.points()[held], start.points()[held]);
}

TEST(Smooth, LetsQualityGetWorseOnlyWhenAllowed) {
  // `global` with a length the area has no room for buckles the perfect grid.
  ProblemOptions global = only("global");
  global.global_length = 0.3;
  for (const Judge judge : {Judge::quality_and_inversion, Judge::inversion}) {
    const bool allowed = judge == Judge::inversion;
    const Mesh squares = shapes::quad_grid(6);
    const Problem problem = problem_of(squares, global);
    Mesh mesh = testing_setup::with_points(squares, displaced(squares, problem.motion, 1e-3, 1));
    Options options;
    options.judge = judge;
    const Report report = smooth(mesh, problem, options);
    EXPECT_EQ(report.promise == Promise::lifted, allowed);
    EXPECT_EQ(
        report.quality_after.of(Metric::shape).mean < report.quality_before.of(Metric::shape).mean,
        allowed);
    EXPECT_EQ(report.quality_after.inverted, 0u);
  }
}

}  // namespace
}  // namespace evenmesh
