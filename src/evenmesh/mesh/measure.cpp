// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/measure.h"

#include <cmath>
#include <numbers>

#include "evenmesh/mesh/extent.h"

namespace evenmesh {

double oriented_size(const Mesh& mesh, const Orientation& orientation, std::size_t cell) {
  const CellKind kind = mesh.cells().kind(cell);
  const auto vertices = mesh.cells().vertices(cell);
  if (traits(kind).dimension == 3) {
    return orientation.sign(cell) * volume(kind, mesh.points(), vertices, 1.0);
  }
  const Vec3 area = 0.5 * doubled_area(mesh.points(), vertices, 1.0);
  return orientation.type == MeshType::planar ? area.dot(orientation.up(cell)) : area.norm();
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
