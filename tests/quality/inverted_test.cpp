// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "evenmesh/quality/metric.h"
#include "tests/quality/cells.h"

namespace evenmesh {
namespace {

using cells::Corners;

const Corners kConcaveQuad{{0, 0, 0}, {1, 0, 0}, {0.3, 0.3, 0}, {0, 1, 0}};
const Corners kBowTie{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};

TEST(CellTurnedOver, IsInvertedWithShapeZeroAndNegativeScaledJacobian) {
  for (const CellKind kind : cells::all_kinds()) {
    const Corners over = cells::mirrored(cells::ideal(kind));
    EXPECT_TRUE(is_inverted(kind, over, cells::kUp)) << traits(kind).name;
    EXPECT_EQ(measure(Metric::shape, kind, over, cells::kUp), 0.0) << traits(kind).name;
    EXPECT_NEAR(measure(Metric::scaled_jacobian, kind, over, cells::kUp), -1.0, 1e-14)
        << traits(kind).name;
  }
}

TEST(CellWoundTheOtherWay, IsFineWhenThatIsOnPurpose) {
  for (const CellKind kind : cells::all_kinds()) {
    const Corners over = cells::mirrored(cells::ideal(kind));
    EXPECT_FALSE(is_inverted(kind, over, -cells::kUp, -1.0)) << traits(kind).name;
    EXPECT_NEAR(measure(Metric::shape, kind, over, -cells::kUp, -1.0), 1.0, 1e-14);
    EXPECT_NEAR(measure(Metric::scaled_jacobian, kind, over, -cells::kUp, -1.0), 1.0, 1e-14);
  }
}

TEST(SurfaceCellTurnedOver, KeepsItsAnglesAndRatios) {
  std::mt19937 random(3);
  for (const CellKind kind : {CellKind::triangle, CellKind::quad, CellKind::polygon}) {
    const Corners cell = cells::shaken(kind, 0.1, random);
    for (const Metric metric :
         {Metric::min_angle, Metric::max_angle, Metric::aspect_ratio, Metric::edge_ratio}) {
      EXPECT_EQ(measure(metric, kind, cell, -cells::kUp), measure(metric, kind, cell, cells::kUp))
          << cells::describe(metric, kind);
    }
  }
}

TEST(Quad, IsInvertedWhenConcaveOrABowTie) {
  for (const Vec3& up : {cells::kUp, Vec3(Vec3::Zero())}) {
    for (const Corners& quad : {kConcaveQuad, kBowTie}) {
      EXPECT_TRUE(is_inverted(CellKind::quad, quad, up));
      EXPECT_EQ(measure(Metric::shape, CellKind::quad, quad, up), 0.0);
    }
    EXPECT_LT(measure(Metric::scaled_jacobian, CellKind::quad, kConcaveQuad, up), 0.0);
  }
  EXPECT_LT(measure(Metric::scaled_jacobian, CellKind::quad, kBowTie, cells::kUp), 0.0);
}

TEST(Polygon, IsNotInvertedWhenConcave) {
  EXPECT_FALSE(is_inverted(CellKind::polygon, kConcaveQuad, cells::kUp));
  EXPECT_TRUE(is_inverted(CellKind::polygon, kConcaveQuad, -cells::kUp));
  EXPECT_TRUE(is_inverted(CellKind::polygon, kBowTie, cells::kUp));  // no area at all
}

TEST(SurfaceCell, IsInvertedWhenItStandsSquareToUp) {
  for (const CellKind kind : {CellKind::triangle, CellKind::quad, CellKind::polygon}) {
    EXPECT_TRUE(is_inverted(kind, cells::ideal(kind), Vec3::UnitX())) << traits(kind).name;
    EXPECT_EQ(measure(Metric::shape, kind, cells::ideal(kind), Vec3::UnitX()), 0.0);
    EXPECT_EQ(measure(Metric::scaled_jacobian, kind, cells::ideal(kind), Vec3::UnitX()), 0.0);
  }
}

TEST(WarpedQuad, IsJudgedByItsOwnNormalOnTheSideOfUp) {
  const Corners quad{{0, 0, 0.2}, {1, 0, -0.2}, {1, 1, 0.3}, {0, 1, -0.1}};
  const double own = measure(Metric::shape, CellKind::quad, quad, Vec3::Zero());
  EXPECT_GT(own, 0.5);
  EXPECT_EQ(measure(Metric::shape, CellKind::quad, quad, cells::kUp), own);
  EXPECT_EQ(measure(Metric::shape, CellKind::quad, quad, Vec3(0.5, 0.5, 0.5)), own);
  EXPECT_EQ(measure(Metric::shape, CellKind::quad, quad, -cells::kUp), 0.0);
}

TEST(VolumeCell, IsInvertedWhenOneCornerIs) {
  for (const CellKind kind : {CellKind::hex, CellKind::wedge, CellKind::pyramid}) {
    Corners cell = cells::ideal(kind);
    const auto& n = traits(kind).corners[0].neighbours;
    const Vec3 opposite = (cell[n[0]] + cell[n[1]] + cell[n[2]]) / 3.0;
    cell[0] += 1.2 * (opposite - cell[0]);  // through the plane of its neighbours
    EXPECT_TRUE(is_inverted(kind, cell, Vec3::Zero())) << traits(kind).name;
    EXPECT_EQ(measure(Metric::shape, kind, cell, Vec3::Zero()), 0.0) << traits(kind).name;
    EXPECT_LT(measure(Metric::scaled_jacobian, kind, cell, Vec3::Zero()), 0.0);
  }
}

// Upwards the base of 4 by 1 turns into one of -1 by -4: every corner determinant is 4, the one in
// the middle -2.25.
Corners twisted(CellKind kind) {
  const Corners hex{{0, 0, 0}, {4, 0, 0},  {4, 1, 0},   {0, 1, 0},
                    {0, 0, 1}, {-1, 0, 1}, {-1, -4, 1}, {0, -4, 1}};
  return kind == CellKind::hex ? hex : cells::picked(hex, {0, 1, 3, 4, 5, 7});
}

TEST(HexAndWedge, AreInvertedWhenTheyAreSoOnlyBetweenTheirCorners) {
  for (const CellKind kind : {CellKind::hex, CellKind::wedge}) {
    for (const double size : {1e-100, 1e-30, 1.0, 1e30, 1e100}) {
      Corners cell = twisted(kind);
      for (Vec3& p : cell) p = size * (p + Vec3(3, 4, 5));
      EXPECT_TRUE(is_inverted(kind, cell, Vec3::Zero())) << traits(kind).name << " of " << size;
      EXPECT_GT(measure(Metric::shape, kind, cell, Vec3::Zero()), 0.0);
      EXPECT_TRUE(is_inverted(kind, cells::mirrored(cell), Vec3::Zero(), -1.0));

      Corners good = cells::ideal(kind);
      for (Vec3& p : good) p *= size;
      EXPECT_FALSE(is_inverted(kind, good, Vec3::Zero())) << traits(kind).name << " of " << size;
    }
  }
}

TEST(Shape, GoesToZeroContinuouslyAsTheCellGoesFlat) {
  for (const CellKind kind : cells::all_kinds()) {
    double before = 1.0;
    for (const double height : {1e-1, 1e-3, 1e-6, 1e-9}) {
      Corners cell = cells::ideal(kind);
      for (Vec3& p : cell) p[traits(kind).dimension - 1] *= height;
      const double now = measure(Metric::shape, kind, cell, cells::kUp);
      EXPECT_GT(now, 0.0);
      EXPECT_LT(now, before);
      before = now;
    }
    EXPECT_LT(before, 1e-5) << traits(kind).name;
  }
}

}  // namespace
}  // namespace evenmesh
