// SPDX-License-Identifier: MIT
#include "evenmesh/solver/lagrange_newton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/constraint/dual.h"

namespace evenmesh {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double kThirtyFromHalfTurn = 5.0 / 6.0 * 3.14159265358979323846;

using Members = std::vector<Eigen::Index>;

/// A program of two formulas that differentiate themselves: cost(x), and constraints(x) with the
/// equations first, both of an array of Count numbers or Duals.
template <int Count, typename Cost, typename Constraints>
class Written : public NonlinearProgram {
 public:
  Written(int equations, Cost cost, Constraints constraints)
      : equations_(equations), cost_(std::move(cost)), constraints_(std::move(constraints)) {}

  Eigen::Index unknowns() const override { return Count; }
  Eigen::Index equations() const override { return equations_; }
  Eigen::Index inequalities() const override {
    return static_cast<Eigen::Index>(constraints_(std::array<double, Count>{}).size()) - equations_;
  }
  double cost(const VectorXd& y, VectorXd* gradient) const override {
    if (!gradient) return cost_(values(y));
    const Dual<Count> f = cost_(variables(y));
    *gradient = f.slopes.matrix();
    return f.value;
  }
  void constraints(const VectorXd& y, VectorXd& c, SparseRowMatrix* jacobian) const override {
    const auto all = constraints_(variables(y));
    c.resize(static_cast<Eigen::Index>(all.size()));
    MatrixXd rows(c.size(), Count);
    for (Eigen::Index i = 0; i < c.size(); ++i) {
      c[i] = all[static_cast<std::size_t>(i)].value;
      rows.row(i) = all[static_cast<std::size_t>(i)].slopes.matrix();
    }
    if (jacobian) *jacobian = rows.sparseView();
  }

 private:
  static std::array<double, Count> values(const VectorXd& y) {
    std::array<double, Count> x;
    for (int i = 0; i < Count; ++i) x[i] = y[i];
    return x;
  }
  static std::array<Dual<Count>, Count> variables(const VectorXd& y) {
    std::array<Dual<Count>, Count> x;
    for (int i = 0; i < Count; ++i) x[i] = Dual<Count>::variable(y[i], i);
    return x;
  }

  int equations_;
  Cost cost_;
  Constraints constraints_;
};

template <int Count, typename Cost, typename Constraints>
auto written(int equations, Cost cost, Constraints constraints) {
  return Written<Count, Cost, Constraints>(equations, cost, constraints);
}

template <int Count, typename Cost>
auto unconstrained(Cost cost) {
  return written<Count>(0, cost,
                        [](const auto& x) { return std::vector<std::decay_t<decltype(x[0])>>{}; });
}

template <typename T>
T square(const T& x) {
  return x * x;
}

/// The type that a formula's constraints come in.
template <typename X>
using ListOf = std::vector<typename X::value_type>;

VectorXd vector(std::initializer_list<double> entries) {
  VectorXd v(static_cast<Eigen::Index>(entries.size()));
  std::copy(entries.begin(), entries.end(), v.begin());
  return v;
}

struct Known {
  VectorXd x;
  double cost;
  VectorXd multipliers;
  Members active;  // inequalities with positive multipliers, and all equations
};

/// Solves and compares with what is known; asserts the first-order conditions, too.
void expect_solved(NonlinearProgram& program, const VectorXd& start, const Known& known,
                   double tolerance = 1e-6) {
  const LagrangeNewtonResult result =
      lagrange_newton(program, start, {.epsilon = 1e-12 * (1.0 + std::abs(known.cost))});
  EXPECT_EQ(result.stop, Stop::converged);
  EXPECT_LE(result.history.size(), 60u);
  EXPECT_LE((result.y - known.x).lpNorm<Eigen::Infinity>(), tolerance) << result.y.transpose();
  EXPECT_NEAR(result.history.back().cost, known.cost, 1e-9 * (1.0 + std::abs(known.cost)));
  EXPECT_LE((result.multipliers - known.multipliers).lpNorm<Eigen::Infinity>(), tolerance)
      << result.multipliers.transpose();
  EXPECT_EQ(result.active, known.active);
  EXPECT_EQ(result.history.back().active, known.active.size());
  EXPECT_LE(result.history.back().violation, 1e-8);

  VectorXd gradient;
  VectorXd c;
  SparseRowMatrix jacobian;
  program.cost(result.y, &gradient);
  program.constraints(result.y, c, &jacobian);
  EXPECT_LE((gradient - jacobian.transpose() * result.multipliers).norm(),
            10.0 * tolerance * (1.0 + gradient.norm()));
  for (Eigen::Index i = program.equations(); i < c.size(); ++i) {
    EXPECT_GE(result.multipliers[i], 0.0);
    EXPECT_NEAR(result.multipliers[i] * c[i], 0.0, tolerance);
  }
}

// ---- textbook problems
// --------------------------------------------------------------------------- Numbers as in Hock
// and Schittkowski, Test Examples for Nonlinear Programming Codes, Lecture Notes in Economics and
// Mathematical Systems 187, 1981. Solutions beyond the digits there, and multipliers, are those of
// the first-order conditions with the same active set, solved by Newton's method in 30 digits;
// closed forms where there are some.

TEST(LagrangeNewton, HockSchittkowski6) {
  auto program = written<2>(
      1, [](const auto& x) { return square(1.0 - x[0]); },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{10.0 * (x[1] - square(x[0]))};
      });
  expect_solved(program, vector({-1.2, 1}), {vector({1, 1}), 0.0, vector({0}), {0}});
}

