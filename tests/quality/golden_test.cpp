// SPDX-License-Identifier: MIT
// Compares every measure with VTK's vtkMeshQuality, see tools/make_quality_golden.py.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "evenmesh/quality/metric.h"
#include "tests/support/places.h"

namespace evenmesh {
namespace {

struct GoldenCell {
  CellKind kind;
  std::string what;
  std::vector<Vec3> points;
  nlohmann::json values;
};

CellKind kind_named(const std::string& word) {
  for (int k = 0; k < kCellKinds; ++k) {
    if (traits(static_cast<CellKind>(k)).name == word) return static_cast<CellKind>(k);
  }
  throw std::runtime_error("golden.json has a cell of unknown kind " + word);
}

std::vector<GoldenCell> golden_cells() {
  std::ifstream file(testing::source_dir() / "tests/quality/golden.json");
  std::vector<GoldenCell> result;
  const auto golden = nlohmann::json::parse(file);
  for (const auto& cell : golden["cells"]) {
    GoldenCell read{kind_named(cell["kind"]), cell["what"], {}, cell["values"]};
    for (const auto& p : cell["points"]) read.points.emplace_back(p[0], p[1], p[2]);
    result.push_back(std::move(read));
  }
  return result;
}

void expect_vtk_value(Metric metric, CellKind kind, const GoldenCell& cell, const Vec3& up) {
  const auto expected = cell.values.find(name(metric));
  if (expected == cell.values.end()) return;  // VTK has no such measure for the kind
  if (expected->is_null()) return;            // an angle VTK has too few digits of
  const double value = *expected;
  EXPECT_NEAR(measure(metric, kind, cell.points, up), value, 1e-9 * std::max(1.0, value))
      << name(metric) << " of a " << traits(kind).name << ", " << cell.what;
}

TEST(GoldenValues, AreManyOfEveryKind) {
  std::map<CellKind, int> count;
  for (const GoldenCell& cell : golden_cells()) ++count[cell.kind];
  for (const CellKind kind : {CellKind::triangle, CellKind::quad, CellKind::tet, CellKind::hex}) {
    EXPECT_GE(count[kind], 50) << traits(kind).name;
  }
}

TEST(GoldenValues, AreMatchedByEveryMeasure) {
  for (const GoldenCell& cell : golden_cells()) {
    for (const Metric metric : kMetrics) {
      if (!applies(metric, cell.kind)) continue;
      expect_vtk_value(metric, cell.kind, cell, Vec3::Zero());
    }
  }
}

TEST(GoldenValues, AreMatchedWhenTheCellsOwnNormalIsUp) {
  for (const GoldenCell& cell : golden_cells()) {
    if (cell.kind != CellKind::quad) continue;
    const auto& p = cell.points;
    const Vec3 normal = (p[2] - p[0]).cross(p[3] - p[1]);
    for (const Metric metric : kMetrics) expect_vtk_value(metric, cell.kind, cell, normal);
  }
}

TEST(GoldenValues, AreMatchedByPolygonsOfThreeAndFourCorners) {
  for (const GoldenCell& cell : golden_cells()) {
    if (traits(cell.kind).dimension != 2) continue;
    for (const Metric metric : kMetrics) {
      expect_vtk_value(metric, CellKind::polygon, cell, Vec3::Zero());
    }
  }
}

}  // namespace
}  // namespace evenmesh
