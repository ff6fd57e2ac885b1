// SPDX-License-Identifier: MIT
#include "evenmesh/solver/holding.h"

#include <algorithm>
#include <vector>

namespace evenmesh {

Holding holding_at(Workers& workers, const Mesh& mesh, const Motion& motion, Objective& objective,
                   Points points) {
  const Lagrangian& lagrangian = *objective.lagrangian();
  Holding holding;
  std::vector<Vec3> x(points.begin(), points.end());
  holding.cells = lagrangian.active_cells(workers, x);
  holding.moves = lagrangian.active_moves(x);
  holding.bounds = lagrangian.active_bounds(x);

  std::vector<Vec3> gradient(x.size());
  objective.evaluate(workers, x, gradient);
  Motion::Places places;
  if (!motion.slots().empty()) motion.retract(workers, mesh.points(), motion.start(), x, places);
  holding.of_vertex.assign(x.size(), 0.0f);
  for_ranges(workers, x.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      const auto vertex = static_cast<Index>(v);
      const bool tied = motion.is_tied(vertex);
      const Vec3 rest =
          tied ? gradient[v] : Vec3(gradient[v] - motion.project(places, vertex, gradient[v]));
      holding.of_vertex[v] = static_cast<float>(rest.norm());
    }
  });
  return holding;
}

std::size_t count_unmet(const Holding& holding) {
  const auto unmet = [](const auto& demands) {
    return static_cast<std::size_t>(std::count_if(
        demands.begin(), demands.end(), [](const auto& demand) { return demand.excess > 0.0; }));
  };
  return unmet(holding.cells) + unmet(holding.moves) + unmet(holding.bounds);
}

}  // namespace evenmesh
