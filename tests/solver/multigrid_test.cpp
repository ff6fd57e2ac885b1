// SPDX-License-Identifier: MIT
#include "evenmesh/solver/multigrid.h"

#include <cstring>
#include <functional>
#include <set>

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
int iterations_on(Multigrid& multigrid, std::vector<Vec3> r,
                  const std::function<std::vector<Vec3>(const std::vector<Vec3>&)>& product) {
  std::vector<Vec3> x(r.size(), Vec3::Zero());
  const double start = inner(r, r);
  std::vector<Vec3> z = applied(multigrid, r);
  std::vector<Vec3> p = z;
  double rz = inner(r, z);
  for (int i = 1; i <= 100; ++i) {
    const std::vector<Vec3> ap = product(p);
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

int iterations_on(const SymmetricMatrix& matrix) {
  Workers workers;
  Multigrid multigrid(workers, matrix);
  return iterations_on(multigrid, random_right_side(matrix, 1),
                       [&](const std::vector<Vec3>& x) { return times(matrix, x); });
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

// ---- what moves along lines and in planes only ----

// Unit springs along the sides of a mesh, and the projectors of vertices that slide.
struct Sliding {
  SymmetricMatrix matrix;
  std::vector<Projector> projectors;

  Sliding(const Mesh& mesh, const std::function<bool(const Vec3&)>& fixed,
          const std::function<Eigen::Matrix3f(const Vec3&)>& projector) {
    const Points x = mesh.points();
    std::vector<std::set<Index>> neighbours(x.size());
    for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
      const auto vertices = mesh.cells().vertices(c);
      for (const Index a : vertices) neighbours[a].insert(vertices.begin(), vertices.end());
    }
    for (Index i = 0; i < x.size(); ++i) {
      matrix.diagonal.push_back(fixed(x[i]) ? 0.0f : static_cast<float>(neighbours[i].size() - 1));
      for (const Index j : neighbours[i]) {
        if (i != j && !fixed(x[i]) && !fixed(x[j])) {
          matrix.off_diagonal.entries.push_back({j, -1.0f});
        }
      }
      matrix.off_diagonal.start.push_back(matrix.off_diagonal.entries.size());
      const Eigen::Matrix3f p = projector(x[i]);
      if (!p.isIdentity()) projectors.push_back({i, p});
    }
  }

  std::vector<Vec3> projected(std::vector<Vec3> vectors) const {
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      if (!(matrix.diagonal[i] > 0.0f)) vectors[i] = Vec3::Zero();
    }
    for (const Projector& p : projectors) {
      const Eigen::Matrix3d full = p.matrix.cast<double>();
      vectors[p.row] = full * vectors[p.row];
    }
    return vectors;
  }

  std::vector<Vec3> product(const std::vector<Vec3>& x) const {
    return projected(times(matrix, x));
  }
};

Eigen::Matrix3f along(const Vec3& line) {
  const Vec3 t = line.normalized();
  return Eigen::Matrix3d(t * t.transpose()).cast<float>();
}

Eigen::Matrix3f across(const Vec3& normal) { return Eigen::Matrix3f::Identity() - along(normal); }

bool is_end(double x) { return x < 1e-9 || x > 1.0 - 1e-9; }

// The unit square, its sides sliding along themselves and its corners fixed.
Sliding sliding_square(int n) {
  return {shapes::triangle_grid(n), [](const Vec3& x) { return is_end(x.x()) && is_end(x.y()); },
          [](const Vec3& x) -> Eigen::Matrix3f {
            if (is_end(x.x())) return along(Vec3::UnitY());
            if (is_end(x.y())) return along(Vec3::UnitX());
            return Eigen::Matrix3f::Identity();
          }};
}

// A disk whose boundary slides on its circle, and nothing fixed.
Sliding sliding_disk(int n) {
  const Mesh grid = shapes::triangle_grid(n, 2.0);
  std::vector<Vec3> points;
  for (const Vec3& x : grid.points()) {
    const Vec3 d = x - Vec3(1, 1, 0);
    const double r = d.norm();
    points.push_back(r > 0.0 ? Vec3(d.lpNorm<Eigen::Infinity>() / r * d) : d);
  }
  return {testing_setup::with_points(grid, points), [](const Vec3&) { return false; },
          [](const Vec3& x) -> Eigen::Matrix3f {
            if (x.norm() < 1.0 - 1e-9) return Eigen::Matrix3f::Identity();
            return along(Vec3(-x.y(), x.x(), 0.0));
          }};
}

// A closed surface in its tangent planes.
Sliding sliding_sphere(int levels) {
  return {shapes::sphere_triangles(levels), [](const Vec3&) { return false; },
          [](const Vec3& x) { return across(x); }};
}

int iterations_on(const Sliding& sliding) {
  Workers workers;
  Multigrid multigrid(workers, sliding.matrix, sliding.projectors);
  return iterations_on(multigrid, sliding.projected(random_vectors(sliding.matrix.rows(), 1)),
                       [&](const std::vector<Vec3>& x) { return sliding.product(x); });
}

TEST(SlidingMultigrid, IsSymmetricAndPositiveDefiniteWhereVerticesCanMove) {
  for (const Sliding& sliding : {sliding_square(40), sliding_disk(40), sliding_sphere(4)}) {
    Workers workers;
    Multigrid multigrid(workers, sliding.matrix, sliding.projectors);
    ASSERT_GE(multigrid.levels(), 2);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto u = sliding.projected(random_vectors(sliding.matrix.rows(), seed));
      const auto v = sliding.projected(random_vectors(sliding.matrix.rows(), seed + 100));
      const auto mu = applied(multigrid, u);
      const auto mv = applied(multigrid, v);
      EXPECT_NEAR(inner(u, mv), inner(v, mu), 1e-5 * std::sqrt(inner(u, mu) * inner(v, mv)));
      EXPECT_GT(inner(u, mu), 0.0);
    }
  }
}

