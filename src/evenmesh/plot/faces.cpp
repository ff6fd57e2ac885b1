// SPDX-License-Identifier: MIT
#include "evenmesh/plot/faces.h"

#include <algorithm>

#include "evenmesh/mesh/sides.h"

namespace evenmesh {
namespace {

bool is_volume(CellKind kind) { return traits(kind).dimension == 3; }

Faces skin(const Mesh& mesh) {
  Faces faces;
  for_each_side(mesh.cells(), mesh.point_count(), 3, [&](const Side& side) {
    if (side.uses.size() != 1) return;
    const SideUse& use = side.uses.front();
    const FaceVertices face = face_vertices(mesh.cells(), use.cell, use.face);
    faces.polygons.add(face.count == 3 ? CellKind::triangle : CellKind::quad, face.span());
    faces.cells.push_back(use.cell);
  });
  return faces;
}

}  // namespace

Faces find_faces(const Mesh& mesh) {
  const Cells& cells = mesh.cells();
  if (std::any_of(cells.kinds().begin(), cells.kinds().end(), is_volume)) return skin(mesh);
  Faces faces{cells, std::vector<std::uint32_t>(cells.size())};
  for (std::size_t c = 0; c < cells.size(); ++c) faces.cells[c] = static_cast<std::uint32_t>(c);
  return faces;
}

}  // namespace evenmesh
