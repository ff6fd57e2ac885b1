// SPDX-License-Identifier: MIT
#include "evenmesh/solver/quadratic_program.h"

#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace evenmesh {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using shapes::Random;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A program that owns its arrays, with all of them dense.
struct Dense {
  MatrixXd curvature;
  VectorXd gradient;
  MatrixXd jacobian;
  VectorXd constraint;
  Index equations = 0;
  std::optional<VectorXd> weights = std::nullopt;

  Index unknowns() const { return gradient.size(); }
  Index constraints() const { return constraint.size(); }
  double upper(Index i) const { return weights ? (*weights)[i] : kInfinity; }
  double lower(Index i) const { return i < equations ? -upper(i) : 0.0; }

  QuadraticSolution solve(const QuadraticSolution* guess = nullptr) const {
    const MatrixXd root = inverse_root(curvature);
    const SparseRowMatrix sparse = jacobian.sparseView();
    return evenmesh::solve(
        {root, gradient, constraint, sparse, equations, weights ? &*weights : nullptr}, guess);
  }
};

VectorXd random_vector(Random& random, Index size) {
  return VectorXd::NullaryExpr(size, [&] { return random.signed_unit(); });
}

MatrixXd random_matrix(Random& random, Index rows, Index columns) {
  return MatrixXd::NullaryExpr(rows, columns, [&] { return random.signed_unit(); });
}

MatrixXd random_curvature(Random& random, Index size) {
  const MatrixXd a = random_matrix(random, size, size);
  return a * a.transpose() + 0.1 * MatrixXd::Identity(size, size);
}

Dense random_program(Random& random, Index unknowns, Index equations, Index inequalities) {
  const Index count = equations + inequalities;
  return {random_curvature(random, unknowns), 3.0 * random_vector(random, unknowns),
          random_matrix(random, count, unknowns), random_vector(random, count), equations};
}

/// The solution by trying every state of every constraint: without force, at 0, or (with weights)
/// at either bound of its multiplier. Nothing if no choice is consistent, as then the constraints
/// contradict each other.
std::optional<VectorXd> by_brute_force(const Dense& p) {
  const Index n = p.unknowns();
  const Index m = p.constraints();
  Index choices = 1;
  for (Index i = 0; i < m; ++i) choices *= 4;
  for (Index choice = 0; choice < choices; ++choice) {
    std::vector<Index> active;
    VectorXd lambda = VectorXd::Zero(m);
    bool valid = true;
    for (Index i = 0, code = choice; i < m; ++i, code /= 4) {
      const Index state = code % 4;  // 0: no force, 1: active, 2: at the upper, 3: at the lower
      if (state == 1) active.push_back(i);
      if (state == 2) lambda[i] = p.upper(i);
      if (state == 3) lambda[i] = p.lower(i);
      if (state == 3 && i >= p.equations) valid = false;
      if (!std::isfinite(lambda[i])) valid = false;
    }
    if (!valid) continue;
    const Index k = static_cast<Index>(active.size());
    MatrixXd rows(k, n);
    VectorXd c(k);
    for (Index j = 0; j < k; ++j) {
      rows.row(j) = p.jacobian.row(active[j]);
      c[j] = p.constraint[active[j]];
    }
    MatrixXd kkt = MatrixXd::Zero(n + k, n + k);
    kkt << p.curvature, -rows.transpose(), rows, MatrixXd::Zero(k, k);
    VectorXd right(n + k);
    right << p.jacobian.transpose() * lambda - p.gradient, -c;
    const Eigen::FullPivLU<MatrixXd> lu(kkt);
    if (!lu.isInvertible()) continue;
    const VectorXd solution = lu.solve(right);
    const VectorXd h = solution.head(n);
    for (Index j = 0; j < k; ++j) lambda[active[j]] = solution[n + j];
    const VectorXd v = p.constraint + p.jacobian * h;
    for (Index i = 0; i < m && valid; ++i) {
      if (lambda[i] > p.upper(i) + 1e-9 || lambda[i] < p.lower(i) - 1e-9) valid = false;
      if (v[i] < -1e-9 && lambda[i] < p.upper(i) - 1e-9) valid = false;
      if (v[i] > 1e-9 && lambda[i] > p.lower(i) + 1e-9) valid = false;
    }
    if (valid) return h;
  }
  return std::nullopt;
}

