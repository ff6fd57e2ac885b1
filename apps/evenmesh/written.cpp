// SPDX-License-Identifier: MIT
#include "apps/evenmesh/written.h"

#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "evenmesh/mesh/curved_cells.h"
#include "evenmesh/solver/guard.h"

namespace evenmesh::app {

std::vector<char> staying_vertices(const Problem& problem) {
  std::vector<char> stays(problem.motion.size());
  for (Index v = 0; v < stays.size(); ++v) {
    stays[v] = problem.motion.freedom(v) == Motion::Freedom::fixed;
  }
  for (const Target& target : problem.targets) stays[target.vertex] = 0;
  return stays;
}

std::vector<char> staying_vertices(const Problem& problem, const Input& input) {
  std::vector<char> stays = staying_vertices(problem);
  const Followers& followers = input.file.followers;
  for (std::size_t i = 0; i < followers.size(); ++i) stays[followers.vertex(i)] = 0;
  return stays;
}

void check_written(const Input& input, const Problem& problem, const Mesh& written,
                   bool allow_worse, int threads) {
  const Mesh& before = input.file.mesh;
  const std::vector<char> stays = staying_vertices(problem, input);
  for (std::size_t v = 0; v < before.point_count(); ++v) {
    // Bit for bit: a zero that loses its sign has changed too.
    if (!stays[v] || std::memcmp(&before.points()[v], &written.points()[v], sizeof(Vec3)) == 0) {
      continue;
    }
    throw Refused(fmt::format("{} is fixed but would have moved",
                              input.file.patch->vertex_name(static_cast<Index>(v))));
  }
  Workers workers(threads);
  Guard guard(workers, before, problem.orientation);
  // Prescribed moves change the shape, and with it what quality can be had.
  const bool same_shape = problem.targets.empty();
  std::optional<DeviationLimit> limit;
  if (same_shape && std::isfinite(problem.max_deviation)) {
    limit.emplace(before, problem.orientation.type, problem.max_deviation);
    guard.set_limit(&*limit);
  }
  const bool judge_quality = same_shape && !allow_worse;
  const std::string breach = guard.find_breach(
      workers, written.points(), judge_quality ? Judge::quality_and_inversion : Judge::inversion);
  if (!breach.empty()) throw Refused("in the file as read back, " + breach);
  const std::vector<std::size_t> spoilt =
      CurvedCells(before, input.file.followers, problem.orientation).spoilt(written.points());
  if (!spoilt.empty()) {
    throw Refused(fmt::format("in the file as read back, {} would be inverted beside its corners",
                              input.file.patch->cell_name(spoilt[0])));
  }
}

}  // namespace evenmesh::app
