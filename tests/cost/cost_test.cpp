// SPDX-License-Identifier: MIT
//
// What every cost must do: derivatives that match finite differences on every kind of cell,
// values that do not change under rigid motion, the right behaviour under scaling, additivity.
#include "evenmesh/cost/cost.h"

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/cost/barycenter.h"
#include "evenmesh/cost/global.h"
#include "evenmesh/cost/local.h"
#include "evenmesh/cost/shape.h"
#include "evenmesh/quality/metric.h"

namespace evenmesh {
namespace {

// One cell of a kind, its ideal form disturbed, with corners that are not numbered in a row.
struct Sample {
  std::vector<Vec3> points;
  std::vector<Index> cell;
  CellBlock block() const { return {kind, static_cast<int>(cell.size()), cell}; }
  CellKind kind;
};

Sample disturbed(CellKind kind, int vertices, double noise) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-noise, noise);
  Sample sample{{}, {}, kind};
  for (int i = 0; i < vertices; ++i) {
    Vec3 p;
    if (kind == CellKind::polygon) {
      p = {std::cos(6.283185307 * i / vertices), std::sin(6.283185307 * i / vertices), 0.0};
    } else {
      const auto& ideal = traits(kind).ideal[static_cast<std::size_t>(i)];
      p = {ideal[0], ideal[1], ideal[2]};
    }
    sample.points.push_back(p + Vec3(jitter(random), jitter(random), jitter(random)));
    sample.cell.push_back(static_cast<Index>(vertices - 1 - i));
  }
  std::reverse(sample.points.begin(), sample.points.end());
  return sample;
}

std::vector<Sample> samples(double noise) {
  std::vector<Sample> all;
  for (const CellKind kind : {CellKind::triangle, CellKind::quad, CellKind::tet, CellKind::hex,
                              CellKind::wedge, CellKind::pyramid}) {
    all.push_back(disturbed(kind, traits(kind).vertices, noise));
  }
  for (const int n : {3, 5, 6, 15}) all.push_back(disturbed(CellKind::polygon, n, noise));
  return all;
}

std::vector<std::shared_ptr<const Cost>> costs(Scaling scaling) {
  return {std::make_shared<Local>(scaling), std::make_shared<Global>(0.8, scaling),
          std::make_shared<Barycenter>(scaling), std::make_shared<Shape>()};
}

double value(const Cost& cost, const Sample& sample, Points x) {
  return cost.evaluate(sample.block(), x, 1.0, {});
}

class EveryCost : public testing::TestWithParam<std::tuple<Scaling, int>> {
 protected:
  const Cost& cost() {
    owned_ = costs(std::get<0>(GetParam()))[static_cast<std::size_t>(std::get<1>(GetParam()))];
    return *owned_;
  }
  bool scale_free() const { return std::get<0>(GetParam()) == Scaling::scale_free; }

 private:
  std::shared_ptr<const Cost> owned_;
};

TEST_P(EveryCost, HasTheGradientOfItsValue) {
  for (const Sample& sample : samples(0.2)) {
    std::vector<Vec3> gradient(sample.points.size(), Vec3::Zero());
    cost().evaluate(sample.block(), sample.points, 1.0, gradient);
    std::vector<Vec3> x = sample.points;
    for (std::size_t v = 0; v < x.size(); ++v) {
      for (int axis = 0; axis < 3; ++axis) {
        const double h = 1e-6;
        const double at = x[v][axis];
        x[v][axis] = at + h;
        const double after = value(cost(), sample, x);
        x[v][axis] = at - h;
        const double before = value(cost(), sample, x);
        x[v][axis] = at;
        EXPECT_NEAR(gradient[v][axis], (after - before) / (2.0 * h), 1e-8)
            << traits(sample.kind).name << " vertex " << v << " axis " << axis;
      }
    }
  }
}

