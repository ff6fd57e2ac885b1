// SPDX-License-Identifier: MIT
#include "evenmesh/solver/deviation_limit.h"

#include <algorithm>

#include "evenmesh/mesh/sides.h"

namespace evenmesh {
namespace {

// Faces that belong to one cell only.
Cells skin_of(const Mesh& mesh) {
  Cells skin;
  for_each_side(mesh.cells(), mesh.point_count(), 3, [&](const Side& side) {
    if (side.cells != 1) return;
    const SideUse& use = side.uses[0];
    const FaceVertices face = face_vertices(mesh.cells(), use.cell, use.face);
    if (face.count == 0) return;
    skin.add(face.count == 3 ? CellKind::triangle : CellKind::quad, face.span());
  });
  return skin;
}

// Edges of one cell only, and those between groups.
std::vector<VertexTriple> outline_of(const Mesh& mesh) {
  const Cells& cells = mesh.cells();
  std::vector<VertexTriple> edges;
  for_each_side(cells, mesh.point_count(), 2, [&](const Side& side) {
    const std::uint32_t group = cells.group(side.uses[0].cell);
    const bool is_border = std::any_of(side.uses.begin(), side.uses.end(), [&](const SideUse& use) {
      return cells.group(use.cell) != group;
    });
    if (side.cells != 1 && !is_border) return;
    edges.push_back({side.first, side.uses[0].second, side.uses[0].second});
  });
  return edges;
}

}  // namespace

DeviationLimit::DeviationLimit(const Mesh& input, MeshType type, double limit) : limit_(limit) {
  if (type == MeshType::planar) {
    edges_ = outline_of(input);
  } else {
    faces_ =
        Triangulation(input.points(), type == MeshType::surface ? input.cells() : skin_of(input));
  }
  input_ = faces_.positions(input.points());
  if (!parts().empty()) input_bvh_.emplace(input_, parts());
}

std::span<const VertexTriple> DeviationLimit::parts() const {
  return edges_.empty() ? faces_.triangles() : std::span<const VertexTriple>(edges_);
}

Deviation DeviationLimit::deviation(Workers& workers, Points points) const {
  if (!input_bvh_) return {};
  const std::vector<Vec3> now = faces_.positions(points);
  return {deviation_from(now, parts(), *input_bvh_, workers),
          deviation_from(input_, parts(), Bvh(now, parts()), workers)};
}

double DeviationLimit::measure(Workers& workers, Points points) const {
  return deviation(workers, points).greatest();
}

double DeviationLimit::mark(Workers& workers, Points points, std::vector<char>& marked) const {
  const Deviation found = deviation(workers, points);
  if (found.greatest() <= limit_) return found.greatest();
  for (std::size_t p = 0; p < parts().size(); ++p) {
    const double far = std::max(found.a_from_b.of_triangle[p], found.b_from_a.of_triangle[p]);
    if (far <= limit_) continue;
    for (const Index v : parts()[p]) {
      if (v < points.size()) {
        marked[v] = 1;
      } else {
        for (const Index corner : faces_.around(v)) marked[corner] = 1;
      }
    }
  }
  return found.greatest();
}

}  // namespace evenmesh