TEST(LagrangeNewton, HockSchittkowski7) {
  auto program = written<2>(
      1, [](const auto& x) { return log(1.0 + square(x[0])) - x[1]; },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{square(1.0 + square(x[0])) + square(x[1]) - 4.0};
      });
  const double root = std::sqrt(3.0);
  expect_solved(program, vector({2, 2}), {vector({0, root}), -root, vector({-0.5 / root}), {0}});
}

TEST(LagrangeNewton, HockSchittkowski28) {
  auto program = written<3>(
      1, [](const auto& x) { return square(x[0] + x[1]) + square(x[1] + x[2]); },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{x[0] + 2.0 * x[1] + 3.0 * x[2] - 1.0};
      });
  expect_solved(program, vector({-4, 1, 1}), {vector({0.5, -0.5, 0.5}), 0.0, vector({0}), {0}});
}

TEST(LagrangeNewton, HockSchittkowski39) {
  auto program = written<4>(
      2, [](const auto& x) { return -x[0]; },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{x[1] - x[0] * x[0] * x[0] - square(x[2]),
                                                 square(x[0]) - x[1] - square(x[3])};
      });
  expect_solved(program, vector({2, 2, 2, 2}),
                {vector({1, 1, 0, 0}), -1.0, vector({1, 1}), {0, 1}});
}

TEST(LagrangeNewton, HockSchittkowski43OfRosenAndSuzuki) {
  auto program = written<4>(
      0,
      [](const auto& x) {
        return square(x[0]) + square(x[1]) + 2.0 * square(x[2]) + square(x[3]) - 5.0 * x[0] -
               5.0 * x[1] - 21.0 * x[2] + 7.0 * x[3];
      },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{
            8.0 - square(x[0]) - square(x[1]) - square(x[2]) - square(x[3]) - x[0] + x[1] - x[2] +
                x[3],
            10.0 - square(x[0]) - 2.0 * square(x[1]) - square(x[2]) - 2.0 * square(x[3]) + x[0] +
                x[3],
            5.0 - 2.0 * square(x[0]) - square(x[1]) - square(x[2]) - 2.0 * x[0] + x[1] + x[3]};
      });
  expect_solved(program, vector({0, 0, 0, 0}),
                {vector({0, 1, 2, -1}), -44.0, vector({1, 0, 2}), {0, 2}});
}

TEST(LagrangeNewton, HockSchittkowski48) {
  auto program = written<5>(
      2,
      [](const auto& x) { return square(x[0] - 1.0) + square(x[1] - x[2]) + square(x[3] - x[4]); },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{x[0] + x[1] + x[2] + x[3] + x[4] - 5.0,
                                                 x[2] - 2.0 * (x[3] + x[4]) + 3.0};
      });
  expect_solved(program, vector({3, 5, -3, 2, -2}),
                {vector({1, 1, 1, 1, 1}), 0.0, vector({0, 0}), {0, 1}});
}

TEST(LagrangeNewton, HockSchittkowski65) {
  auto program = written<3>(
      0,
      [](const auto& x) {
        return square(x[0] - x[1]) + square(x[0] + x[1] - 10.0) / 9.0 + square(x[2] - 5.0);
      },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{48.0 - square(x[0]) - square(x[1]) - square(x[2]),
                                                 x[0] + 4.5,
                                                 4.5 - x[0],
                                                 x[1] + 4.5,
                                                 4.5 - x[1],
                                                 x[2] + 5.0,
                                                 5.0 - x[2]};
      });
  expect_solved(program, vector({-5, 5, 0}),
                {vector({3.650461725213, 3.650461725213, 4.62041755532}),
                 0.95352885680478,
                 vector({0.0821532773035, 0, 0, 0, 0, 0, 0}),
                 {0}});
}

TEST(LagrangeNewton, HockSchittkowski71) {
  auto program = written<4>(
      1, [](const auto& x) { return x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2]; },
      [](const auto& x) {
        ListOf<std::decay_t<decltype(x)>> c{
            square(x[0]) + square(x[1]) + square(x[2]) + square(x[3]) - 40.0,
            x[0] * x[1] * x[2] * x[3] - 25.0};
        for (const auto& entry : x) c.push_back(entry - 1.0);
        for (const auto& entry : x) c.push_back(5.0 - entry);
        return c;
      });
  expect_solved(program, vector({1, 5, 5, 1}),
                {vector({1, 4.7429996372644, 3.8211499841849, 1.3794082931727}),
                 17.014017289156,
                 vector({-0.161468566771, 0.552293660121, 1.08787122867, 0, 0, 0, 0, 0, 0, 0}),
                 {0, 1, 2}});
}