/// Asserts what makes h a solution: the gradient is a combination of rows with multipliers within
/// their bounds, and a constraint is at 0 unless its multiplier is at the bound that pushes.
void expect_optimal(const Dense& p, const QuadraticSolution& s, double tolerance = 1e-8) {
  const VectorXd gradient = p.curvature * s.step + p.gradient;
  const double scale = 1.0 + p.gradient.norm() + gradient.norm();
  EXPECT_LE((gradient - p.jacobian.transpose() * s.multipliers).norm(), tolerance * scale);
  EXPECT_NEAR(s.coordinates.squaredNorm(), s.step.dot(p.curvature * s.step),
              tolerance * (1.0 + s.coordinates.squaredNorm()));
  const VectorXd v = p.constraint + p.jacobian * s.step;
  std::vector<char> active(static_cast<std::size_t>(p.constraints()), 0);
  for (const Index i : s.active) active[static_cast<std::size_t>(i)] = 1;
  bool feasible = true;
  for (Index i = 0; i < p.constraints(); ++i) {
    const double slack = tolerance * (1.0 + std::abs(p.constraint[i]));
    EXPECT_LE(s.multipliers[i], p.upper(i)) << i;
    EXPECT_GE(s.multipliers[i], p.lower(i)) << i;
    if (v[i] < -slack) {
      EXPECT_EQ(s.multipliers[i], p.upper(i)) << i;
    }
    if (v[i] > slack) {
      EXPECT_EQ(s.multipliers[i], p.lower(i)) << i;
    }
    if (active[static_cast<std::size_t>(i)]) {
      EXPECT_NEAR(v[i], 0.0, slack) << i;
    }
    if (v[i] < -slack || (i < p.equations && v[i] > slack)) feasible = false;
  }
  EXPECT_EQ(s.feasible, feasible);
}

// ---- known answers -----------------------------------------------------------------------------

TEST(QuadraticProgram, WithoutConstraintsIsNewtonsStep) {
  Random random(1);
  const Dense p{random_curvature(random, 4), random_vector(random, 4), MatrixXd(0, 4), VectorXd(0)};
  const QuadraticSolution s = p.solve();
  EXPECT_LE((s.step + p.curvature.inverse() * p.gradient).norm(), 1e-12);
  EXPECT_TRUE(s.feasible);
  EXPECT_EQ(s.changes, 0);
}

TEST(QuadraticProgram, MatchesAHandComputedCorner) {
  // min (h0^2 + h1^2)/2 - 2 h0 - 2 h1 with h0 <= 1, h1 <= 1.5, h0 + h1 >= -9: the corner, where the
  // gradient (-1, -0.5) is what the two bounds push with.
  MatrixXd jacobian(3, 2);
  jacobian << -1, 0, 0, -1, 1, 1;
  const Dense p{MatrixXd::Identity(2, 2), Eigen::Vector2d(-2, -2), jacobian,
                Eigen::Vector3d(1, 1.5, 9)};
  const QuadraticSolution s = p.solve();
  EXPECT_LE((s.step - Eigen::Vector2d(1, 1.5)).norm(), 1e-14);
  EXPECT_LE((s.multipliers - Eigen::Vector3d(1, 0.5, 0)).norm(), 1e-14);
  EXPECT_EQ(s.active, (std::vector<Index>{0, 1}));
}

TEST(QuadraticProgram, AnEquationMayPullEitherWay) {
  // min h^2/2 with h = 2 and with h = -2: multipliers 2 and -2.
  for (const double at : {2.0, -2.0}) {
    const Dense p{MatrixXd::Ones(1, 1), VectorXd::Zero(1), MatrixXd::Ones(1, 1),
                  VectorXd::Constant(1, -at), 1};
    const QuadraticSolution s = p.solve();
    EXPECT_DOUBLE_EQ(s.step[0], at);
    EXPECT_DOUBLE_EQ(s.multipliers[0], at);
  }
}

TEST(QuadraticProgram, SolvesGoldfarbsAndIdnanisExample) {
  // W = [4 -2; -2 4],
  // g = (6, 0), h0 >= 0, h1 >= 0, h0 + h1 >= 2. On the line h0 + h1 = 2 the objective is
  // 6 h0^2 - 6 h0 + 8 with its minimum at h0 = 1/2.
  MatrixXd curvature(2, 2);
  curvature << 4, -2, -2, 4;
  MatrixXd jacobian(3, 2);
  jacobian << 1, 0, 0, 1, 1, 1;
  const Dense p{curvature, Eigen::Vector2d(6, 0), jacobian, Eigen::Vector3d(0, 0, -2)};
  const QuadraticSolution s = p.solve();
  EXPECT_LE((s.step - Eigen::Vector2d(0.5, 1.5)).norm(), 1e-12);
  EXPECT_LE((s.multipliers - Eigen::Vector3d(0, 0, 5)).norm(), 1e-12);
}

