// SPDX-License-Identifier: MIT
#include "evenmesh/solver/part.h"

#include <algorithm>

namespace evenmesh {

std::vector<Vec3> Part::select(Points points) const {
  std::vector<Vec3> selected;
  selected.reserve(vertices.size());
  for (const Index v : vertices) selected.push_back(points[v]);
  return selected;
}

Part part_around(const Mesh& mesh, const Problem& problem, std::span<const char> moving) {
  Part part;
  const Cells& cells = mesh.cells();
  constexpr Index kNone = ~Index{0};
  std::vector<Index> number(mesh.point_count(), kNone);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto vertices = cells.vertices(c);
    if (std::none_of(vertices.begin(), vertices.end(), [&](Index v) { return moving[v]; })) {
      continue;
    }
    part.cells.push_back(static_cast<std::uint32_t>(c));
    for (const Index v : vertices) number[v] = 0;
  }
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    number[v] = static_cast<Index>(part.vertices.size());
    part.vertices.push_back(v);
  }

  const Orientation& from = problem.orientation;
  Orientation& to = part.problem.orientation;
  to.type = from.type;
  to.normal = from.normal;
  Cells own;
  std::vector<Index> corners;
  for (const std::uint32_t c : part.cells) {
    corners.clear();
    for (const Index v : cells.vertices(c)) corners.push_back(number[v]);
    own.add(cells.kind(c), corners);
    if (!from.signs.empty()) to.signs.push_back(from.signs[c]);
    if (!from.normals.empty()) to.normals.push_back(from.normals[c]);
  }
  part.mesh = Mesh(part.select(mesh.points()), std::move(own));

  part.problem.terms = problem.terms;
  part.problem.motion = problem.motion.selected(part.vertices);
  part.problem.validity = problem.validity;
  part.problem.max_deviation = problem.max_deviation;
  for (Index k = 0; k < part.vertices.size(); ++k) {
    if (!moving[part.vertices[k]]) part.problem.motion.fix(k);
    if (!problem.max_move.empty()) {
      part.problem.max_move.push_back(problem.max_move[part.vertices[k]]);
    }
  }
  return part;
}

}  // namespace evenmesh