TEST(SlidingMultigrid, MovesNothingOffItsLineOrPlane) {
  for (const Sliding& sliding :
       {sliding_square(10), sliding_square(40), sliding_disk(40), sliding_sphere(4)}) {
    Workers workers;
    Multigrid multigrid(workers, sliding.matrix, sliding.projectors);
    const auto r = random_vectors(sliding.matrix.rows(), 1);
    const auto z = applied(multigrid, r);
    double size = 0.0;
    for (const Vec3& v : z) size = std::max(size, v.norm());
    EXPECT_LE(testing_setup::farthest(sliding.projected(z), z), 1e-6 * size);
    // What pushes off the line or plane does nothing either.
    const auto again = applied(multigrid, sliding.projected(r));
    EXPECT_LE(testing_setup::farthest(again, z), 1e-4 * size);
  }
}

TEST(SlidingMultigrid, NeedsAsManyIterationsOnFineMeshesAsOnCoarse) {
  const auto check = [](const Sliding& coarse, const Sliding& fine) {
    const int few = iterations_on(coarse);
    const int many = iterations_on(fine);
    EXPECT_LE(many, 16);
    EXPECT_LE(many, few + 6);  // a scalar inverse, projected, takes 20 to 80 and ever more
  };
  check(sliding_square(32), sliding_square(128));
  check(sliding_disk(32), sliding_disk(128));
  check(sliding_sphere(3), sliding_sphere(5));
}

TEST(SlidingMultigrid, IsTheInverseWhereOneLevelIsEnough) {
  for (const Sliding& sliding : {sliding_square(9), sliding_disk(10), sliding_sphere(1)}) {
    Workers workers;
    Multigrid multigrid(workers, sliding.matrix, sliding.projectors);
    ASSERT_EQ(multigrid.levels(), 1);
    const auto x = sliding.projected(random_vectors(sliding.matrix.rows(), 3));
    EXPECT_LE(testing_setup::farthest(applied(multigrid, sliding.product(x)), x), 0.01);
  }
}

TEST(SlidingMultigrid, SeesNoDifferenceBetweenAPlaneAndAPlanarMesh) {
  // Every vertex in the plane of a flat mesh: what the matrix of scalars does in that plane.
  const SymmetricMatrix matrix = majoriser_of(shapes::triangle_grid(90));
  std::vector<Projector> projectors;
  const Vec3 normal(1, 2, 3);
  for (Index i = 0; i < matrix.rows(); ++i) projectors.push_back({i, across(normal)});
  Workers workers;
  Multigrid flat(workers, matrix);
  Multigrid projected(workers, matrix, projectors);
  ASSERT_EQ(flat.levels(), projected.levels());
  std::vector<Vec3> r = random_right_side(matrix, 1);
  for (Vec3& v : r) v -= normal.dot(v) / normal.squaredNorm() * normal;
  const auto expected = applied(flat, r);
  const auto z = applied(projected, r);
  double size = 0.0;
  for (const Vec3& v : expected) size = std::max(size, v.norm());
  EXPECT_LE(testing_setup::farthest(z, expected), 0.002 * size);
}

TEST(SlidingMultigrid, TakesRowsThatAllMoveAlongOneLine) {
  const SymmetricMatrix matrix = majoriser_of(shapes::triangle_grid(60));
  Sliding sliding = sliding_square(60);
  sliding.matrix = matrix;  // with the whole boundary fixed: projectors of rows without unknown
  sliding.projectors.clear();
  for (Index i = 0; i < matrix.rows(); ++i) sliding.projectors.push_back({i, along({1, 2, 3})});
  EXPECT_LE(iterations_on(sliding), 15);
}

TEST(SlidingMultigrid, IgnoresProjectorsOfRowsWithoutUnknown) {
  const SymmetricMatrix matrix = majoriser_of(shapes::triangle_grid(40));
  std::vector<Projector> projectors;
  for (Index i = 0; i < matrix.rows(); ++i) {
    if (!(matrix.diagonal[i] > 0.0f)) projectors.push_back({i, along({1, 1, 0})});
  }
  ASSERT_FALSE(projectors.empty());
  Workers workers;
  Multigrid multigrid(workers, matrix, projectors);
  const auto z = applied(multigrid, random_vectors(matrix.rows(), 1));
  for (std::size_t i = 0; i < z.size(); ++i) {
    EXPECT_TRUE(z[i].allFinite());
    if (matrix.diagonal[i] > 0.0f) continue;
    EXPECT_EQ(z[i], Vec3(Vec3::Zero()));
  }
}

