// SPDX-License-Identifier: MIT
#include "evenmesh/solver/input_check.h"

#include <limits>

#include <fmt/core.h>

#include "evenmesh/base/error.h"

namespace evenmesh {
namespace {

// Squares of lengths must neither vanish nor overflow.
void check_size(const Mesh& mesh) {
  constexpr double kSmallest = 1e-100;
  constexpr double kGreatest = 1e100;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const Index v : mesh.cells().corners()) {
    low = low.cwiseMin(mesh.points()[v]);
    high = high.cwiseMax(mesh.points()[v]);
  }
  if (mesh.cells().empty()) return;
  const double size = (high - low).maxCoeff();
  if (size == 0.0 || (size >= kSmallest && size <= kGreatest)) return;
  throw InvalidOption(fmt::format(
      "the mesh measures {:.3g} units across, whose square is beyond double precision; choose a "
      "unit in which it measures between {:.0e} and {:.0e}",
      size, kSmallest, kGreatest));
}

void check_demands(const Mesh& mesh, const Problem& problem) {
  for (const Bound& bound : problem.bounds) {
    for (const Index v : bound.function->vertices()) {
      if (v < mesh.point_count()) continue;
      throw InvalidOption(fmt::format("{} depends on vertex {}, but the mesh has {} vertices",
                                      bound.function->name(), v, mesh.point_count()));
    }
    if (bound.lower <= bound.upper) continue;
    throw InvalidOption(fmt::format("{} cannot lie between {} and {}", bound.function->name(),
                                    bound.lower, bound.upper));
  }
  for (std::size_t v = 0; v < problem.max_move.size(); ++v) {
    if (problem.max_move[v] > 0.0) continue;
    throw InvalidOption(
        fmt::format("the move of vertex {} must be limited to more than 0, not {}; fix it instead",
                    v, problem.max_move[v]));
  }
}

}  // namespace

void check_input(const Mesh& mesh, const Problem& problem) {
  check_size(mesh);
  check_demands(mesh, problem);
}

}  // namespace evenmesh