TEST_P(EveryCost, GivesTheSameValueWithAndWithoutGradient) {
  for (const Sample& sample : samples(0.2)) {
    std::vector<Vec3> gradient(sample.points.size(), Vec3::Zero());
    EXPECT_EQ(cost().evaluate(sample.block(), sample.points, 1.0, gradient),
              value(cost(), sample, sample.points));
  }
}

TEST_P(EveryCost, ScalesValueAndGradientByTheWeight) {
  for (const Sample& sample : samples(0.2)) {
    std::vector<Vec3> once(sample.points.size(), Vec3::Zero());
    std::vector<Vec3> thrice(sample.points.size(), Vec3::Zero());
    const double value = cost().evaluate(sample.block(), sample.points, 1.0, once);
    EXPECT_NEAR(cost().evaluate(sample.block(), sample.points, 3.0, thrice), 3.0 * value, 1e-14);
    for (std::size_t v = 0; v < once.size(); ++v) {
      EXPECT_NEAR((thrice[v] - 3.0 * once[v]).norm(), 0, 1e-14);
    }
  }
}

TEST_P(EveryCost, AddsToTheGradientItIsGiven) {
  const Sample sample = disturbed(CellKind::quad, 4, 0.2);
  std::vector<Vec3> once(4, Vec3::Zero());
  cost().evaluate(sample.block(), sample.points, 1.0, once);
  std::vector<Vec3> onto(4, Vec3(1, 2, 3));
  cost().evaluate(sample.block(), sample.points, 1.0, onto);
  for (std::size_t v = 0; v < 4; ++v)
    EXPECT_NEAR((onto[v] - once[v] - Vec3(1, 2, 3)).norm(), 0, 1e-15);
}

TEST_P(EveryCost, DoesNotChangeUnderRigidMotion) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  for (const Sample& sample : samples(0.2)) {
    std::vector<Vec3> moved;
    for (const Vec3& p : sample.points) moved.push_back(turn * p + Vec3(3, -4, 5));
    const double before = value(cost(), sample, sample.points);
    EXPECT_NEAR(value(cost(), sample, moved), before, 1e-12 * (1 + before));
  }
}

TEST_P(EveryCost, ScalesWithTheSquareOfLengthOrNotAtAll) {
  const double s = 3.0;
  for (const Sample& sample : samples(0.2)) {
    std::vector<Vec3> scaled;
    for (const Vec3& p : sample.points) scaled.push_back(s * p);
    const double before = value(cost(), sample, sample.points);
    const auto scaling = std::get<0>(GetParam());
    const double after = cost().name() == "global"
                             ? Global(s * 0.8, scaling).evaluate(sample.block(), scaled, 1.0, {})
                             : value(cost(), sample, scaled);
    const bool is_pure = scale_free() || cost().name() == "shape";
    EXPECT_NEAR(after, is_pure ? before : s * s * before, 1e-12 * (1 + after));
  }
}

TEST_P(EveryCost, StaysFiniteOnACollapsedCell) {
  for (Sample sample : samples(0.0)) {
    for (Vec3& p : sample.points) p = Vec3(1, 2, 3);
    std::vector<Vec3> gradient(sample.points.size(), Vec3::Zero());
    EXPECT_TRUE(std::isfinite(cost().evaluate(sample.block(), sample.points, 1.0, gradient)));
    for (const Vec3& g : gradient) EXPECT_TRUE(g.allFinite());
  }
}

// The springs are to bound the curvature from above where cells are good: the change of the cost
// along any direction is at most what gradient and springs predict (up to third order).
TEST_P(EveryCost, IsBoundedByItsSpringsNearIdealCells) {
  for (const Sample& sample : samples(0.0)) {
    std::vector<Vec3> gradient(sample.points.size(), Vec3::Zero());
    const double before = cost().evaluate(sample.block(), sample.points, 1.0, gradient);
    std::vector<Spring> springs;
    cost().add_springs(sample.block(), sample.points, springs);
    if (cost().name() == "global" && sample.kind == CellKind::polygon) continue;  // compressed
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(-1e-4, 1e-4);
    for (int trial = 0; trial < 50; ++trial) {
      std::vector<Vec3> step(sample.points.size());
      for (Vec3& s : step) s = {jitter(random), jitter(random), jitter(random)};
      std::vector<Vec3> x = sample.points;
      double bound = before;
      for (std::size_t v = 0; v < x.size(); ++v) {
        x[v] += step[v];
        bound += gradient[v].dot(step[v]);
      }
      for (const Spring& spring : springs) {
        bound += 0.5 * spring.stiffness * (step[spring.a] - step[spring.b]).squaredNorm();
      }
      EXPECT_LE(value(cost(), sample, x), bound + 1e-10) << traits(sample.kind).name;
    }
  }
}