// ---- brute force -------------------------------------------------------------------------------

TEST(QuadraticProgram, AgreesWithBruteForceOnRandomPrograms) {
  int infeasible = 0;
  int changed = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Index n = 1 + static_cast<Index>(random.below(4));
    const Index equations = static_cast<Index>(random.below(static_cast<std::size_t>(n)));
    const Index inequalities = static_cast<Index>(random.below(6));
    if (equations + inequalities > 6) continue;
    const Dense p = random_program(random, n, equations, inequalities);
    const std::optional<VectorXd> wanted = by_brute_force(p);
    const QuadraticSolution s = p.solve();
    ASSERT_EQ(s.feasible, wanted.has_value());
    infeasible += !wanted;
    changed += s.changes > static_cast<int>(s.active.size());
    if (!wanted) continue;
    expect_optimal(p, s);
    EXPECT_LE((s.step - *wanted).norm(), 1e-8 * (1.0 + wanted->norm()));
  }
  EXPECT_GE(infeasible, 30);  // both kinds occur, and constraints that are dropped again
  EXPECT_GE(changed, 10);
}

TEST(QuadraticProgram, AgreesWithBruteForceWhereConstraintsMayBeBroken) {
  int broken = 0;
  int met = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(1000 + seed);
    const Index n = 1 + static_cast<Index>(random.below(3));
    Dense p = random_program(random, n, static_cast<Index>(random.below(3)),
                             static_cast<Index>(random.below(4)));
    p.weights = random_vector(random, p.constraints()).cwiseAbs() * (seed % 2 ? 2.0 : 30.0);
    const std::optional<VectorXd> wanted = by_brute_force(p);
    const QuadraticSolution s = p.solve();
    ASSERT_TRUE(wanted);
    expect_optimal(p, s);
    EXPECT_LE((s.step - *wanted).norm(), 1e-8 * (1.0 + wanted->norm()));
    (s.feasible ? met : broken) += 1;
  }
  EXPECT_GE(broken, 50);
  EXPECT_GE(met, 50);
}

TEST(QuadraticProgram, GreatWeightsChangeNothingWhereConstraintsCanBeMet) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random(2000 + seed);
    Dense p = random_program(random, 6, 2, 5);
    const QuadraticSolution hard = p.solve();
    if (!hard.feasible) continue;
    p.weights = VectorXd::Constant(7, 1.01 * hard.multipliers.lpNorm<Eigen::Infinity>() + 1e-3);
    const QuadraticSolution elastic = p.solve();
    EXPECT_TRUE(elastic.feasible);
    EXPECT_LE((hard.step - elastic.step).norm(), 1e-8 * (1.0 + hard.step.norm())) << seed;
    EXPECT_EQ(hard.active, elastic.active);
    ++compared;
  }
  EXPECT_GE(compared, 30);
}

// ---- larger ones -------------------------------------------------------------------------------

TEST(QuadraticProgram, ManyConstraintsThatComeAndGo) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(3000 + seed);
    Dense p = random_program(random, 30, 5, 80);
    // Some point meets them all: of these programs each has a solution.
    const VectorXd inside = random_vector(random, 30);
    p.constraint = -p.jacobian * inside;
    p.constraint.tail(80) += random_vector(random, 80).cwiseAbs() * 0.2;
    const QuadraticSolution s = p.solve();
    EXPECT_TRUE(s.feasible);
    EXPECT_GE(s.active.size(), 8u);
    expect_optimal(p, s);
  }
}

