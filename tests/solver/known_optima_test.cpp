// SPDX-License-Identifier: MIT
//
// Problems whose minimiser is known: the figures of the paper, and grids at the edge of buckling.
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "evenmesh/cost/global.h"
#include "evenmesh/solver/smooth.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::displaced;
using testing_setup::farthest;
using testing_setup::only;
using testing_setup::problem_of;
using testing_setup::with_points;

class PaperFigures : public testing::TestWithParam<std::string> {};

TEST_P(PaperFigures, Figure5ComesToTheCentreOfTheSquare) {
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.3 + 2.0 * std::numbers::pi * k / 12.0;
    Mesh mesh = shapes::fig5(0.4 * std::cos(angle), 0.4 * std::sin(angle));
    const Report report = smooth(mesh, problem_of(mesh, only(GetParam())));
    EXPECT_EQ(report.stop, Stop::converged);
    EXPECT_NEAR((mesh.points()[4] - Vec3(0.5, 0.5, 0.0)).norm(), 0.0, 1e-6) << "angle " << angle;
  }
}

TEST_P(PaperFigures, Figure7ComesToFourSquares) {
  const Mesh squares = shapes::quad_grid(2);
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.3 + 2.0 * std::numbers::pi * k / 12.0;
    std::vector<Vec3> points = testing_setup::copy_of(squares.points());
    points[4] += 0.2 * Vec3(std::cos(angle), std::sin(angle), 0.0);  // 0.4 of a cell's width
    Mesh mesh = with_points(squares, points);
    smooth(mesh, problem_of(mesh, only(GetParam())));
    EXPECT_LE(farthest(mesh.points(), squares.points()), 1e-6) << "angle " << angle;
  }
}

// The mean edge length of these starts is about 1.04 h, below the 1.072 h at which a 6 x 6 grid
// buckles under `global` (see Buckling), so that squares are the minimum for both costs.
TEST_P(PaperFigures, Figure9ComesToSquares) {
  const Mesh squares = shapes::quad_grid(6);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Mesh mesh = shapes::quad_grid(6, 1.0, 0.4, seed);
    ASSERT_LE(6.0 * mean_edge_length(mesh), 1.0 + std::pow(std::tan(std::numbers::pi / 12.0), 2));
    const Report report = smooth(mesh, problem_of(mesh, only(GetParam())));
    EXPECT_LE(farthest(mesh.points(), squares.points()), 1e-6)
        << "seed " << seed << " " << name(report.stop) << " " << name(report.promise) << " after "
        << report.history.size() - 1;
  }
}

INSTANTIATE_TEST_SUITE_P(Costs, PaperFigures, testing::Values("local", "global"),
                         [](const auto& variant) { return variant.param; });

// A grid of n x n unit squares with a fixed boundary, all edges pulled towards L > 1, is under
// compression and a minimiser only while L - 1 <= tan^2(pi / (2 n)).
class Buckling : public testing::TestWithParam<int> {
 protected:
  // How far from the squares smoothing ends when it starts a little beside them.
  double distance_from_squares(double part_of_excess) {
    const int n = GetParam();
    const double excess = std::pow(std::tan(std::numbers::pi / (2.0 * n)), 2);
    const Mesh squares = shapes::quad_grid(n, n);
    ProblemOptions global = only("global");
    global.global_length = 1.0 + part_of_excess * excess;
    const Problem problem = problem_of(squares, global);
    Mesh mesh = with_points(squares, displaced(squares, problem.motion, 1e-3, 5));
    Options options;
    options.judge = Judge::inversion;  // a buckled grid has worse cells
    options.tolerance = 1e-9;
    options.max_iterations = 2000;
    smooth(mesh, problem, options);
    return farthest(mesh.points(), squares.points());
  }
};

TEST_P(Buckling, DoesNotHappenBelowTheCriticalLength) {
  EXPECT_LE(distance_from_squares(0.9), 1e-5);
}

TEST_P(Buckling, HappensAboveTheCriticalLength) { EXPECT_GE(distance_from_squares(1.1), 0.01); }

INSTANTIATE_TEST_SUITE_P(Grids, Buckling, testing::Values(4, 6, 10, 20),
                         [](const auto& variant) { return std::to_string(variant.param); });

}  // namespace
}  // namespace evenmesh
