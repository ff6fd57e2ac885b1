// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/function_of.h"

#include <cmath>
#include <numbers>
#include <type_traits>

#include <gtest/gtest.h>
#include <unsupported/Eigen/AutoDiff>

#include "evenmesh/base/error.h"
#include "tests/constraint/differences.h"
#include "tests/support/random.h"

namespace evenmesh {
namespace {

constexpr auto kAngle = [](auto x) {
  using Vector = typename decltype(x)::value_type;
  const Vector a = x[1] - x[0];
  const Vector b = x[2] - x[0];
  return atan2(a.cross(b).norm(), a.dot(b));
};

std::vector<Vec3> random_points(std::size_t count, std::uint64_t seed = 1) {
  shapes::Random random(seed);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) {
    for (double& coordinate : p) coordinate = random.signed_unit();
  }
  return points;
}

std::string complaint(std::vector<Index> vertices) {
  try {
    function_of("span", std::move(vertices), [](auto x) { return x[0].x(); });
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "";
}

TEST(FunctionOf, MatchesAHandComputedLength) {
  const auto f = function_of("length", {2, 0}, [](auto x) { return (x[1] - x[0]).norm() - 1.0; });
  EXPECT_EQ(f->name(), "length");
  EXPECT_EQ(f->vertices()[0], 2u);
  const std::vector<Vec3> x{{3, 0, 4}, {9, 9, 9}, {0, 0, 0}};
  std::vector<Vec3> gradient(2, Vec3(7, 7, 7));
  EXPECT_EQ(f->evaluate(x, gradient), 4.0);
  EXPECT_LT((gradient[0] - Vec3(-0.6, 0, -0.8)).norm(), 1e-15);
  EXPECT_LT((gradient[1] - Vec3(0.6, 0, 0.8)).norm(), 1e-15);
  EXPECT_EQ(f->evaluate(x, {}), 4.0);
}

TEST(FunctionOf, DifferentiatesAnAngle) {
  const std::vector<Vec3> x{{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
  const auto f = function_of("angle", {0, 1, 2}, kAngle);
  std::vector<Vec3> gradient(3);
  EXPECT_DOUBLE_EQ(f->evaluate(x, gradient), std::numbers::pi / 2.0);
  EXPECT_LT((gradient[1] - Vec3(0, -0.5, 0)).norm(), 1e-15);
  EXPECT_LT((gradient[2] - Vec3(-0.25, 0, 0)).norm(), 1e-15);
  EXPECT_LT((gradient[0] - Vec3(0.25, 0.5, 0)).norm(), 1e-15);
  expect_true_gradient(*f, random_points(3));
}

// Every function that a formula may call, against differences.
TEST(FunctionOf, DifferentiatesEveryFunction) {
  const auto all = [](auto x) {
    using T = typename decltype(x)::value_type::Scalar;
    const T a = x[0].x() * x[1].y() + 2.0;
    const T b = x[1].z() / (3.0 + x[0].y());
    T sum = sqrt(a) - abs(b) + exp(b) * log(a);
    sum += sin(a) * cos(b) + tan(b) / a;
    sum -= asin(0.5 * b) + acos(0.3 * b) * atan(a);
    sum *= pow(a, 2.5) + pow(a, b) + pow(b, 2);
    sum /= hypot(a, b) + atan2(b, a);
    sum += min(a, b) * max(a, b) + (a < b ? a : 2 * b);
    sum += (2.0 * x[0] - x[1] * 3.0).cross(x[1] / 2.0).dot(Vec3(1, 2, 3));
    return -sum + x[0].normalized().sum() + x[1].squaredNorm();
  };
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    expect_true_gradient(*function_of("all", {0, 1}, all), random_points(2, seed), 1e-6);
  }
}

TEST(FunctionOf, AgreesWithAnotherImplementation) {
  using Other = Eigen::AutoDiffScalar<Eigen::Matrix<double, 9, 1>>;
  const std::vector<Vec3> points = random_points(3);
  std::vector<Eigen::Matrix<Other, 3, 1>> x(3);
  for (Eigen::Index i = 0; i < 9; ++i) {
    x[static_cast<std::size_t>(i / 3)][i % 3] =
        Other(points[static_cast<std::size_t>(i / 3)][i % 3], 9, static_cast<int>(i));
  }
  const Other expected = kAngle(Corners<Other>(x));
  std::vector<Vec3> gradient(3);
  EXPECT_DOUBLE_EQ(function_of("angle", {0, 1, 2}, kAngle)->evaluate(points, gradient),
                   expected.value());
  for (Eigen::Index i = 0; i < 9; ++i) {
    EXPECT_NEAR(gradient[static_cast<std::size_t>(i / 3)][i % 3], expected.derivatives()[i], 1e-14);
  }
}

// 4 vertices fill a pass, 8 the stack.
TEST(FunctionOf, TakesAnyNumberOfVertices) {
  const auto chain = [](auto x) {
    typename decltype(x)::value_type::Scalar sum = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) sum += (x[i] - x[i - 1]).norm();
    return sum * sum + x[0].y();
  };
  for (const Index count : {1, 2, 4, 5, 8, 9, 13, 30}) {
    std::vector<Index> vertices;
    for (Index i = 0; i < count; ++i) vertices.push_back((7 * i + 3) % 31);
    const auto f = function_of("chain", vertices, chain);
    expect_true_gradient(*f, random_points(31, count), 1e-6);
  }
}

// Newton takes second derivatives from differences of the gradient, which no noise may spoil.
TEST(FunctionOf, GradientIsSmooth) {
  const auto f = function_of("angle", {0, 1, 2}, kAngle);
  const std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
  // d/dy of the derivative with respect to the y of vertex 1: along the arm of length 2 the angle
  // is atan2(4, 0) - atan2(y, 2), whose second derivative at t = y / 2 is 2 t / (1 + t^2)^2 / 4.
  for (const double y : {-0.7, 0.1, 0.3}) {
    constexpr double kStep = 1e-4;
    const auto slope = [&](double at) {
      std::vector<Vec3> x = points;
      x[1].y() = at;
      std::vector<Vec3> gradient(3);
      f->evaluate(x, gradient);
      return gradient[1].y();
    };
    const double t = y / 2.0;
    EXPECT_NEAR((slope(y + kStep) - slope(y - kStep)) / (2.0 * kStep),
                2.0 * t / ((1.0 + t * t) * (1.0 + t * t)) / 4.0, 1e-8);
    for (const double tiny : {1e-9, 1e-8, 1e-7}) {  // linear down to rounding
      const double slope_ratio = -0.5 / (1.0 + t * t);
      EXPECT_NEAR(slope(y + tiny) - slope_ratio, tiny * t / (2.0 * std::pow(1.0 + t * t, 2)),
                  1e-12);
    }
  }
}

TEST(FunctionOf, HasSlopeZeroAtALengthOfZero) {
  const auto f = function_of("length", {0, 1}, [](auto x) { return (x[1] - x[0]).norm(); });
  const std::vector<Vec3> x(2, Vec3(1, 2, 3));
  std::vector<Vec3> gradient(2, Vec3(7, 7, 7));
  EXPECT_EQ(f->evaluate(x, gradient), 0.0);
  EXPECT_TRUE(gradient[0].isZero(0.0) && gradient[1].isZero(0.0));
}

TEST(FunctionOf, PassesOnWhatIsNotFinite) {
  const auto f = function_of("log", {0}, [](auto x) { return log(x[0].x()); });
  std::vector<Vec3> gradient(1);
  EXPECT_TRUE(std::isnan(f->evaluate(std::vector<Vec3>{{-1, 0, 0}}, gradient)));
  EXPECT_TRUE(std::isinf(f->evaluate(std::vector<Vec3>{{0, 0, 0}}, gradient)));
}

TEST(FunctionOf, RejectsVerticesNamedTwiceOrNotAtAll) {
  EXPECT_EQ(complaint({3, 7, 12}), "");
  EXPECT_NE(complaint({}).find("'span' depends on no vertex"), std::string::npos);
  EXPECT_NE(complaint({3, 7, 3}).find("'span' names vertex 3"), std::string::npos);
}

}  // namespace
}  // namespace evenmesh
