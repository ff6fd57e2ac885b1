// SPDX-License-Identifier: MIT
#include "evenmesh/solver/reorder.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "evenmesh/mesh/ordering.h"

namespace evenmesh {
namespace {

// A function of vertices that have other numbers now.
class RenumberedFunction : public Function {
 public:
  RenumberedFunction(std::shared_ptr<const Function> function, std::span<const Index> number)
      : function_(std::move(function)) {
    for (const Index v : function_->vertices()) vertices_.push_back(number[v]);
  }
  std::string_view name() const override { return function_->name(); }
  std::span<const Index> vertices() const override { return vertices_; }
  double evaluate(Points own, std::span<Vec3> gradient) const override {
    return function_->evaluate(own, gradient);
  }

 private:
  std::shared_ptr<const Function> function_;
  std::vector<Index> vertices_;
};

}  // namespace

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

void Reordered::to_original(Holding& holding) const {
  std::vector<float> of_vertex(holding.of_vertex.size());
  for (std::size_t k = 0; k < of_vertex.size(); ++k) of_vertex[order[k]] = holding.of_vertex[k];
  holding.of_vertex = std::move(of_vertex);
  for (ActiveCell& active : holding.cells) active.cell = cell_order[active.cell];
  for (ActiveBound& active : holding.moves) active.number = order[active.number];
  std::sort(holding.cells.begin(), holding.cells.end(),
            [](const ActiveCell& a, const ActiveCell& b) { return a.cell < b.cell; });
  std::sort(holding.moves.begin(), holding.moves.end(),
            [](const ActiveBound& a, const ActiveBound& b) { return a.number < b.number; });
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
  result.problem.validity = problem.validity;
  for (const Bound& bound : problem.bounds) {
    result.problem.bounds.push_back(bound);
    result.problem.bounds.back().function =
        std::make_shared<RenumberedFunction>(bound.function, number);
  }
  result.problem.max_deviation = problem.max_deviation;
  for (const Target& target : problem.targets) {
    result.problem.targets.push_back({number[target.vertex], target.position});
  }
  std::sort(result.problem.targets.begin(), result.problem.targets.end(),
            [](const Target& a, const Target& b) { return a.vertex < b.vertex; });
  if (!problem.max_move.empty()) {
    result.problem.max_move.reserve(result.order.size());
    for (const Index v : result.order) result.problem.max_move.push_back(problem.max_move[v]);
  }
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
    sorted.add(cells.kind(c), vertices, cells.group(c));
    if (!from.signs.empty()) to.signs.push_back(from.signs[c]);
    if (!from.normals.empty()) to.normals.push_back(from.normals[c]);
  });
  result.mesh = Mesh(result.from_original(mesh.points()), std::move(sorted));
  result.cell_order = std::move(ordering.cells);
  return result;
}

}  // namespace evenmesh
