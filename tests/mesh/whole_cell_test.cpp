// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/whole_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "evenmesh/mesh/measure.h"
#include "tests/support/random.h"

namespace evenmesh {
namespace {

using Corners = std::vector<Vec3>;

// A box 4 by 1 by 1 whose top has sides (-1, 0) and (0, -4) instead: every corner determinant is 4,
// and at height w the determinant is (4 - 5 w) (1 - 5 w), half-way up -2.25.
const Corners kTwistedHex{{0, 0, 0}, {4, 0, 0},  {4, 1, 0},   {0, 1, 0},
                          {0, 0, 1}, {-1, 0, 1}, {-1, -4, 1}, {0, -4, 1}};
const Corners kTwistedWedge{{0, 0, 0}, {4, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 1}, {0, -4, 1}};

// Positive at the corners (106 at least) and all along the edges, but not between them; found by a
// random search over whole numbers.
const Corners kFoldedHex{{-5, -2, 6},  {5, 6, -6},  {13, 3, 5}, {3, 5, 5},
                         {-2, -5, 12}, {15, -1, 4}, {5, 3, 10}, {-5, 12, 9}};

Corners ideal(CellKind kind) {
  Corners result;
  for (const auto& p : traits(kind).ideal) result.emplace_back(p[0], p[1], p[2]);
  return result;
}

Corners shaken(CellKind kind, double amount, shapes::Random& random) {
  Corners result = ideal(kind);
  for (Vec3& p : result) {
    p += amount * Vec3(random.signed_unit(), random.signed_unit(), random.signed_unit());
  }
  return result;
}

Corners between(const Corners& a, const Corners& b, double t) {
  Corners result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back((1.0 - t) * a[i] + t * b[i]);
  return result;
}

Corners picked(const Corners& corners, const std::vector<std::size_t>& order) {
  Corners result;
  for (const std::size_t i : order) result.push_back(corners[i]);
  return result;
}

double least_at_corners(CellKind kind, const Corners& x) {
  return least_corner(
      kind, static_cast<int>(x.size()),
      [&](int i) -> const Vec3& { return x[static_cast<std::size_t>(i)]; }, Vec3::Zero(), 1.0);
}

// The Jacobian determinant from the gradients of the shape functions.
double determinant_at(CellKind kind, const Corners& x, double u, double v, double w) {
  Vec3 by_u = Vec3::Zero();
  Vec3 by_v = Vec3::Zero();
  Vec3 by_w = Vec3::Zero();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (kind == CellKind::hex) {
      const auto& at = traits(kind).ideal[i];  // the corners of the unit cube
      const auto one = [](double corner, double t) { return corner > 0.5 ? t : 1.0 - t; };
      const auto slope = [](double corner) { return corner > 0.5 ? 1.0 : -1.0; };
      by_u += slope(at[0]) * one(at[1], v) * one(at[2], w) * x[i];
      by_v += one(at[0], u) * slope(at[1]) * one(at[2], w) * x[i];
      by_w += one(at[0], u) * one(at[1], v) * slope(at[2]) * x[i];
    } else if (kind == CellKind::wedge) {
      const double height = i < 3 ? 1.0 - w : w;
      const double part[] = {1.0 - u - v, u, v};
      const double in_u[] = {-1.0, 1.0, 0.0};
      const double in_v[] = {-1.0, 0.0, 1.0};
      by_u += height * in_u[i % 3] * x[i];
      by_v += height * in_v[i % 3] * x[i];
      by_w += (i < 3 ? -1.0 : 1.0) * part[i % 3] * x[i];
    } else {  // pyramid: (1 - w) times a bilinear base, and w times the apex
      const double part[] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v, 0.0};
      const double in_u[] = {v - 1, 1 - v, v, -v, 0.0};
      const double in_v[] = {u - 1, -u, u, 1 - u, 0.0};
      by_u += (1.0 - w) * in_u[i] * x[i];
      by_v += (1.0 - w) * in_v[i] * x[i];
      by_w += (i < 4 ? -part[i] : 1.0) * x[i];
    }
  }
  return by_u.cross(by_v).dot(by_w);
}

struct Sampled {
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0.0;  // size
};

// On a grid of so many intervals; a pyramid's apex, where the determinant is zero, is left out.
Sampled sample(CellKind kind, const Corners& x, int n) {
  Sampled result;
  for (int k = 0; k <= n - (kind == CellKind::pyramid ? 1 : 0); ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n - (kind == CellKind::wedge ? j : 0); ++i) {
        const double value = determinant_at(kind, x, static_cast<double>(i) / n,
                                            static_cast<double>(j) / n, static_cast<double>(k) / n);
        result.least = std::min(result.least, value);
        result.greatest = std::max(result.greatest, std::abs(value));
      }
    }
  }
  return result;
}

