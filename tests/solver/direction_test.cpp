// SPDX-License-Identifier: MIT
#include "evenmesh/solver/direction.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "evenmesh/solver/smooth.h"
#include "evenmesh/solver/vectors.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::problem_of;

// f(x) = x.A x / 2 in 3 n unknowns.
struct Quadratic {
  Eigen::MatrixXd a;

  explicit Quadratic(int n) {
    shapes::Random random(4);
    const Eigen::MatrixXd b =
        Eigen::MatrixXd::NullaryExpr(3 * n, 3 * n, [&] { return random.signed_unit(); });
    a = b.transpose() * b + Eigen::MatrixXd::Identity(3 * n, 3 * n);
  }
  std::vector<Vec3> times(const std::vector<Vec3>& x) const {
    std::vector<Vec3> y(x.size());
    const auto n = static_cast<Eigen::Index>(3 * x.size());
    Eigen::Map<Eigen::VectorXd>(y[0].data(), n) =
        a * Eigen::Map<const Eigen::VectorXd>(x[0].data(), n);
    return y;
  }
};

std::vector<Vec3> start(std::size_t n) {
  shapes::Random random(9);
  std::vector<Vec3> x(n);
  for (Vec3& p : x) p = {random.signed_unit(), random.signed_unit(), random.signed_unit()};
  return x;
}

// Exact steps along p; returns how many it takes to a gradient of 1e-8.
template <typename Next>
int minimise(const Quadratic& f, std::vector<Vec3> x, const Next& next) {
  Workers workers;
  std::vector<Vec3> g = f.times(x);
  std::vector<Vec3> p(x.size(), Vec3::Zero());
  std::vector<Vec3> x_old = x;
  std::vector<Vec3> g_old = g;
  for (int i = 0; i < 200; ++i) {
    if (largest(workers, g) < 1e-8) return i;
    next(x, x_old, g, g_old, p);
    const double slope = dot(workers, g, p);
    EXPECT_LT(slope, 0.0) << "not a descent direction at step " << i;
    x_old = x;
    g_old = g;
    const double alpha = -slope / dot(workers, p, f.times(p));
    add(workers, x, alpha, p, x);
    g = f.times(x);
  }
  return 200;
}

TEST(ConjugateGradients, EndAfterAsManyStepsAsUnknowns) {
  const Quadratic f(4);
  Workers workers;
  ConjugateGradients conjugate;
  const int steps = minimise(f, start(4), [&](auto&, auto&, auto& g, auto& g_old, auto& p) {
    conjugate.next(workers, g, g_old, g, p);
  });
  EXPECT_LE(steps, 13);  // 12 and one for rounding
}

TEST(ConjugateGradients, GoStraightDownAfterARestart) {
  Workers workers;
  ConjugateGradients conjugate;
  std::vector<Vec3> p(1, Vec3(5, 5, 5));
  const std::vector<Vec3> g{{1, 2, 3}};
  const std::vector<Vec3> z{{2, 2, 2}};
  conjugate.next(workers, g, g, z, p);
  conjugate.restart();
  conjugate.next(workers, g, g, z, p);
  EXPECT_EQ(p[0], -z[0]);
}

TEST(Lbfgs, DescendsAndConverges) {
  const Quadratic f(3);
  Workers workers;
  Lbfgs lbfgs;
  bool first = true;
  const int steps = minimise(f, start(3), [&](auto& x, auto& x_old, auto& g, auto& g_old, auto& p) {
    if (!first) lbfgs.remember(workers, x, x_old, g, g_old);
    first = false;
    p = g;
    lbfgs.before_preconditioner(workers, p);
    lbfgs.after_preconditioner(workers, p);
  });
  // With exact steps on a quadratic its directions are those of conjugate gradients.
  EXPECT_LE(steps, 11);
}

TEST(Lbfgs, HasTheSecantOfTheLastStep) {
  // H y = s for the newest pair, whatever the older ones and the preconditioner.
  const Quadratic f(3);
  Workers workers;
  Lbfgs lbfgs;
  std::vector<Vec3> s(3), y;
  shapes::Random random(2);
  for (int k = 0; k < 8; ++k) {
    std::vector<Vec3> x(3), x_old(3);
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = {random.signed_unit(), random.signed_unit(), random.signed_unit()};
      x_old[i] = {random.signed_unit(), random.signed_unit(), random.signed_unit()};
    }
    lbfgs.remember(workers, x, x_old, f.times(x), f.times(x_old));
    for (std::size_t i = 0; i < 3; ++i) s[i] = x[i] - x_old[i];
    y = f.times(s);
  }
  lbfgs.before_preconditioner(workers, y);
  for (Vec3& v : y) v *= 0.01;  // some preconditioner
  lbfgs.after_preconditioner(workers, y);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR((y[i] + s[i]).norm(), 0.0, 1e-10);
}

TEST(Lbfgs, IgnoresStepsWithoutPositiveCurvature) {
  Workers workers;
  Lbfgs lbfgs;
  const std::vector<Vec3> zero(1, Vec3::Zero());
  const std::vector<Vec3> one(1, Vec3(1, 0, 0));
  lbfgs.remember(workers, one, zero, zero, one);  // the gradient falls along the step
  lbfgs.remember(workers, one, one, one, zero);   // no step
  std::vector<Vec3> p(1, Vec3(1, 2, 3));
  lbfgs.before_preconditioner(workers, p);
  lbfgs.after_preconditioner(workers, p);
  EXPECT_EQ(p[0], Vec3(-1, -2, -3));
}

// ---- costs whose springs mislead the preconditioner ----

// sum over cells of k |x - centroid|^2, with a k that varies over six decades and springs that do
// not know it.
class Uneven final : public Cost {
 public:
  explicit Uneven(double springs) : springs_(springs) {}
  std::string_view name() const override { return "uneven"; }
  double evaluate(const CellBlock& cells, Points x, double weight,
                  std::span<Vec3> gradient) const override {
    double sum = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto cell = cells.cell(i);
      const double k = weight * std::pow(10.0, static_cast<double>(cell[0] * 7919u % 7u) - 3.0);
      const Vec3 centroid = (x[cell[0]] + x[cell[1]] + x[cell[2]]) / 3.0;
      for (const Index v : cell) {
        const Vec3 d = x[v] - centroid;
        sum += k * d.squaredNorm();
        if (!gradient.empty()) gradient[v] += 2.0 * k * d;
      }
    }
    return sum;
  }
  void add_springs(const CellBlock& cells, Points x, std::vector<Spring>& springs) const override {
    const std::size_t before = springs.size();
    Cost::add_springs(cells, x, springs);
    for (std::size_t i = before; i < springs.size(); ++i) springs[i].stiffness *= springs_;
  }

 private:
  double springs_;
};

class Misled : public testing::TestWithParam<double> {};

TEST_P(Misled, StillConverges) {
  Mesh mesh = shapes::triangle_grid(30, 1.0, 0.2);
  Problem problem = problem_of(mesh);
  problem.terms = {{1.0, std::make_shared<Uneven>(GetParam())}};
  problem.validity.demanded = false;  // what that costs is measured by the springs, too
  Options options;
  options.judge = Judge::inversion;
  options.max_iterations = 5000;
  const Report report = smooth(mesh, problem, options);
  EXPECT_EQ(report.stop, Stop::converged) << report.history.size();
  EXPECT_GT(report.history.size(), 101u) << "conjugate gradients alone were fast enough";
}

INSTANTIATE_TEST_SUITE_P(Springs, Misled, testing::Values(1e-6, 1.0, 1e6));

}  // namespace
}  // namespace evenmesh