std::string variant_name(const testing::TestParamInfo<EveryCost::ParamType>& variant) {
  const Scaling scaling = std::get<0>(variant.param);
  const auto number = static_cast<std::size_t>(std::get<1>(variant.param));
  return std::string(costs(scaling)[number]->name()) +
         (scaling == Scaling::scale_free ? "_scale_free" : "");
}

INSTANTIATE_TEST_SUITE_P(All, EveryCost,
                         testing::Combine(testing::Values(Scaling::absolute, Scaling::scale_free),
                                          testing::Values(0, 1, 2, 3)),
                         variant_name);

double inverse_of(double t) { return 2.0 / (t + std::sqrt(t * t + 0.0025)); }

TEST(Shape, IsTheInverseOfTheMetricWhereAllCornersAreAlike) {
  for (const CellKind kind : {CellKind::triangle, CellKind::tet}) {
    const Sample sample = disturbed(kind, traits(kind).vertices, 0.3);
    std::vector<Vec3> corners;
    for (const Index v : sample.cell) corners.push_back(sample.points[v]);
    const double metric = measure(Metric::shape, kind, corners, Vec3::Zero(), 1.0);
    const double t = std::pow(metric, 0.5 * traits(kind).dimension);
    EXPECT_NEAR(value(Shape(), sample, sample.points), inverse_of(t) - inverse_of(1.0), 1e-13);
  }
}

TEST(Shape, CountsThePowerOfTheInverseForAnExponent) {
  for (const CellKind kind : {CellKind::triangle, CellKind::tet}) {
    const Sample sample = disturbed(kind, traits(kind).vertices, 0.3);
    const double u = value(Shape(), sample, sample.points) + inverse_of(1.0);
    const double expected = (std::pow(u, 5) - std::pow(inverse_of(1.0), 5)) / 5.0;
    EXPECT_NEAR(value(Shape(5), sample, sample.points), expected, 1e-12 * expected);
  }
}

TEST(Shape, CountsTheLogarithmForExponentZero) {
  for (const CellKind kind : {CellKind::triangle, CellKind::tet}) {
    const Sample sample = disturbed(kind, traits(kind).vertices, 0.3);
    const double u = value(Shape(), sample, sample.points) + inverse_of(1.0);
    EXPECT_NEAR(value(Shape(0), sample, sample.points), std::log(u / inverse_of(1.0)), 1e-13);
  }
}

TEST(Shape, LetsCellsOverTheLessTheSmallerTheSoftness) {
  Sample flat = disturbed(CellKind::triangle, 3, 0.0);
  flat.points[flat.cell[2]] = 0.5 * (flat.points[flat.cell[0]] + flat.points[flat.cell[1]]);
  EXPECT_NEAR(value(Shape(), flat, flat.points), 40.0 - inverse_of(1.0), 1e-9);
  EXPECT_NEAR(value(Shape(1, 0.005), flat, flat.points), 400.0 - 1.0, 1e-2);
}

class ShapeOfAnExponent : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Some, ShapeOfAnExponent, testing::Values(0, 2, 8));

