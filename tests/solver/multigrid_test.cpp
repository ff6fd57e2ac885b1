// SPDX-License-Identifier: MIT
#include "evenmesh/solver/multigrid.h"

#include <cstring>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "evenmesh/cost/global.h"
#include "evenmesh/solver/coarsen.h"
#include "evenmesh/solver/objective.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::only;
using testing_setup::problem_of;

SymmetricMatrix majoriser_of(const Mesh& mesh, std::string_view fixed = "boundary") {
  Workers workers;
  const Problem problem = problem_of(mesh, only("global"), fixed);
  return Objective(mesh, problem).majoriser(workers, mesh.points());
}

std::vector<Vec3> random_vectors(std::size_t n, std::uint64_t seed) {
  shapes::Random random(seed);
  std::vector<Vec3> result(n);
  for (Vec3& v : result) v = {random.signed_unit(), random.signed_unit(), random.signed_unit()};
  return result;
}

double inner(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

std::vector<Vec3> times(const SymmetricMatrix& matrix, const std::vector<Vec3>& x) {
  std::vector<Vec3> y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    y[i] = matrix.diagonal[i] * x[i];
    for (const auto& entry : matrix.off_diagonal.row(i)) y[i] += entry.value * x[entry.column];
    y[i] *= matrix.scale;
  }
  return y;
}

// Random on the rows that have an unknown, zero elsewhere.
std::vector<Vec3> random_right_side(const SymmetricMatrix& matrix, std::uint64_t seed) {
  std::vector<Vec3> r = random_vectors(matrix.rows(), seed);
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (!(matrix.diagonal[i] > 0.0f)) r[i] = Vec3::Zero();
  }
  return r;
}

std::vector<Vec3> applied(Multigrid& multigrid, const std::vector<Vec3>& r, int threads = 1) {
  Workers workers(threads);
  std::vector<Vec3> z(r.size(), Vec3::Constant(7.0));
  multigrid.apply(workers, r, z);
  return z;
}

// Iterations that preconditioned conjugate gradients take to a residual of 1e-6.
int iterations_on(const SymmetricMatrix& matrix) {
  Workers workers;
  Multigrid multigrid(workers, matrix);
  std::vector<Vec3> x(matrix.rows(), Vec3::Zero());
  std::vector<Vec3> r = random_right_side(matrix, 1);
  const double start = inner(r, r);
  std::vector<Vec3> z = applied(multigrid, r);
  std::vector<Vec3> p = z;
  double rz = inner(r, z);
  for (int i = 1; i <= 100; ++i) {
    const std::vector<Vec3> ap = times(matrix, p);
    const double alpha = rz / inner(p, ap);
    for (std::size_t k = 0; k < x.size(); ++k) {
      x[k] += alpha * p[k];
      r[k] -= alpha * ap[k];
    }
    if (inner(r, r) <= 1e-12 * start) return i;
    z = applied(multigrid, r);
    const double beta = inner(r, z) / rz;
    rz *= beta;
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = z[k] + beta * p[k];
  }
  return 101;
}

TEST(Multigrid, IsSymmetricAndPositiveDefinite) {
  const SymmetricMatrix matrix = majoriser_of(shapes::irregular_triangles(6000));
  Workers workers;
  Multigrid multigrid(workers, matrix);
  ASSERT_GE(multigrid.levels(), 2);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto u = random_right_side(matrix, seed);
    const auto v = random_right_side(matrix, seed + 100);
    const auto mu = applied(multigrid, u);
    const auto mv = applied(multigrid, v);
    const double size = std::sqrt(inner(u, mu) * inner(v, mv));
    EXPECT_NEAR(inner(u, mv), inner(v, mu), 1e-5 * size);
    EXPECT_GT(inner(u, mu), 0.0);
  }
}

TEST(Multigrid, IsTheInverseWhereOneLevelIsEnough) {
  const SymmetricMatrix matrix = majoriser_of(shapes::triangle_grid(15, 1.0, 0.2));
  Workers workers;
  Multigrid multigrid(workers, matrix);
  ASSERT_EQ(multigrid.levels(), 1);
  const auto x = random_right_side(matrix, 3);
  const auto again = applied(multigrid, times(matrix, x));
  EXPECT_LE(testing_setup::farthest(again, x), 1e-3);  // single precision, condition about 100
}

