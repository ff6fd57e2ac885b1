// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/measure.h"

#include <cmath>
#include <numbers>

namespace evenmesh {

double cell_volume(CellKind kind, std::span<const Vec3> corners) {
  // The divergence theorem: a sixth of the determinants over the triangles of all faces, measured
  // from a corner so that cells far from the origin lose no digits.
  double sum = 0.0;
  for (const CellTraits::Face& face : traits(kind).faces) {
    Vec3 middle = Vec3::Zero();
    for (int i = 0; i < face.count; ++i) middle += corners[face.vertices[i]] - corners[0];
    middle /= face.count;
    for (int i = 0; i < face.count; ++i) {
      const Vec3 a = corners[face.vertices[i]] - corners[0];
      const Vec3 b = corners[face.vertices[(i + 1) % face.count]] - corners[0];
      sum += middle.dot(a.cross(b));
    }
  }
  return sum / 6.0;
}

double ideal_measure(CellKind kind, int vertices) {
  switch (kind) {
    case CellKind::triangle:
      return std::numbers::sqrt3 / 4.0;
    case CellKind::quad:
      return 1.0;
    case CellKind::polygon:
      return vertices / (4.0 * std::tan(std::numbers::pi / vertices));
    case CellKind::tet:
      return 1.0 / (6.0 * std::numbers::sqrt2);
    case CellKind::hex:
      return 1.0;
    case CellKind::wedge:
      return std::numbers::sqrt3 / 4.0;
    case CellKind::pyramid:
      return 1.0 / (3.0 * std::numbers::sqrt2);
  }
  return 0.0;
}

}  // namespace evenmesh