TEST(QuadraticProgram, AGuessSavesChangesAndGivesTheSameSolution) {
  Random random(4000);
  Dense p = random_program(random, 30, 3, 60);
  p.constraint = -p.jacobian * random_vector(random, 30);
  p.constraint.tail(60) += random_vector(random, 60).cwiseAbs() * 0.2;
  const QuadraticSolution before = p.solve();
  ASSERT_TRUE(before.feasible);
  for (const double change : {0.0, 1e-3, 1.0}) {
    Dense next = p;
    next.gradient += change * random_vector(random, 30);
    next.jacobian.bottomRows(60) *= 1.0 - 0.1 * change;
    const QuadraticSolution cold = next.solve();
    const QuadraticSolution warm = next.solve(&before);
    EXPECT_LE((cold.step - warm.step).norm(), 1e-9 * (1.0 + cold.step.norm()));
    EXPECT_EQ(cold.active, warm.active);
    if (change < 1e-2) {
      EXPECT_LT(warm.changes, cold.changes);
    }
  }
}

TEST(QuadraticProgram, AGuessFromWhereConstraintsWereBroken) {
  Random random(4100);
  Dense p = random_program(random, 10, 2, 30);
  p.weights = VectorXd::Constant(32, 1.5);
  const QuadraticSolution before = p.solve();
  ASSERT_FALSE(before.feasible);
  p.gradient += 0.1 * random_vector(random, 10);
  p.weights = VectorXd::Constant(32, 2.0);
  const QuadraticSolution cold = p.solve();
  const QuadraticSolution warm = p.solve(&before);
  expect_optimal(p, warm);
  EXPECT_LE((cold.step - warm.step).norm(), 1e-9 * (1.0 + cold.step.norm()));
  EXPECT_LT(warm.changes, cold.changes);
}

TEST(QuadraticProgram, HasTheSameBitsEachTime) {
  Random random(4200);
  const Dense p = random_program(random, 20, 2, 15);
  EXPECT_EQ(p.solve().step, p.solve().step);
}

// ---- degenerate ones ---------------------------------------------------------------------------

TEST(QuadraticProgram, RepeatedAndScaledRowsAreNoContradiction) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(5000 + seed);
    Dense p = random_program(random, 5, 4, 8);
    p.constraint = -p.jacobian * random_vector(random, 5);
    p.jacobian.row(2) = -3.0 * p.jacobian.row(1);  // the same equation
    p.constraint[2] = -3.0 * p.constraint[1];
    p.jacobian.row(3) = p.jacobian.row(0) + p.jacobian.row(1);
    p.constraint[3] = p.constraint[0] + p.constraint[1];
    p.jacobian.row(5) = p.jacobian.row(4);  // the same inequality, another scale
    p.constraint[5] = p.constraint[4];
    p.jacobian.row(6) = 1e4 * p.jacobian.row(4);
    p.constraint[6] = 1e4 * p.constraint[4];
    p.jacobian.row(7) = -p.jacobian.row(4);  // opposite: together an equation
    p.constraint[7] = -p.constraint[4];
    const QuadraticSolution s = p.solve();
    ASSERT_TRUE(s.feasible);
    expect_optimal(p, s);
    EXPECT_LE(s.active.size(), 5u);
  }
}

TEST(QuadraticProgram, NearlyParallelRowsAreMetAlike) {
  // All within 1e-6 of one direction: a single projection loses half of the digits.
  Random random(5500);
  Dense p = random_program(random, 25, 20, 0);
  p.curvature = MatrixXd::Identity(25, 25);
  const VectorXd common = random_vector(random, 25);
  p.jacobian = common.transpose().replicate(20, 1) + 1e-6 * random_matrix(random, 20, 25);
  p.constraint = -p.jacobian * random_vector(random, 25);
  const QuadraticSolution s = p.solve();
  ASSERT_TRUE(s.feasible);
  EXPECT_EQ(s.active.size(), 20u);
  EXPECT_LE((p.constraint + p.jacobian * s.step).norm(), 1e-13);
  const VectorXd gradient = s.step + p.gradient;
  EXPECT_LE((gradient - p.jacobian.transpose() * s.multipliers).norm(), 1e-8);
}

TEST(QuadraticProgram, ManyConstraintsMeetInOneVertex) {
  // A cone with 40 sides in 3 dimensions whose tip is the solution.
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(6000 + seed);
    Dense p = random_program(random, 3, 0, 40);
    for (Index i = 0; i < 40; ++i) {
      const double angle = static_cast<double>(i) * 3.14159265358979 / 20.0;
      p.jacobian.row(i) << std::cos(angle), std::sin(angle), 1.0;
    }
    const Eigen::Vector3d tip(0.3, -0.2, 0.7);
    p.constraint = -p.jacobian * tip;
    // The gradient at the tip is that of a force into the cone.
    p.gradient = Eigen::Vector3d(0.1 * random.signed_unit(), 0.1 * random.signed_unit(), 1.0) -
                 p.curvature * tip;
    const QuadraticSolution s = p.solve();
    ASSERT_TRUE(s.feasible);
    expect_optimal(p, s);
    EXPECT_LE((s.step - tip).norm(), 1e-10);
  }
}

