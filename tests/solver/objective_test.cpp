// SPDX-License-Identifier: MIT
#include "evenmesh/solver/objective.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::copy_of;
using testing_setup::displaced;
using testing_setup::only;
using testing_setup::problem_of;
using testing_setup::with_edge_costs;

CellBlock block_of(const Cells& cells, std::size_t c) {
  return {cells.kind(c), static_cast<int>(cells.vertices(c).size()), cells.vertices(c)};
}

TEST(Objective, IsTheWeightedSumOverTermsAndCells) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    ProblemOptions options;
    options.costs = {{"local", 0.7}, {"global", 0.2}, {"barycenter", 3.0}};
    const Problem problem = problem_of(mesh, options);
    double expected = 0.0;
    for (const Term& term : problem.terms) {
      for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
        expected +=
            term.weight * term.cost->evaluate(block_of(mesh.cells(), c), mesh.points(), 1.0, {});
      }
    }
    Workers workers;
    EXPECT_NEAR(Objective(mesh, problem).evaluate(workers, mesh.points(), {}), expected,
                1e-12 * expected)
        << name;
  }
}

// Along everything a vertex may follow the gradient is the derivative; along the rest it is zero.
// @param bound  of the error where the gradient is small, and relative to it
void expect_projected_gradient(const std::string& name, const Mesh& mesh, const Problem& problem,
                               double bound, double relative) {
  const Objective objective(mesh, problem);
  Workers workers;
  std::vector<Vec3> gradient(mesh.point_count());
  const std::vector<Vec3> at = displaced(mesh, problem.motion, 0.02, 3);
  objective.evaluate(workers, at, gradient);
  problem.motion.reduce(workers, problem.motion.start(), gradient);
  std::vector<Vec3> x = at;
  for (std::size_t v = 0; v < x.size(); v += 3) {
    const auto vertex = static_cast<Index>(v);
    const double size = gradient[v].norm();
    EXPECT_NEAR(problem.motion.normal(vertex).dot(gradient[v]), 0.0, 1e-12) << name;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 along = problem.motion.project(vertex, Vec3(Vec3::Unit(axis)));
      const double h = 1e-6;
      x[v] = at[v] + h * along;
      const double after = objective.evaluate(workers, x, {});
      x[v] = at[v] - h * along;
      const double before = objective.evaluate(workers, x, {});
      x[v] = at[v];
      EXPECT_NEAR(gradient[v].dot(along), (after - before) / (2.0 * h), bound + relative * size)
          << name;
      if (problem.motion.freedom(vertex) == Motion::Freedom::fixed) {
        EXPECT_EQ(gradient[v], Vec3(Vec3::Zero())) << name;
      }
    }
  }
}

TEST(Objective, HasTheProjectedGradientOfItsValue) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Problem problem = problem_of(mesh);
    expect_projected_gradient(name, mesh, with_edge_costs(mesh, problem), 1e-7, 0.0);
    expect_projected_gradient(name, mesh, problem, 1e-7, 3e-7);
  }
}

TEST(Objective, HasTheSameBitsForAnyNumberOfThreads) {
  const Mesh mesh = shapes::irregular_triangles(20000);
  const Problem problem = problem_of(mesh);
  const Objective objective(mesh, problem);
  std::vector<Vec3> first(mesh.point_count());
  Workers one;
  const double value = objective.evaluate(one, mesh.points(), first);
  const SymmetricMatrix matrix = objective.majoriser(one, mesh.points());
  for (const int threads : {2, 8}) {
    Workers workers(threads);
    std::vector<Vec3> gradient(mesh.point_count(), Vec3::Constant(1.0));
    EXPECT_EQ(objective.evaluate(workers, mesh.points(), gradient), value);
    EXPECT_EQ(gradient, first);
    EXPECT_EQ(objective.majoriser(workers, mesh.points()).diagonal, matrix.diagonal);
  }
}

