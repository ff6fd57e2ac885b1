// SPDX-License-Identifier: MIT
#include "evenmesh/solver/reorder.h"

#include "evenmesh/mesh/ordering.h"

namespace evenmesh {

std::vector<Vec3> Reordered::to_original(Points points) const {
  std::vector<Vec3> result(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) result[order[k]] = points[k];
  return result;
}

std::vector<Vec3> Reordered::from_original(Points points) const {
  std::vector<Vec3> result(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) result[k] = points[order[k]];
  return result;
}

std::optional<Reordered> reorder_if_poor(const Mesh& mesh, const Problem& problem) {
  const Cells& cells = mesh.cells();
  if (has_good_order(cells)) return std::nullopt;

  Reordered result;
  Ordering ordering = breadth_first_order(mesh);
  result.order = std::move(ordering.vertices);
  std::vector<Index> number(result.order.size());
  for (std::size_t k = 0; k < number.size(); ++k) number[result.order[k]] = static_cast<Index>(k);

  result.problem.terms = problem.terms;
  result.problem.motion = problem.motion.renumbered(result.order);
  const Orientation& from = problem.orientation;
  Orientation& to = result.problem.orientation;
  to.type = from.type;
  to.normal = from.normal;
  if (!from.signs.empty()) to.signs.reserve(from.signs.size());
  if (!from.normals.empty()) to.normals.reserve(from.normals.size());

  Cells sorted;
  sorted.reserve(cells.size(), cells.corners().size());
  std::vector<Index> vertices;
  for_cells_in(ordering.cells, cells, [&](std::span<const Index> cell, std::uint32_t c) {
    vertices.clear();
    for (const Index v : cell) vertices.push_back(number[v]);
    sorted.add(cells.kind(c), vertices);
    if (!from.signs.empty()) to.signs.push_back(from.signs[c]);
    if (!from.normals.empty()) to.normals.push_back(from.normals[c]);
  });
  result.mesh = Mesh(result.from_original(mesh.points()), std::move(sorted));
  return result;
}

}  // namespace evenmesh
