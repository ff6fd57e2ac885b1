// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "evenmesh/quality/metric.h"

/// Single cells for the tests of the measures.
namespace evenmesh::cells {

using Corners = std::vector<Vec3>;

inline const Vec3 kUp = Vec3::UnitZ();

/// The regular polygon on a circle of radius 1, counter-clockwise in the xy plane.
inline Corners regular_polygon(int corners) {
  Corners result;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / corners;
    result.emplace_back(std::cos(turn), std::sin(turn), 0.0);
  }
  return result;
}

/// The ideal cell; of the polygons the one with six corners.
inline Corners ideal(CellKind kind) {
  if (kind == CellKind::polygon) return regular_polygon(6);
  Corners result;
  for (const auto& p : traits(kind).ideal) result.emplace_back(p[0], p[1], p[2]);
  return result;
}

inline std::vector<CellKind> all_kinds() {
  return {CellKind::triangle, CellKind::quad,  CellKind::polygon, CellKind::tet,
          CellKind::hex,      CellKind::wedge, CellKind::pyramid};
}

/// Every coordinate moved by up to amount; surface cells stay in the xy plane.
inline Corners shaken(CellKind kind, double amount, std::mt19937& random) {
  std::uniform_real_distribution<double> shift(-amount, amount);
  Corners result = ideal(kind);
  for (Vec3& p : result) {
    p += Vec3(shift(random), shift(random), traits(kind).dimension == 2 ? 0.0 : shift(random));
  }
  return result;
}

inline Corners picked(const Corners& corners, const std::vector<int>& order) {
  Corners result;
  for (const int i : order) result.push_back(corners[static_cast<std::size_t>(i)]);
  return result;
}

/// The reflection in the plane x = 0: turns every cell over.
inline Corners mirrored(Corners corners) {
  for (Vec3& p : corners) p[0] = -p[0];
  return corners;
}

inline std::string describe(Metric metric, CellKind kind) {
  return std::string(name(metric)) + " of a " + std::string(traits(kind).name);
}

}  // namespace evenmesh::cells