TEST(LagrangeNewton, HockSchittkowski76) {
  auto program = written<4>(
      0,
      [](const auto& x) {
        return square(x[0]) + 0.5 * square(x[1]) + square(x[2]) + 0.5 * square(x[3]) - x[0] * x[2] +
               x[2] * x[3] - x[0] - 3.0 * x[1] + x[2] - x[3];
      },
      [](const auto& x) {
        ListOf<std::decay_t<decltype(x)>> c{5.0 - x[0] - 2.0 * x[1] - x[2] - x[3],
                                            4.0 - 3.0 * x[0] - x[1] - 2.0 * x[2] + x[3],
                                            x[1] + 4.0 * x[2] - 1.5};
        c.insert(c.end(), x.begin(), x.end());
        return c;
      });
  expect_solved(program, vector({0.5, 0.5, 0.5, 0.5}),
                {vector({3.0 / 11, 23.0 / 11, 0, 6.0 / 11}),
                 -103.0 / 22,
                 vector({5.0 / 11, 0, 0, 0, 0, 19.0 / 11, 0}),
                 {0, 5}});
}

TEST(LagrangeNewton, HockSchittkowski77) {
  auto program = written<5>(
      2,
      [](const auto& x) {
        return square(x[0] - 1.0) + square(x[0] - x[1]) + square(x[2] - 1.0) +
               square(square(x[3] - 1.0)) + square(x[4] - 1.0) * square(square(x[4] - 1.0));
      },
      [](const auto& x) {
        using std::sin;
        return ListOf<std::decay_t<decltype(x)>>{
            square(x[0]) * x[3] + sin(x[3] - x[4]) - 2.0 * std::sqrt(2.0),
            x[1] + square(square(x[2])) * square(x[3]) - 8.0 - std::sqrt(2.0)};
      });
  expect_solved(program, vector({2, 2, 2, 2, 2}),
                {vector({1.1661721897093, 1.1821113888027, 1.3802570431455, 1.506036273623,
                         0.61092019604309}),
                 0.24150512879018,
                 vector({0.0855395970428, 0.0318783981868}),
                 {0, 1}},
                1e-5);
}

TEST(LagrangeNewton, HockSchittkowski78) {
  auto program = written<5>(
      3, [](const auto& x) { return x[0] * x[1] * x[2] * x[3] * x[4]; },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{
            square(x[0]) + square(x[1]) + square(x[2]) + square(x[3]) + square(x[4]) - 10.0,
            x[1] * x[2] - 5.0 * x[3] * x[4], x[0] * x[0] * x[0] + x[1] * x[1] * x[1] + 1.0};
      });
  expect_solved(program, vector({-2, 1.5, 2, -1, -1}),
                {vector({-1.7171435703944, 1.5957096901836, 1.8272457529272, -0.76364307818413,
                         -0.76364307818413}),
                 -2.9197004089637,
                 vector({-0.744445930975, 0.703575190017, -0.0968055248951}),
                 {0, 1, 2}});
}

TEST(LagrangeNewton, HockSchittkowski100) {
  auto program = written<7>(
      0,
      [](const auto& x) {
        return square(x[0] - 10.0) + 5.0 * square(x[1] - 12.0) + square(square(x[2])) +
               3.0 * square(x[3] - 11.0) + 10.0 * square(x[4]) * square(square(x[4])) +
               7.0 * square(x[5]) + square(square(x[6])) - 4.0 * x[5] * x[6] - 10.0 * x[5] -
               8.0 * x[6];
      },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{
            127.0 - 2.0 * square(x[0]) - 3.0 * square(square(x[1])) - x[2] - 4.0 * square(x[3]) -
                5.0 * x[4],
            282.0 - 7.0 * x[0] - 3.0 * x[1] - 10.0 * square(x[2]) - x[3] + x[4],
            196.0 - 23.0 * x[0] - square(x[1]) - 6.0 * square(x[5]) + 8.0 * x[6],
            -4.0 * square(x[0]) - square(x[1]) + 3.0 * x[0] * x[1] - 2.0 * square(x[2]) -
                5.0 * x[5] + 11.0 * x[6]};
      });
  expect_solved(program, vector({1, 2, 0, 4, 0, 1, 1}),
                {vector({2.3304993728796, 1.9513723728969, -0.47754139238887, 4.3657262336558,
                         -0.62448697052682, 1.038131018608, 1.5942267116119}),
                 680.6300573744,
                 vector({1.13971995917, 0, 0, 0.368614517187}),
                 {0, 3}},
                1e-5);
}

