// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "evenmesh/quality/metric.h"
#include "tests/quality/cells.h"

namespace evenmesh {
namespace {

using cells::Corners;

void expect_same(CellKind kind, const Corners& a, const Vec3& up_a, const Corners& b,
                 const Vec3& up_b, const std::string& after) {
  for (const Metric metric : kMetrics) {
    if (!applies(metric, kind)) continue;
    const double before = measure(metric, kind, a, up_a);
    EXPECT_NEAR(measure(metric, kind, b, up_b), before, 1e-12 * std::max(1.0, std::abs(before)))
        << cells::describe(metric, kind) << " after " << after;
  }
  EXPECT_EQ(is_inverted(kind, a, up_a), is_inverted(kind, b, up_b)) << after;
}

/// Cells from good to turned over.
std::vector<Corners> specimens(CellKind kind) {
  std::mt19937 random(static_cast<unsigned>(kind) + 7);
  std::vector<Corners> result;
  for (const double amount : {0.0, 0.1, 0.3, 0.6}) {
    for (int i = 0; i < 10; ++i) result.push_back(cells::shaken(kind, amount, random));
  }
  return result;
}

Corners transformed(const Corners& corners, const auto& map) {
  Corners result;
  for (const Vec3& p : corners) result.push_back(map(p));
  return result;
}

TEST(Measures, DoNotChangeWhenTheCellIsTurnedAndMoved) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.0, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Vec3 by(3.0, -2.0, 5.0);
  for (const CellKind kind : cells::all_kinds()) {
    for (const Corners& cell : specimens(kind)) {
      const Corners turned = transformed(cell, [&](const Vec3& p) -> Vec3 { return turn * p; });
      expect_same(kind, cell, cells::kUp, turned, turn * cells::kUp, "rotation");
      const Corners moved = transformed(cell, [&](const Vec3& p) -> Vec3 { return p + by; });
      expect_same(kind, cell, cells::kUp, moved, cells::kUp, "translation");
    }
  }
}

TEST(Measures, DoNotDependOnTheSizeOfTheCell) {
  for (const double size : {3.0, 1e-9, 1e9, 1e-50, 1e50, 1e-160, 1e150, 1e-290, 1e300}) {
    for (const CellKind kind : cells::all_kinds()) {
      for (const Corners& cell : specimens(kind)) {
        const Corners scaled = transformed(cell, [&](const Vec3& p) -> Vec3 { return size * p; });
        expect_same(kind, cell, cells::kUp, scaled, cells::kUp,
                    "scaling by " + std::to_string(size));
      }
    }
  }
}

TEST(Measures, DoNotDependOnTheLengthOfUp) {
  for (const double length : {3.0, 1e-300, 1e300}) {
    for (const CellKind kind : {CellKind::triangle, CellKind::quad, CellKind::polygon}) {
      for (const Corners& cell : specimens(kind)) {
        expect_same(kind, cell, cells::kUp, cell, length * cells::kUp, "a change of up");
      }
    }
  }
}

TEST(Measures, DoNotDependOnWhichVertexIsTheFirst) {
  const std::map<CellKind, std::vector<std::vector<int>>> renumberings = {
      {CellKind::triangle, {{1, 2, 0}, {2, 0, 1}}},
      {CellKind::quad, {{1, 2, 3, 0}, {3, 0, 1, 2}}},
      {CellKind::polygon, {{1, 2, 3, 4, 5, 0}, {4, 5, 0, 1, 2, 3}}},
      {CellKind::tet, {{1, 2, 0, 3}, {0, 2, 3, 1}, {1, 0, 3, 2}}},
      {CellKind::hex, {{1, 2, 3, 0, 5, 6, 7, 4}, {0, 4, 5, 1, 3, 7, 6, 2}}},
      {CellKind::wedge, {{1, 2, 0, 4, 5, 3}, {3, 5, 4, 0, 2, 1}}},
      {CellKind::pyramid, {{1, 2, 3, 0, 4}, {2, 3, 0, 1, 4}}}};
  for (const auto& [kind, orders] : renumberings) {
    for (const Corners& cell : specimens(kind)) {
      if (kind == CellKind::quad && is_inverted(kind, cell, cells::kUp)) continue;  // see the docs
      for (const auto& order : orders) {
        expect_same(kind, cell, cells::kUp, cells::picked(cell, order), cells::kUp, "renumbering");
      }
    }
  }
}

TEST(AnglesAndRatios, OfVolumeCellsStayWhenTheCellIsTurnedOver) {
  for (const CellKind kind : {CellKind::tet, CellKind::hex, CellKind::wedge, CellKind::pyramid}) {
    for (const Corners& cell : specimens(kind)) {
      for (const Metric metric :
           {Metric::min_angle, Metric::max_angle, Metric::aspect_ratio, Metric::edge_ratio}) {
        EXPECT_EQ(measure(metric, kind, cells::mirrored(cell), Vec3::Zero()),
                  measure(metric, kind, cell, Vec3::Zero()))
            << cells::describe(metric, kind);
      }
    }
  }
}

TEST(Measures, OfSurfaceCellsIgnoreTheWindingWithoutUp) {
  for (const CellKind kind : {CellKind::triangle, CellKind::quad, CellKind::polygon}) {
    for (const Corners& cell : specimens(kind)) {
      expect_same(kind, cell, Vec3::Zero(), cells::mirrored(cell), Vec3::Zero(), "reflection");
    }
  }
}

}  // namespace
}  // namespace evenmesh