TEST(Multigrid, NeedsAsManyIterationsOnFineMeshesAsOnCoarse) {
  int least = 1000;
  int most = 0;
  for (const int n : {32, 64, 128, 256}) {
    const int iterations = iterations_on(majoriser_of(shapes::triangle_grid(n)));
    least = std::min(least, iterations);
    most = std::max(most, iterations);
  }
  EXPECT_LE(most, 15);
  EXPECT_LE(most - least, 3);
}

TEST(Multigrid, TakesIrregularMeshesAndVolumesToo) {
  EXPECT_LE(iterations_on(majoriser_of(shapes::irregular_triangles(30000))), 15);
  EXPECT_LE(iterations_on(majoriser_of(shapes::hex_grid(20))), 15);
}

TEST(Multigrid, LeavesRowsWithoutUnknownAlone) {
  for (const int n : {10, 40}) {
    const SymmetricMatrix matrix = majoriser_of(shapes::triangle_grid(n));
    Workers workers;
    Multigrid multigrid(workers, matrix);
    const auto z = applied(multigrid, random_vectors(matrix.rows(), 1));
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (matrix.diagonal[i] > 0.0f) continue;
      EXPECT_EQ(z[i], Vec3(Vec3::Zero()));
    }
  }
}

TEST(Multigrid, StaysBoundedWhereNothingIsFixed) {
  // Also with a vertex that no cell uses, which counts as fixed but holds nothing.
  for (const int n : {6, 40}) {
    const Mesh grid = shapes::triangle_grid(n);
    std::vector<Vec3> points = testing_setup::copy_of(grid.points());
    points.emplace_back(5, 5, 0);
    for (const Mesh& mesh : {grid, Mesh(points, grid.cells())}) {
      const SymmetricMatrix matrix = majoriser_of(mesh, "none");
      Workers workers;
      Multigrid multigrid(workers, matrix);
      // Forces that push the mesh as a whole, which no spring holds against.
      const auto z = applied(multigrid, std::vector<Vec3>(matrix.rows(), Vec3(1, 0, 0)));
      for (const Vec3& v : z) EXPECT_LE(v.norm(), 1e4) << n;
      EXPECT_LE(iterations_on(matrix), 40) << n;
    }
  }
}

TEST(Multigrid, CommutesWithScaling) {
  const SymmetricMatrix matrix = majoriser_of(shapes::triangle_grid(40));
  Workers workers;
  Multigrid multigrid(workers, matrix);
  const auto r = random_right_side(matrix, 1);
  const auto z = applied(multigrid, r);
  for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
    std::vector<Vec3> scaled = r;
    for (Vec3& v : scaled) v *= scale;
    const auto scaled_z = applied(multigrid, scaled);
    for (std::size_t i = 0; i < z.size(); ++i) {
      EXPECT_LE((scaled_z[i] / scale - z[i]).norm(), 1e-4 * (1.0 + z[i].norm()));
    }
  }
}

TEST(Multigrid, MapsZeroToZero) {
  const SymmetricMatrix matrix = majoriser_of(shapes::triangle_grid(40));
  Workers workers;
  Multigrid multigrid(workers, matrix);
  for (const double tiny : {0.0, 1e-310}) {
    for (const Vec3& z : applied(multigrid, std::vector<Vec3>(matrix.rows(), Vec3(tiny, 0, 0)))) {
      EXPECT_TRUE(z.allFinite());
      if (tiny == 0.0) {
        EXPECT_EQ(z, Vec3(Vec3::Zero()));
      }
    }
  }
}

TEST(Multigrid, WorksWithoutAnyUnknown) {
  const SymmetricMatrix matrix = majoriser_of(shapes::triangle_grid(30), "all");
  Workers workers;
  Multigrid multigrid(workers, matrix);
  for (const Vec3& z : applied(multigrid, random_vectors(matrix.rows(), 1))) {
    EXPECT_EQ(z, Vec3(Vec3::Zero()));
  }
}