TEST(LagrangeNewton, HockSchittkowski113) {
  auto program = written<10>(
      0,
      [](const auto& x) {
        return square(x[0]) + square(x[1]) + x[0] * x[1] - 14.0 * x[0] - 16.0 * x[1] +
               square(x[2] - 10.0) + 4.0 * square(x[3] - 5.0) + square(x[4] - 3.0) +
               2.0 * square(x[5] - 1.0) + 5.0 * square(x[6]) + 7.0 * square(x[7] - 11.0) +
               2.0 * square(x[8] - 10.0) + square(x[9] - 7.0) + 45.0;
      },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{
            105.0 - 4.0 * x[0] - 5.0 * x[1] + 3.0 * x[6] - 9.0 * x[7],
            -10.0 * x[0] + 8.0 * x[1] + 17.0 * x[6] - 2.0 * x[7],
            8.0 * x[0] - 2.0 * x[1] - 5.0 * x[8] + 2.0 * x[9] + 12.0,
            -3.0 * square(x[0] - 2.0) - 4.0 * square(x[1] - 3.0) - 2.0 * square(x[2]) + 7.0 * x[3] +
                120.0,
            -5.0 * square(x[0]) - 8.0 * x[1] - square(x[2] - 6.0) + 2.0 * x[3] + 40.0,
            -0.5 * square(x[0] - 8.0) - 2.0 * square(x[1] - 4.0) - 3.0 * square(x[4]) + x[5] + 30.0,
            -square(x[0]) - 2.0 * square(x[1] - 2.0) + 2.0 * x[0] * x[1] - 14.0 * x[4] + 6.0 * x[5],
            3.0 * x[0] - 6.0 * x[1] - 12.0 * square(x[8] - 8.0) + 7.0 * x[9]};
      });
  expect_solved(program, vector({2, 3, 5, 5, 1, 2, 7, 3, 6, 10}),
                {vector({2.1719963712555, 2.3636829736973, 8.7739257384769, 5.0959844879485,
                         0.99065476496386, 1.4305739789363, 1.3216442081617, 9.8287258078863,
                         8.2800916700983, 8.3759266639213}),
                 24.30620906818,
                 vector({1.71653315347, 0.474520154189, 1.37592666392, 0.0205455551024,
                         0.312028508935, 0, 0.287049319291, 0}),
                 {0, 1, 2, 3, 4, 6}},
                1e-5);
}

// ---- the method, step by step ----

TEST(LagrangeNewton, TwoStepsMatchAHandComputation) {
  // min x^2/2, x^2 = 1, from x = 2. First W = 1, f' = 2, c = 3, c' = 4: h = -3/4,
  // lambda = (h + f')/c' = 0.3125, q(h) = 0.28125 - 1.5. At x = 1.25 c = 0.5625. Then
  // y = -0.75 + 1.5 lambda, W = y/h = 0.375: h = -0.225, lambda = 0.46625, now the weight, too.
  auto program = written<1>(
      1, [](const auto& x) { return 0.5 * square(x[0]); },
      [](const auto& x) { return ListOf<std::decay_t<decltype(x)>>{square(x[0]) - 1.0}; });
  const LagrangeNewtonResult result =
      lagrange_newton(program, vector({2}), {.epsilon = 1e-12, .max_iterations = 2});
  EXPECT_EQ(result.stop, Stop::iteration_limit);
  ASSERT_EQ(result.history.size(), 3u);
  EXPECT_DOUBLE_EQ(result.history[0].violation, 3.0);
  const LagrangeNewtonIteration& first = result.history[1];
  EXPECT_EQ(first.number, 1);
  EXPECT_EQ(first.alpha, 1.0);
  EXPECT_DOUBLE_EQ(first.largest, 0.75);
  EXPECT_DOUBLE_EQ(first.cost, 0.78125);
  EXPECT_DOUBLE_EQ(first.penalty, 0.78125 + 0.3125 * 0.5625);
  EXPECT_DOUBLE_EQ(first.violation, 0.5625);
  EXPECT_DOUBLE_EQ(first.eta.model, 1.21875);
  EXPECT_DOUBLE_EQ(first.eta.active, 0.3125 * 0.5625);
  EXPECT_EQ(first.eta.inactive, 0.0);
  EXPECT_TRUE(first.update_kept);
  const LagrangeNewtonIteration& second = result.history[2];
  EXPECT_NEAR(result.y[0], 1.025, 1e-14);
  EXPECT_NEAR(result.multipliers[0], 0.46625, 1e-14);
  EXPECT_NEAR(second.penalty, 0.5 * 1.025 * 1.025 + 0.46625 * 0.050625, 1e-14);
  EXPECT_NEAR(second.eta.model, std::abs(0.5 * 0.375 * 0.225 * 0.225 - 0.225 * 1.25), 1e-14);
}