TEST(QuadraticProgram, ARowOfZerosIsMetOrIsAContradiction) {
  Random random(7000);
  Dense p = random_program(random, 3, 0, 2);
  p.jacobian.row(1).setZero();
  p.constraint << 5.0, 1.0;
  EXPECT_TRUE(p.solve().feasible);
  p.constraint[1] = -1.0;
  EXPECT_FALSE(p.solve().feasible);
  p.weights = VectorXd::Constant(2, 3.0);
  const QuadraticSolution s = p.solve();
  EXPECT_FALSE(s.feasible);
  EXPECT_EQ(s.multipliers[1], 3.0);
  expect_optimal(p, s);
}

TEST(QuadraticProgram, ContradictionsAreFound) {
  // h0 >= 1 and h0 <= 0.
  Dense p{MatrixXd::Identity(2, 2), VectorXd::Zero(2), MatrixXd::Zero(2, 2), VectorXd(2)};
  p.jacobian.col(0) << 1, -1;
  p.constraint << -1, 0;
  EXPECT_FALSE(p.solve().feasible);
  p.equations = 2;  // h0 = 1 and h0 = 0
  EXPECT_FALSE(p.solve().feasible);
  // With a price of 1 each, anything between costs 1, and h^2/2 decides: h0 = 0.
  p.equations = 0;
  p.weights = VectorXd::Ones(2);
  EXPECT_LE(p.solve().step.norm(), 1e-15);
  // The first is three times as dear: h0 = 1, where the pulls 3 - 1 exceed the slope 1.
  *p.weights << 3, 1;
  const QuadraticSolution s = p.solve();
  EXPECT_LE((s.step - Eigen::Vector2d(1, 0)).norm(), 1e-15);
  EXPECT_LE((s.multipliers - Eigen::Vector2d(2, 1)).norm(), 1e-15);
  EXPECT_EQ(s.active, std::vector<Index>{0});
  EXPECT_FALSE(s.feasible);
}

// ---- scale -------------------------------------------------------------------------------------

TEST(QuadraticProgram, ScalesOfUnknownsRowsAndObjectiveDoNotMatter) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(8000 + seed);
    Dense p = random_program(random, 8, 2, 10);
    p.constraint = -p.jacobian * random_vector(random, 8);
    p.constraint.tail(10) += random_vector(random, 10).cwiseAbs();
    const QuadraticSolution s = p.solve();
    ASSERT_TRUE(s.feasible);

    // h = D k, rows times r, objective times a.
    const auto powers = [&](Index size) {
      return VectorXd(
          random_vector(random, size).unaryExpr([](double x) { return std::pow(10.0, 3.0 * x); }));
    };
    const VectorXd d = powers(8);
    const VectorXd r = powers(12);
    const double a = 1e-7;
    Dense scaled = p;
    scaled.curvature = a * d.asDiagonal() * p.curvature * d.asDiagonal();
    scaled.gradient = a * d.asDiagonal() * p.gradient;
    scaled.jacobian = r.asDiagonal() * p.jacobian * d.asDiagonal();
    scaled.constraint = r.asDiagonal() * p.constraint;
    const QuadraticSolution t = scaled.solve();
    ASSERT_TRUE(t.feasible);
    EXPECT_LE((d.asDiagonal() * t.step - s.step).norm(), 1e-6 * (1.0 + s.step.norm()));
    EXPECT_LE((r.asDiagonal() * t.multipliers / a - s.multipliers).norm(),
              1e-6 * (1.0 + s.multipliers.norm()));
    EXPECT_EQ(t.active, s.active);
  }
}

TEST(QuadraticProgram, InverseRootIsOne) {
  Random random(9000);
  const MatrixXd w = random_curvature(random, 12);
  const MatrixXd root = inverse_root(w);
  EXPECT_LE((root.transpose() * root * w - MatrixXd::Identity(12, 12)).norm(), 1e-10);
}

}  // namespace
}  // namespace evenmesh