TEST(TwistedCell, IsPositiveAtItsCornersOnly) {
  for (const auto& [kind, cell] :
       {std::pair(CellKind::hex, kTwistedHex), std::pair(CellKind::wedge, kTwistedWedge)}) {
    EXPECT_EQ(least_at_corners(kind, cell), 4.0);
    EXPECT_FALSE(is_positive_everywhere(kind, cell, 1.0));
    EXPECT_NEAR(least_determinant(kind, cell, 1.0), -2.25, 1e-10);
    EXPECT_NEAR(sample(kind, cell, 50).least, -2.25, 1e-12);
  }
}

TEST(FoldedHex, IsPositiveAlongItsEdgesOnly) {
  EXPECT_EQ(least_at_corners(CellKind::hex, kFoldedHex), 106.0);
  for (int i = 0; i <= 50; ++i) {
    const double t = i / 50.0;
    for (const double a : {0.0, 1.0}) {
      for (const double b : {0.0, 1.0}) {
        EXPECT_GT(determinant_at(CellKind::hex, kFoldedHex, t, a, b), 0.0);
        EXPECT_GT(determinant_at(CellKind::hex, kFoldedHex, a, t, b), 0.0);
        EXPECT_GT(determinant_at(CellKind::hex, kFoldedHex, a, b, t), 0.0);
      }
    }
  }
  const double sampled = sample(CellKind::hex, kFoldedHex, 50).least;
  EXPECT_LT(sampled, -50.0);
  EXPECT_FALSE(is_positive_everywhere(CellKind::hex, kFoldedHex, 1.0));
  EXPECT_LE(least_determinant(CellKind::hex, kFoldedHex, 1.0), sampled + 1e-9);
  EXPECT_NEAR(least_determinant(CellKind::hex, kFoldedHex, 1.0), sampled, 1.0);
}

TEST(WholeCell, AgreesWithSamplesWhereTheseAreClear) {
  constexpr int kIntervals = 12;
  constexpr double kClear = 0.02;
  for (const CellKind kind : {CellKind::hex, CellKind::wedge, CellKind::pyramid}) {
    shapes::Random random(7);
    int positive = 0;
    int folded = 0;  // but not at a corner
    for (int i = 0; i < 800; ++i) {
      const Corners cell = shaken(kind, 0.65, random);
      if (!(least_at_corners(kind, cell) > 0.0)) {
        EXPECT_FALSE(is_positive_everywhere(kind, cell, 1.0));
        continue;
      }
      const Sampled sampled = sample(kind, cell, kIntervals);
      const bool is_positive = is_positive_everywhere(kind, cell, 1.0);
      if (sampled.least <= 0.0) {
        EXPECT_FALSE(is_positive);
        ++folded;
      } else if (kind == CellKind::pyramid || sampled.least > kClear * sampled.greatest) {
        EXPECT_TRUE(is_positive);
        ++positive;
      }
    }
    EXPECT_GT(positive, 80) << traits(kind).name;
    EXPECT_EQ(folded > 0, kind != CellKind::pyramid) << traits(kind).name;
  }
}

TEST(WholeCell, HasItsLeastDeterminantWhereSamplesHaveIt) {
  for (const CellKind kind : {CellKind::hex, CellKind::wedge}) {
    shapes::Random random(11);
    for (int i = 0; i < 200; ++i) {
      const Corners cell = shaken(kind, 0.6, random);
      const Sampled sampled = sample(kind, cell, 12);
      const double least = least_determinant(kind, cell, 1.0);
      EXPECT_LE(least, sampled.least + 1e-12);
      EXPECT_GT(least, sampled.least - 0.02 * sampled.greatest);
      EXPECT_LE(least, least_at_corners(kind, cell) + 1e-12);
    }
  }
}

TEST(WholeCell, IsPositiveIfTheLeastDeterminantIsJustAboveZero) {
  const Corners good = [] {
    Corners cube = ideal(CellKind::hex);
    for (Vec3& p : cube) p *= 10.0;
    return cube;
  }();
  double valid = 0.0;  // of the way from good to folded
  double inverted = 1.0;
  const auto least = [&](double t) {
    return least_determinant(CellKind::hex, between(good, kFoldedHex, t), 1.0);
  };
  while (inverted - valid > 1e-11) {
    const double t = 0.5 * (valid + inverted);
    (least(t) > 0.0 ? valid : inverted) = t;
  }
  ASSERT_LT(least(valid - 1e-9), 1e-5);  // of about 500
  EXPECT_TRUE(is_positive_everywhere(CellKind::hex, between(good, kFoldedHex, valid - 1e-9), 1.0));
  EXPECT_FALSE(
      is_positive_everywhere(CellKind::hex, between(good, kFoldedHex, inverted + 1e-9), 1.0));
}