TEST_P(ShapeOfAnExponent, HasTheGradientOfItsValue) {
  const Shape cost(GetParam());
  for (const Sample& sample : samples(0.1)) {
    std::vector<Vec3> gradient(sample.points.size(), Vec3::Zero());
    cost.evaluate(sample.block(), sample.points, 1.0, gradient);
    std::vector<Vec3> x = sample.points;
    for (std::size_t v = 0; v < x.size(); ++v) {
      for (int axis = 0; axis < 3; ++axis) {
        constexpr double h = 1e-6;
        const double at = x[v][axis];
        x[v][axis] = at + h;
        const double after = value(cost, sample, x);
        x[v][axis] = at - h;
        const double before = value(cost, sample, x);
        x[v][axis] = at;
        EXPECT_NEAR(gradient[v][axis], (after - before) / (2.0 * h),
                    1e-6 * std::max(1.0, std::abs(gradient[v][axis])))
            << traits(sample.kind).name;
      }
    }
  }
}

TEST(Shape, IsZeroForIdealCellsOfAnySize) {
  for (Sample sample : samples(0.0)) {
    for (Vec3& p : sample.points) p *= 1e-7;
    EXPECT_NEAR(value(Shape(), sample, sample.points), 0.0, 1e-14) << traits(sample.kind).name;
  }
}

TEST(Shape, FallsSteadilyFromTheMirrorImageToTheIdealCell) {
  const std::vector<Index> cell{0, 1, 2};
  const std::vector<std::uint32_t> numbers{0};
  Orientation orientation;
  orientation.type = MeshType::planar;
  orientation.normal = Vec3::UnitZ();
  const CellBlock block{CellKind::triangle, 3, cell, numbers, &orientation};
  double before = std::numeric_limits<double>::infinity();
  for (double y = -0.86; y < 0.86; y += 0.02) {
    std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0.5, y, 0}};
    std::vector<Vec3> gradient(3, Vec3::Zero());
    const double f = Shape().evaluate(block, x, 1.0, gradient);
    EXPECT_LT(f, before) << y;
    before = f;
    const double h = 1e-6;
    x[2].y() += h;
    const double after = Shape().evaluate(block, x, 1.0, {});
    x[2].y() -= 2.0 * h;
    const double slope = (after - Shape().evaluate(block, x, 1.0, {})) / (2.0 * h);
    EXPECT_NEAR(gradient[2].y(), slope, 1e-6 * std::abs(slope)) << y;
  }
}

TEST(Shape, KnowsHowCellsAreWound) {
  Sample hex = disturbed(CellKind::hex, 8, 0.1);
  const double right = value(Shape(), hex, hex.points);
  for (Vec3& p : hex.points) p.x() = -p.x();
  EXPECT_GT(value(Shape(), hex, hex.points), 100.0);
  Orientation orientation;
  orientation.type = MeshType::volume;
  orientation.signs = {-1};
  const std::vector<std::uint32_t> numbers{0};
  CellBlock block = hex.block();
  block.numbers = numbers;
  block.orientation = &orientation;
  EXPECT_NEAR(Shape().evaluate(block, hex.points, 1.0, {}), right, 1e-13);
  // The skin of a volume is not smoothed for its own sake.
  const Sample quad = disturbed(CellKind::quad, 4, 0.2);
  block = quad.block();
  block.numbers = numbers;
  block.orientation = &orientation;
  std::vector<Spring> springs;
  Shape().add_springs(block, quad.points, springs);
  EXPECT_TRUE(springs.empty());
  EXPECT_EQ(Shape().evaluate(block, quad.points, 1.0, {}), 0.0);
}