// The Laplacian of all springs over the vertices that may move, put together one by one.
Eigen::MatrixXd laplacian(const Mesh& mesh, const Problem& problem) {
  const auto n = static_cast<Eigen::Index>(mesh.point_count());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (const Term& term : problem.terms) {
    for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
      std::vector<Spring> springs;
      term.cost->add_springs(block_of(mesh.cells(), c), mesh.points(), springs);
      for (const Spring& s : springs) {
        result(s.a, s.a) += term.weight * s.stiffness;
        result(s.b, s.b) += term.weight * s.stiffness;
        result(s.a, s.b) -= term.weight * s.stiffness;
        result(s.b, s.a) -= term.weight * s.stiffness;
      }
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    if (problem.motion.freedom(static_cast<Index>(i)) != Motion::Freedom::fixed) continue;
    result.row(i).setZero();
    result.col(i).setZero();
  }
  return result;
}

Eigen::MatrixXd dense(const SymmetricMatrix& matrix) {
  const auto n = static_cast<Eigen::Index>(matrix.rows());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    result(i, i) = matrix.scale * matrix.diagonal[static_cast<std::size_t>(i)];
    for (const auto& e : matrix.off_diagonal.row(static_cast<std::size_t>(i))) {
      EXPECT_EQ(result(i, e.column), 0.0) << "an entry that is there twice";
      result(i, e.column) = matrix.scale * e.value;
    }
  }
  return result;
}

TEST(Majoriser, IsTheLaplacianOfTheSpringsWhereVerticesAreFixed) {
  Workers workers;
  for (const Mesh& mesh : {shapes::triangle_grid(6, 1.0, 0.2), shapes::quad_grid(6, 1.0, 0.2),
                           shapes::hexagons(4), shapes::hex_grid(3, 0.2)}) {
    const Problem problem = problem_of(mesh);
    const Eigen::MatrixXd matrix =
        dense(Objective(mesh, problem).majoriser(workers, mesh.points()));
    const Eigen::MatrixXd expected = laplacian(mesh, problem);
    EXPECT_LE((matrix - expected).cwiseAbs().maxCoeff(), 3e-6 * expected.maxCoeff());
    EXPECT_LE((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 1e-6 * expected.maxCoeff());
  }
}

TEST(Majoriser, IsPositiveDefiniteOnWhatMayMove) {
  Workers workers;
  for (const auto& [name, mesh] : shapes::zoo()) {
    for (const char* fixed : {"boundary+features", "none"}) {
      const Problem problem = problem_of(mesh, only("global"), fixed);
      // What holds vertices with a direction of their own are their projectors.
      if (!problem.motion.slots().empty()) continue;
      const SymmetricMatrix matrix = Objective(mesh, problem).majoriser(workers, mesh.points());
      Eigen::MatrixXd a = dense(matrix);
      for (Eigen::Index i = 0; i < a.rows(); ++i) {
        if (problem.motion.freedom(static_cast<Index>(i)) != Motion::Freedom::fixed) continue;
        EXPECT_EQ(a.row(i).norm(), 0.0) << name;
        a(i, i) = 1.0;
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a, Eigen::EigenvaluesOnly);
      EXPECT_GT(eigen.eigenvalues()[0], 1e-5) << name << ", fixed " << fixed;
    }
  }
}

// Weights and lengths as files may have them: 1 / length^2 is beyond single precision.
TEST(Majoriser, StaysInRangeForAnyUnitOfLength) {
  Workers workers;
  for (const double scale : {1e-30, 1e-22, 1.0, 1e22, 1e30}) {
    const Mesh mesh = shapes::scaled(shapes::triangle_grid(6, 1.0, 0.2), scale);
    ProblemOptions options;
    options.scaling = Scaling::scale_free;
    const Problem problem = problem_of(mesh, options);
    const SymmetricMatrix matrix = Objective(mesh, problem).majoriser(workers, mesh.points());
    for (std::size_t v = 0; v < mesh.point_count(); ++v) {
      EXPECT_TRUE(std::isfinite(matrix.diagonal[v]));
      EXPECT_EQ(matrix.diagonal[v] > 0.0f,
                problem.motion.freedom(static_cast<Index>(v)) != Motion::Freedom::fixed);
    }
  }
}

}  // namespace
}  // namespace evenmesh