TEST(HalfTurnedHex, IsPositiveWhenALittleIsMissing) {
  // At height w the determinant is (1 - w)^2 + w^2 + 2 w (1 - w) cos(turn), least all over the
  // height 1/2.
  for (const double missing : {1e-2, 1e-4}) {
    const double turn = std::numbers::pi - missing;
    Corners cell = ideal(CellKind::hex);
    for (std::size_t i = 4; i < 8; ++i) {
      cell[i] = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * cell[i];
    }
    EXPECT_TRUE(is_positive_everywhere(CellKind::hex, cell, 1.0));
    EXPECT_NEAR(least_determinant(CellKind::hex, cell, 1.0), 0.5 * (1.0 + std::cos(turn)), 1e-11);
  }
  Corners cell = ideal(CellKind::hex);
  for (std::size_t i = 4; i < 8; ++i) cell[i] = Vec3(-cell[i][0], -cell[i][1], 1.0);
  EXPECT_EQ(least_at_corners(CellKind::hex, cell), 1.0);
  EXPECT_FALSE(is_positive_everywhere(CellKind::hex, cell, 1.0));
  EXPECT_EQ(least_determinant(CellKind::hex, cell, 1.0), 0.0);
}

TEST(WholeCell, IsPositiveForIdealAndShearedCells) {
  Eigen::Matrix3d shear;
  shear << 1, 40, -7, 0, 1e-3, 90, 0, 0, 25;
  for (const CellKind kind : {CellKind::tet, CellKind::hex, CellKind::wedge, CellKind::pyramid}) {
    Corners cell = ideal(kind);
    EXPECT_TRUE(is_positive_everywhere(kind, cell, 1.0)) << traits(kind).name;
    EXPECT_FALSE(is_positive_everywhere(kind, cell, -1.0)) << traits(kind).name;
    const double corner = least_at_corners(kind, cell);
    EXPECT_NEAR(least_determinant(kind, cell, 1.0), corner, 1e-14) << traits(kind).name;
    for (Vec3& p : cell) p = shear * p;
    EXPECT_TRUE(is_positive_everywhere(kind, cell, 1.0)) << traits(kind).name;
    EXPECT_NEAR(least_determinant(kind, cell, 1.0), 0.025 * corner, 1e-11) << traits(kind).name;
    for (Vec3& p : cell) p[2] = 0.0;
    EXPECT_FALSE(is_positive_everywhere(kind, cell, 1.0)) << traits(kind).name;
    EXPECT_FALSE(is_positive_everywhere(kind, Corners(cell.size(), Vec3::Zero()), 1.0));
  }
}

TEST(WholeCell, DoesNotDependOnNumberingPlaceOrSize) {
  const std::vector<std::vector<std::size_t>> turns_of_hex{{1, 2, 3, 0, 5, 6, 7, 4},
                                                           {3, 2, 6, 7, 0, 1, 5, 4}};
  const std::vector<std::vector<std::size_t>> turns_of_wedge{{1, 2, 0, 4, 5, 3},
                                                             {3, 5, 4, 0, 2, 1}};
  const Eigen::AngleAxisd rotation(0.7, Vec3(1, 2, 3).normalized());
  for (const CellKind kind : {CellKind::hex, CellKind::wedge}) {
    const auto& turns = kind == CellKind::hex ? turns_of_hex : turns_of_wedge;
    shapes::Random random(5);
    for (int i = 0; i < 300; ++i) {
      const Corners cell = shaken(kind, 0.6, random);
      const double least = least_determinant(kind, cell, 1.0);
      const bool is_positive = is_positive_everywhere(kind, cell, 1.0);
      EXPECT_EQ(is_positive, least > 0.0);
      Corners turned = cell;
      for (int turn = 0; turn < 12; ++turn) {
        turned = picked(turned, turns[turn % 3 == 2 ? 1 : 0]);
        EXPECT_NEAR(least_determinant(kind, turned, 1.0), least, 1e-10);
        EXPECT_EQ(is_positive_everywhere(kind, turned, 1.0), is_positive);
      }
      Corners other = cell;
      for (Vec3& p : other) p = rotation * (1e-30 * p);
      EXPECT_EQ(is_positive_everywhere(kind, other, 1.0), is_positive);
      EXPECT_NEAR(1e90 * least_determinant(kind, other, 1.0), least, 1e-10);
      for (Vec3& p : other) p[0] = -p[0];  // turned over, and on purpose
      EXPECT_EQ(is_positive_everywhere(kind, other, -1.0), is_positive);
    }
  }
}

}  // namespace
}  // namespace evenmesh