TEST(SlidingMultigrid, TakesASingleRow) {
  SymmetricMatrix matrix;
  matrix.diagonal = {2.0f};
  matrix.off_diagonal.start = {0, 0};
  Workers workers;
  for (const float diagonal : {2.0f, 0.0f}) {
    matrix.diagonal = {diagonal};
    Multigrid multigrid(workers, matrix, std::vector<Projector>{{0, along(Vec3::UnitX())}});
    const Vec3 z = applied(multigrid, {Vec3(3, 4, 5)}).front();
    EXPECT_NEAR(z.x(), diagonal > 0.0f ? 1.5 : 0.0, 1e-3);
    EXPECT_EQ(z.tail<2>().norm(), 0.0);
  }
}

TEST(SlidingMultigrid, HasTheSameBitsForAnyNumberOfThreads) {
  for (const Sliding& sliding : {sliding_square(128), sliding_sphere(5)}) {
    std::vector<Vec3> first;
    for (const int threads : {1, 2, 5}) {
      Workers workers(threads);
      Multigrid multigrid(workers, sliding.matrix, sliding.projectors);
      const auto z = applied(multigrid, random_vectors(sliding.matrix.rows(), 1), threads);
      if (threads == 1) first = z;
      EXPECT_EQ(std::memcmp(z.data(), first.data(), z.size() * sizeof(Vec3)), 0) << threads;
    }
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

// A (x) I
Eigen::MatrixXd for_coordinates(const Eigen::MatrixXd& a) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * a.rows(), 3 * a.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
      result.block<3, 3>(3 * i, 3 * j) = a(i, j) * Eigen::Matrix3d::Identity();
    }
  }
  return result;
}

// The matrix with its coupled rows in place.
Eigen::MatrixXd dense(const SymmetricMatrix& matrix, const CoupledRows& rows) {
  Eigen::MatrixXd result = for_coordinates(dense(matrix));
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    const std::uint32_t k = rows.chosen[i];
    if (k == Chosen::kNone) continue;
    const auto put = [&](std::size_t j, const Eigen::Matrix3f& block) {
      result.block<3, 3>(3 * static_cast<Eigen::Index>(i), 3 * static_cast<Eigen::Index>(j)) =
          block.cast<double>();
    };
    put(i, rows.diagonal[k].topRows<3>());
    const float* values = rows.couplings(k);
    for (const auto& entry : matrix.off_diagonal.row(i)) {
      put(entry.column, Eigen::Map<const Eigen::Matrix3f>(values));
      values += 9;
    }
  }
  return result;
}

TEST_F(Coarsening, CouplingsAreThoseOfTheProjectedMatrixOnTwoLevels) {
  // A few rows with a projector, lines and planes, between many without.
  Projections projections;
  std::vector<Index> chosen;
  Eigen::MatrixXd pq = for_coordinates(dense(interpolation_, aggregates_.count));
  shapes::Random random(5);
  for (Index i = 100; i < 160; ++i) {
    const Vec3 v(random.signed_unit(), random.signed_unit(), random.signed_unit());
    const Eigen::Matrix3f projector = i % 2 == 0 ? along(v) : across(v);
    chosen.push_back(i);
    projections.of.emplace_back(projector);
    pq.middleRows<3>(3 * i) = (projector.cast<double>() * pq.middleRows<3>(3 * i)).eval();
  }
  projections.chosen = Chosen(chosen, matrix_.rows());

  const SymmetricMatrix coarse = galerkin_product(workers_, matrix_, interpolation_, restriction_);
  const CoupledRows rows =
      galerkin_couplings(workers_, matrix_, projections, interpolation_, restriction_, coarse);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(pq.cols(), pq.cols());
  for (int k = 0; k < 3; ++k) {  // one coordinate after the other: the matrix is that of scalars
    const Eigen::MatrixXd part = pq(Eigen::seq(k, Eigen::last, 3), Eigen::all);
    expected += part.transpose() * (dense(matrix_) * part);
  }
  EXPECT_LE((dense(coarse, rows) - expected).lpNorm<Eigen::Infinity>(), 1e-5 * expected.maxCoeff());
  EXPECT_FALSE(rows.diagonal.empty());
  EXPECT_LT(rows.diagonal.size() * 2, coarse.rows());  // most are not touched

  const Aggregates next = aggregate(coarse);
  const SparseMatrix down = smoothed_interpolation(workers_, coarse, next);
  const SparseMatrix up = transpose(down, next.count);
  const SymmetricMatrix coarsest = galerkin_product(workers_, coarse, down, up);
  const CoupledRows last = galerkin_couplings(workers_, coarse, rows, down, up, coarsest);
  const Eigen::MatrixXd t = for_coordinates(dense(down, next.count));
  const Eigen::MatrixXd product = t.transpose() * expected * t;
  EXPECT_LE((dense(coarsest, last) - product).lpNorm<Eigen::Infinity>(), 1e-5 * product.maxCoeff());
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