TEST(LagrangeNewton, WeightsOfThePenaltyFallNoFasterThanByHalf) {
  // min -x, x <= 1, from x = 5: first the multiplier is 5, afterwards 1 or near; the weight, which
  // shows outside the bound alone, 5, 3, ... The constraint is curved so that steps end outside.
  auto program = written<1>(
      0, [](const auto& x) { return -x[0]; },
      [](const auto& x) { return ListOf<std::decay_t<decltype(x)>>{1.0 - square(x[0])}; });
  const LagrangeNewtonResult result =
      lagrange_newton(program, vector({5}), {.epsilon = 1e-12, .max_iterations = 20});
  EXPECT_EQ(result.stop, Stop::converged);
  double weight = 0.0;
  for (std::size_t i = 1; i + 3 < result.history.size(); ++i) {
    const LagrangeNewtonIteration& entry = result.history[i];
    const double lambda = entry.eta.active / entry.violation;
    weight = i == 1 ? lambda : std::max(lambda, 0.5 * (weight + lambda));
    EXPECT_NEAR(entry.penalty, entry.cost + weight * entry.violation, 1e-9) << i;
  }
  EXPECT_NEAR(result.multipliers[0], 0.5, 1e-6);
}

TEST(LagrangeNewton, CurvatureIsUpdatedByBfgs) {
  auto program = unconstrained<3>([](const auto& x) {
    return square(square(x[0] - 1.0)) + square(x[0] + 2.0 * x[1]) + exp(x[2] - x[1]) - x[2];
  });
  const VectorXd start = vector({0.5, 0.3, -0.2});
  MatrixXd w = MatrixXd::Identity(3, 3);
  VectorXd x = start;
  VectorXd gradient;
  program.cost(x, &gradient);
  for (int steps = 1; steps <= 6; ++steps) {
    const LagrangeNewtonResult result =
        lagrange_newton(program, start, {.epsilon = 1e-14, .max_iterations = steps});
    const VectorXd s = result.history.back().alpha * w.ldlt().solve(-gradient);
    x += s;
    EXPECT_LE((result.y - x).norm(), 1e-10) << steps;
    VectorXd next;
    program.cost(x, &next);
    const VectorXd y = next - gradient;
    ASSERT_GT(y.dot(s), 0.0);
    const VectorXd u = w * s;
    w += y * y.transpose() / y.dot(s) - u * u.transpose() / s.dot(u);
    gradient = next;
  }
}

TEST(LagrangeNewton, CurvatureToBeginWithMakesTheFirstStepRight) {
  auto program = unconstrained<2>(
      [](const auto& x) { return 20.0 * (square(x[0] - 1.0) + square(x[1] + 2.0)); });
  const LagrangeNewtonResult result =
      lagrange_newton(program, vector({5, 5}), {.max_iterations = 1, .curvature = 40.0});
  EXPECT_EQ(result.history[1].alpha, 1.0);
  EXPECT_LE((result.y - vector({1, -2})).norm(), 1e-14);
}

TEST(LagrangeNewton, CurvatureIsKeptWhereItIsNotPositive) {
  // f = -exp(-x^2/2) bends downwards beyond |x| = 1: W stays the identity there, steps are -f'.
  auto program = unconstrained<1>([](const auto& x) {
    using std::exp;
    return -exp(-0.5 * square(x[0]));
  });
  const LagrangeNewtonResult result = lagrange_newton(program, vector({2}), {.epsilon = 1e-14});
  EXPECT_EQ(result.stop, Stop::converged);
  EXPECT_NEAR(result.y[0], 0.0, 1e-6);
  const double first = 2.0 * std::exp(-2.0);
  EXPECT_DOUBLE_EQ(result.history[1].largest, first);
  EXPECT_FALSE(result.history[1].update_kept);
  const double x = 2.0 - first;
  EXPECT_NEAR(result.history[2].largest, x * std::exp(-0.5 * x * x), 1e-14);
  const auto kept = [](const LagrangeNewtonIteration& entry) { return entry.update_kept; };
  EXPECT_TRUE(std::any_of(result.history.begin(), result.history.end(), kept));
}

TEST(LagrangeNewton, AStepThatIsTooLongIsShortened) {
  // x^4 from 2: f' = 32, and Delta = -1024. At 2 - 32 f = 810000, where the parabola has its
  // minimum at 1024/1621984 of the step, below a tenth: at 2 - 3.2 f is low enough.
  auto program = unconstrained<1>([](const auto& x) { return square(square(x[0])); });
  const LagrangeNewtonResult result = lagrange_newton(program, vector({2}), {.max_iterations = 1});
  EXPECT_NEAR(result.history[1].alpha, 0.1, 1e-15);
  EXPECT_NEAR(result.y[0], -1.2, 1e-14);
  EXPECT_EQ(result.history[1].evaluations, 4);  // the start, two trials, and with its gradient
}

