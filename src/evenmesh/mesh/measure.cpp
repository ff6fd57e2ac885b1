// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/measure.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "evenmesh/mesh/cell_edges.h"
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

std::vector<double> local_edge_lengths(const Mesh& mesh) {
  std::vector<double> lengths(mesh.point_count(), 0.0);
  std::vector<std::uint32_t> count(mesh.point_count(), 0);
  for_each_cell_edge(mesh.cells(), [&](Index a, Index b) {
    const double length = (mesh.points()[a] - mesh.points()[b]).norm();
    for (const Index end : {a, b}) {
      lengths[end] += length;
      ++count[end];
    }
  });
  for (std::size_t v = 0; v < lengths.size(); ++v) {
    if (count[v] > 0) lengths[v] /= count[v];
  }
  return lengths;
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