TEST(Multigrid, HasTheSameBitsForAnyNumberOfThreads) {
  const SymmetricMatrix matrix = majoriser_of(shapes::irregular_triangles(20000));
  std::vector<Vec3> first;
  for (const int threads : {1, 3, 8}) {
    Workers workers(threads);
    Multigrid multigrid(workers, matrix);
    const auto z = applied(multigrid, random_right_side(matrix, 1), threads);
    if (threads == 1) first = z;
    EXPECT_EQ(std::memcmp(z.data(), first.data(), z.size() * sizeof(Vec3)), 0) << threads;
  }
}

// ---- its parts ----

Eigen::MatrixXd dense(const SparseMatrix& matrix, std::size_t columns) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(matrix.rows()),
                                                 static_cast<Eigen::Index>(columns));
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    for (const auto& entry : matrix.row(i)) {
      result(static_cast<Eigen::Index>(i), entry.column) += entry.value;
    }
  }
  return result;
}

Eigen::MatrixXd dense(const SymmetricMatrix& matrix) {
  Eigen::MatrixXd result = dense(matrix.off_diagonal, matrix.rows());
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    result(k, k) += matrix.diagonal[i];
  }
  return result;
}

class Coarsening : public testing::Test {
 protected:
  Coarsening()
      : matrix_(majoriser_of(shapes::irregular_triangles(900))),
        aggregates_(aggregate(matrix_)),
        interpolation_(smoothed_interpolation(workers_, matrix_, aggregates_)),
        restriction_(transpose(interpolation_, aggregates_.count)) {}

  Workers workers_;
  SymmetricMatrix matrix_;
  Aggregates aggregates_;
  SparseMatrix interpolation_, restriction_;
};

TEST_F(Coarsening, EveryUnknownIsInAnAggregateAndNoOther) {
  std::vector<std::size_t> size(aggregates_.count, 0);
  for (std::size_t i = 0; i < matrix_.rows(); ++i) {
    const std::uint32_t a = aggregates_.of_row[i];
    EXPECT_EQ(a == Aggregates::kNone, !(matrix_.diagonal[i] > 0.0f));
    if (a != Aggregates::kNone) ++size.at(a);
  }
  for (const std::size_t s : size) EXPECT_GT(s, 0u);
  EXPECT_LT(aggregates_.count * 4, matrix_.rows());  // six neighbours and more in each
}

TEST_F(Coarsening, TransposeIsTheTranspose) {
  EXPECT_EQ(dense(restriction_, matrix_.rows()),
            dense(interpolation_, aggregates_.count).transpose());
}

TEST_F(Coarsening, InterpolationIsTheSmoothedIndicator) {
  const Eigen::MatrixXd a = dense(matrix_);
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(a.rows(), aggregates_.count);
  double rho = 1.0;
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const std::uint32_t of = aggregates_.of_row[static_cast<std::size_t>(i)];
    if (of == Aggregates::kNone) continue;
    p(i, of) = 1.0;
    rho = std::max(rho, a.row(i).lpNorm<1>() / a(i, i));
  }
  const Eigen::VectorXd inverse =
      a.diagonal().unaryExpr([](double d) { return d > 0.0 ? 1.0 / d : 0.0; });
  p -= 4.0 / (3.0 * rho) * inverse.asDiagonal() * a * p;
  EXPECT_LE((dense(interpolation_, aggregates_.count) - p).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST_F(Coarsening, ProductIsTheTripleProduct) {
  const Eigen::MatrixXd p = dense(interpolation_, aggregates_.count);
  const Eigen::MatrixXd expected = p.transpose() * dense(matrix_) * p;
  const Eigen::MatrixXd product =
      dense(galerkin_product(workers_, matrix_, interpolation_, restriction_));
  EXPECT_LE((product - expected).lpNorm<Eigen::Infinity>(), 1e-5 * expected.maxCoeff());
}

TEST(Aggregate, JoinsNobodyToALoneUnknown) {
  // Rows 0 and 2 are coupled, row 1 has no neighbour, row 3 no unknown.
  SymmetricMatrix matrix;
  matrix.diagonal = {2, 1, 2, 0};
  matrix.off_diagonal.start = {0, 1, 1, 2, 2};
  matrix.off_diagonal.entries = {{2, -1}, {0, -1}};
  const Aggregates result = aggregate(matrix);
  EXPECT_EQ(result.count, 2u);
  EXPECT_EQ(result.of_row, (std::vector<std::uint32_t>{0, 1, 0, Aggregates::kNone}));
}

}  // namespace
}  // namespace evenmesh