TEST(LagrangeNewton, AStepIsShortenedToTheMinimumOfTheParabola) {
  // 5 x^2 / 2 from 1: f' = 5, at 1 - 5 f = 40, beta = 25 / (2 (40 - 2.5 + 25)) = 0.2: there it is
  // 0.
  auto program = unconstrained<1>([](const auto& x) { return 2.5 * square(x[0]); });
  const LagrangeNewtonResult result = lagrange_newton(program, vector({1}), {.max_iterations = 1});
  EXPECT_NEAR(result.history[1].alpha, 0.2, 1e-15);
  EXPECT_NEAR(result.y[0], 0.0, 1e-15);
}

TEST(LagrangeNewton, TrialsWithoutAValueAreStepsThatAreTooLong) {
  auto program = unconstrained<1>([](const auto& x) {
    using std::log;
    return 100.0 * x[0] - log(x[0]);
  });
  const LagrangeNewtonResult result = lagrange_newton(program, vector({1}), {.epsilon = 1e-14});
  EXPECT_EQ(result.stop, Stop::converged);
  EXPECT_NEAR(result.history[1].alpha, 0.01, 1e-15);  // 1 - 99, 1 - 9.9: logarithms of negatives
  EXPECT_NEAR(result.y[0], 0.01, 1e-8);
}

// ---- stopping ----

TEST(LagrangeNewton, EpsilonIsWhereItStops) {
  auto program = unconstrained<2>(
      [](const auto& x) { return square(1.0 - x[0]) + 100.0 * square(x[1] - square(x[0])); });
  std::size_t before = 0;
  for (const double epsilon : {1e-2, 1e-6, 1e-12}) {
    const LagrangeNewtonResult result =
        lagrange_newton(program, vector({-1.2, 1}), {.epsilon = epsilon});
    EXPECT_EQ(result.stop, Stop::converged);
    for (std::size_t i = 1; i < result.history.size(); ++i) {
      EXPECT_EQ(result.history[i].eta.sum() < epsilon, i + 1 == result.history.size()) << i;
    }
    EXPECT_GE(result.history.size(), before);
    before = result.history.size();
  }
  EXPECT_GT(before, 20u);
}

TEST(LagrangeNewton, InactiveConstraintsCountInEtaWhereTheyAreViolated) {
  // From 0 with f' = -3 to 3, where 7 - x^3 is at -20; its linearisation, 7, did not see that.
  auto program = written<1>(
      0, [](const auto& x) { return -3.0 * x[0]; },
      [](const auto& x) { return ListOf<std::decay_t<decltype(x)>>{7.0 - x[0] * x[0] * x[0]}; });
  const LagrangeNewtonResult result = lagrange_newton(program, vector({0}), {.max_iterations = 1});
  EXPECT_DOUBLE_EQ(result.history[1].eta.inactive, 20.0);
  EXPECT_DOUBLE_EQ(result.history[1].eta.active, 0.0);
  EXPECT_DOUBLE_EQ(result.history[1].eta.model, 4.5);
  EXPECT_NEAR(lagrange_newton(program, vector({0})).y[0], std::cbrt(7.0), 1e-5);
}

TEST(LagrangeNewton, StopsAtTheLimitOrWhenAsked) {
  auto program = unconstrained<2>(
      [](const auto& x) { return square(1.0 - x[0]) + 100.0 * square(x[1] - square(x[0])); });
  const VectorXd start = vector({-1.2, 1});
  LagrangeNewtonResult result = lagrange_newton(program, start, {.max_iterations = 5});
  EXPECT_EQ(result.stop, Stop::iteration_limit);
  EXPECT_EQ(result.history.size(), 6u);

  result = lagrange_newton(program, start, {.max_iterations = 0});
  EXPECT_EQ(result.stop, Stop::iteration_limit);
  EXPECT_EQ(result.y, start);

  int seen = 0;
  result = lagrange_newton(program, start, {.progress = [&](const LagrangeNewtonIteration& entry) {
                             EXPECT_EQ(entry.number, ++seen);
                             return seen < 3;
                           }});
  EXPECT_EQ(result.stop, Stop::interrupted);
  EXPECT_EQ(result.history.size(), 4u);
}

TEST(LagrangeNewton, ShowsEveryStepTheLastIncluded) {
  auto program = unconstrained<1>([](const auto& x) { return square(square(x[0])) - x[0]; });
  std::size_t seen = 0;
  const LagrangeNewtonResult result =
      lagrange_newton(program, vector({2}),
                      {.progress = [&](const LagrangeNewtonIteration&) { return ++seen > 0; }});
  EXPECT_EQ(result.stop, Stop::converged);
  EXPECT_GE(seen, 3u);
  EXPECT_EQ(seen, result.history.size() - 1);
}