TEST(Local, MatchesAHandComputedValue) {
  // A 3-4-5 triangle: mean 4, f = 1 + 0 + 1.
  const std::vector<Vec3> x{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  const std::vector<Index> cell{0, 1, 2};
  const CellBlock block{CellKind::triangle, 3, cell};
  EXPECT_DOUBLE_EQ(Local().evaluate(block, x, 1.0, {}), 2.0);
  EXPECT_DOUBLE_EQ(Local(Scaling::scale_free).evaluate(block, x, 1.0, {}), 2.0 / 16.0);
}

TEST(Global, MatchesAHandComputedValue) {
  const std::vector<Vec3> x{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  const std::vector<Index> cell{0, 1, 2};
  const CellBlock block{CellKind::triangle, 3, cell};
  EXPECT_DOUBLE_EQ(Global(3.0).evaluate(block, x, 1.0, {}), 4.0 + 1.0);
  // The leg of length 4 pulls vertex 2 down with 2 (4 - 3), the hypotenuse with 2 (5 - 3) along it.
  std::vector<Vec3> gradient(3, Vec3::Zero());
  Global(3.0).evaluate(block, x, 1.0, gradient);
  EXPECT_NEAR((gradient[2] - (2.0 * Vec3(0, 1, 0) + 4.0 * Vec3(-0.6, 0.8, 0))).norm(), 0, 1e-15);
}

TEST(Global, RejectsALengthThatIsNotPositive) {
  EXPECT_THROW(Global(0.0), InvalidOption);
  EXPECT_THROW(Global(-1.0), InvalidOption);
  EXPECT_THROW(Global(std::numeric_limits<double>::infinity()), InvalidOption);
  EXPECT_THROW(Global(std::nan("")), InvalidOption);
}

TEST(Barycenter, MatchesAHandComputedValue) {
  // Diagonals 5 and 2.
  const std::vector<Vec3> x{{0, 0, 0}, {2, -1, 0}, {5, 0, 0}, {2, 1, 0}};
  const std::vector<Index> cell{0, 1, 2, 3};
  EXPECT_DOUBLE_EQ(Barycenter().evaluate({CellKind::quad, 4, cell}, x, 1.0, {}), 9.0);
  EXPECT_DOUBLE_EQ(Barycenter(Scaling::scale_free).evaluate({CellKind::quad, 4, cell}, x, 1.0, {}),
                   9.0 / (3.5 * 3.5));
}

TEST(Barycenter, IsZeroOnTrianglesRectanglesAndRegularPolygons) {
  const std::vector<Vec3> x{{0, 0, 0}, {7, 0, 0}, {7, 2, 0}, {0, 2, 0}};
  const std::vector<Index> cell{0, 1, 2, 3};
  EXPECT_DOUBLE_EQ(Barycenter().evaluate({CellKind::quad, 4, cell}, x, 1.0, {}), 0.0);
  EXPECT_DOUBLE_EQ(
      Barycenter().evaluate({CellKind::triangle, 3, std::span(cell).first(3)}, x, 1.0, {}), 0.0);
  const Sample hexagon = disturbed(CellKind::polygon, 6, 0.0);
  EXPECT_NEAR(Barycenter().evaluate(hexagon.block(), hexagon.points, 1.0, {}), 0.0, 1e-18);
}

TEST(MeanEdgeLength, CountsAnEdgeInEveryCellThatHasIt) {
  // Two 3-4-5 triangles that share the edge of length 5: (3 + 4 + 5) * 2 / 6.
  Cells cells;
  cells.add(CellKind::triangle, std::vector<Index>{0, 1, 2});
  cells.add(CellKind::triangle, std::vector<Index>{1, 3, 2});
  const Mesh mesh({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {3, 4, 0}}, std::move(cells));
  EXPECT_DOUBLE_EQ(mean_edge_length(mesh), 4.0);
}

TEST(LengthFromSize, IsTheEdgeLengthOfAnIdealMesh) {
  Cells cells;
  cells.add(CellKind::quad, std::vector<Index>{0, 1, 2, 3});
  const Mesh square({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, std::move(cells));
  EXPECT_DOUBLE_EQ(length_from_size(square, find_orientation(square)), 2.0);
  for (const CellKind kind : {CellKind::tet, CellKind::hex, CellKind::wedge, CellKind::pyramid}) {
    const Sample sample = disturbed(kind, traits(kind).vertices, 0.0);
    Cells one;
    one.add(kind, sample.cell);
    const Mesh mesh(sample.points, std::move(one));
    EXPECT_NEAR(length_from_size(mesh, find_orientation(mesh)), 1.0, 1e-14) << traits(kind).name;
  }
}

}  // namespace
}  // namespace evenmesh