TEST(LagrangeNewton, StaysWhereItHasConverged) {
  auto program = written<2>(
      1, [](const auto& x) { return square(x[0]) + square(x[1]); },
      [](const auto& x) { return ListOf<std::decay_t<decltype(x)>>{x[0] + x[1] - 2.0}; });
  const LagrangeNewtonResult result = lagrange_newton(program, vector({1, 1}));
  EXPECT_EQ(result.stop, Stop::converged);
  EXPECT_LE((result.y - vector({1, 1})).norm(), 1e-15);
  EXPECT_NEAR(result.multipliers[0], 2.0, 1e-15);
}

TEST(LagrangeNewton, EndsWithoutDescentAtTheResolutionOfDoubles) {
  auto program = unconstrained<1>([](const auto& x) { return 1e3 + square(x[0] - 1.0); });
  const LagrangeNewtonResult result = lagrange_newton(program, vector({3}), {.epsilon = 1e-300});
  EXPECT_TRUE(result.stop == Stop::no_descent || result.stop == Stop::converged);
  EXPECT_LE(result.history.size(), 20u);
  EXPECT_NEAR(result.y[0], 1.0, 1e-5);
}

TEST(LagrangeNewton, AGradientOfTheWrongSignEndsWithoutDescent) {
  class Wrong : public NonlinearProgram {
   public:
    Eigen::Index unknowns() const override { return 1; }
    double cost(const VectorXd& y, VectorXd* gradient) const override {
      if (gradient) *gradient = -2.0 * y;
      return y.squaredNorm();
    }
  } program;
  const LagrangeNewtonResult result = lagrange_newton(program, vector({1}));
  EXPECT_EQ(result.stop, Stop::no_descent);
  EXPECT_EQ(result.y[0], 1.0);
}

// ---- constraints that contradict each other ----

TEST(LagrangeNewton, ConstraintsThatContradictAtTheStartAreMetAtTheEnd) {
  // x^2 >= 1 and x^2 >= y^2 have no slope at the origin, where the first is violated.
  auto program = written<2>(
      0, [](const auto& x) { return square(x[0] - 0.1) + square(x[1] - 2.0); },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{square(x[0]) - 1.0, square(x[0]) - square(x[1])};
      });
  const LagrangeNewtonResult result = lagrange_newton(program, vector({0, 0}), {.epsilon = 1e-12});
  EXPECT_EQ(result.stop, Stop::converged);
  EXPECT_TRUE(result.history[1].elastic);
  EXPECT_FALSE(result.history.back().elastic);
  // On x = y: 2 (x - 0.1) + 2 (x - 2) = 0.
  EXPECT_LE((result.y - vector({1.05, 1.05})).norm(), 1e-5) << result.y.transpose();
  EXPECT_LE(result.history.back().violation, 1e-9);
}

TEST(LagrangeNewton, EquationsThatContradictAtTheStartAreMetAtTheEnd) {
  // Powell's example: at y = 0 the circle's linearisation and the line's are parallel.
  auto program = written<2>(
      2, [](const auto& x) { return x[0]; },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{square(x[0]) + square(x[1]) - 1.0, x[0] - 0.6};
      });
  const LagrangeNewtonResult result =
      lagrange_newton(program, vector({2, 1e-12}), {.epsilon = 1e-12});
  EXPECT_EQ(result.stop, Stop::converged);
  EXPECT_NEAR(result.y[0], 0.6, 1e-6);
  EXPECT_NEAR(std::abs(result.y[1]), 0.8, 1e-6);
}

TEST(LagrangeNewton, WhatCannotBeMetIsViolatedLittleAndSaid) {
  // x >= 1 and x <= 0 and y = 3.
  auto program = written<2>(
      1, [](const auto& x) { return square(x[0]) + square(x[1]); },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{x[1] - 3.0, x[0] - 1.0, -x[0]};
      });
  const LagrangeNewtonResult result = lagrange_newton(program, vector({5, 5}));
  EXPECT_EQ(result.stop, Stop::no_descent);
  EXPECT_TRUE(result.history.back().elastic);
  EXPECT_NEAR(result.y[1], 3.0, 1e-9);
  EXPECT_GE(result.y[0], -1e-9);
  EXPECT_LE(result.y[0], 1.0 + 1e-9);
  EXPECT_LE(result.history.size(), 40u);
}

// ---- what a program may decide ----

TEST(LagrangeNewton, StepsAreNoLongerThanAllowed) {
  class Short : public NonlinearProgram {
   public:
    Eigen::Index unknowns() const override { return 1; }
    double cost(const VectorXd& y, VectorXd* gradient) const override {
      if (gradient) *gradient = y;
      return 0.5 * y.squaredNorm();
    }
    double largest_step(const VectorXd& y, const VectorXd& h) const override {
      EXPECT_EQ(h[0], -y[0]);
      return y[0] == 1.0 ? 0.25 : 1.0;
    }
  } program;
  const LagrangeNewtonResult result = lagrange_newton(program, vector({1}));
  EXPECT_EQ(result.history[1].alpha, 0.25);
  EXPECT_EQ(result.history[2].alpha, 1.0);
  EXPECT_EQ(result.y[0], 0.0);
}

// The angle on a circle, as it is or as a local coordinate whose origin moves along.
class OnCircle : public NonlinearProgram {
 public:
  explicit OnCircle(bool local) : local_(local) {}
  Eigen::Index unknowns() const override { return 1; }
  Eigen::Index inequalities() const override { return 1; }
  double cost(const VectorXd& y, VectorXd* gradient) const override {
    const double angle = origin_ + y[0];
    if (gradient) *gradient = vector({-std::sin(angle)});
    return std::cos(angle);
  }
  void constraints(const VectorXd& y, VectorXd& c, SparseRowMatrix* jacobian) const override {
    const double angle = origin_ + y[0];
    c = vector({std::sin(angle) - 0.5});
    if (jacobian) *jacobian = MatrixXd::Constant(1, 1, std::cos(angle)).sparseView();
  }
  VectorXd advance(const VectorXd& y, const VectorXd& step) override {
    if (!local_) return y + step;
    origin_ += step[0];
    return VectorXd::Zero(1);
  }
  double angle(const VectorXd& y) const { return origin_ + y[0]; }

 private:
  bool local_;
  double origin_ = 0.0;
};

TEST(LagrangeNewton, LocalCoordinatesMayMoveAlong) {
  OnCircle global(false);
  OnCircle local(true);
  const LagrangeNewtonResult wanted = lagrange_newton(global, vector({0.9}), {.epsilon = 1e-12});
  VectorXd start = local.advance(vector({0}), vector({0.9}));
  const LagrangeNewtonResult result = lagrange_newton(local, start, {.epsilon = 1e-12});
  EXPECT_EQ(result.stop, Stop::converged);
  EXPECT_EQ(result.y[0], 0.0);
  EXPECT_NEAR(local.angle(result.y), kThirtyFromHalfTurn, 1e-7);
  EXPECT_NEAR(global.angle(wanted.y), kThirtyFromHalfTurn, 1e-7);
  EXPECT_EQ(result.history.size(), wanted.history.size());
  EXPECT_NEAR(result.multipliers[0], std::sqrt(1.0 / 3.0), 1e-6);
}

TEST(LagrangeNewton, HasTheSameBitsEachTime) {
  auto program = written<2>(
      1, [](const auto& x) { return square(1.0 - x[0]); },
      [](const auto& x) {
        return ListOf<std::decay_t<decltype(x)>>{10.0 * (x[1] - square(x[0]))};
      });
  const VectorXd start = vector({-1.2, 1});
  EXPECT_EQ(lagrange_newton(program, start).y, lagrange_newton(program, start).y);
}

TEST(LagrangeNewton, NothingToMove) {
  class Empty : public NonlinearProgram {
   public:
    Eigen::Index unknowns() const override { return 0; }
    double cost(const VectorXd&, VectorXd* gradient) const override {
      if (gradient) gradient->resize(0);
      return 7.0;
    }
  } program;
  const LagrangeNewtonResult result = lagrange_newton(program, VectorXd());
  EXPECT_EQ(result.stop, Stop::nothing_to_move);
  EXPECT_EQ(result.history.at(0).cost, 7.0);
}

TEST(LagrangeNewton, RefusesOptionsAndStartsThatMakeNoSense) {
  auto program = unconstrained<1>([](const auto& x) {
    using std::log;
    return x[0] - log(x[0]);
  });
  const VectorXd start = vector({3});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(lagrange_newton(program, start, {.epsilon = 0.0}), InvalidOption);
  EXPECT_THROW(lagrange_newton(program, start, {.epsilon = nan}), InvalidOption);
  EXPECT_THROW(lagrange_newton(program, start, {.max_iterations = -1}), InvalidOption);
  EXPECT_THROW(lagrange_newton(program, start, {.curvature = 0.0}), InvalidOption);
  EXPECT_THROW(lagrange_newton(program, start, {.elastic_weight = 0.5}), InvalidOption);
  EXPECT_THROW(lagrange_newton(program, vector({-1})), InvalidOption);
  EXPECT_NO_THROW(lagrange_newton(program, start));
}

TEST(LagrangeNewton, MemoryGrowsWithTheSquareOfTheUnknowns) {
  EXPECT_GE(dense_memory_bytes(4000, 0), 8.0 * 4000 * 4000);
  EXPECT_LE(dense_memory_bytes(4000, 0), 1.1 * 8.0 * 4000 * 4000);
  EXPECT_GE(dense_memory_bytes(4000, 10000), 3.0 * 8.0 * 4000 * 4000);
  EXPECT_LE(dense_memory_bytes(4000, 10000), 5.0 * 8.0 * 4000 * 4000);
}

}  // namespace
}  // namespace evenmesh
