// SPDX-License-Identifier: MIT
#include "evenmesh/problem/joint.h"

#include <utility>
#include <vector>

#include <fmt/core.h>

#include "evenmesh/mesh/extent.h"
#include "evenmesh/problem/periodic_pairs.h"

namespace evenmesh {
namespace {

constexpr double kImage = 1e-6;  // of the size: how far from its image a vertex may lie

Index nearest_to(const Plane& plane, const Scene& scene) {
  Index best = 0;
  for (const Index v : scene.mesh.cells().corners()) {
    const bool is_nearer = scene.distance(plane, v) < scene.distance(plane, best);
    if (is_nearer || !scene.topology.used[best]) best = v;
  }
  return best;
}

// Those that belong to cells.
std::vector<Index> listed(const std::vector<char>& side, const Scene& scene) {
  std::vector<Index> list;
  for (Index v = 0; v < side.size(); ++v) {
    if (side[v] && scene.topology.used[v]) list.push_back(v);
  }
  return list;
}

// By where they lie opposite.
std::vector<PeriodicPair> find_pairs(const Scene& scene, const Periodic& periodic) {
  const std::vector<Index> first = listed(periodic.first, scene);
  const std::vector<Index> second = listed(periodic.second, scene);
  if (first.empty() || second.empty()) {
    fail(periodic.text,
         fmt::format("no vertex of a cell is on its {} side", first.empty() ? "first" : "second"));
  }
  const Vec3 between =
      extent_of(scene.points, second).middle() - extent_of(scene.points, first).middle();
  PeriodicMatch match = match_periodic(scene.points, first, second,
                                       periodic.translation.value_or(between), kImage * scene.size);
  if (match.unmatched > 0) {
    fail(periodic.text,
         fmt::format("{} of {} and {} on its two sides have no image on the other; the first is "
                     "{}, the nearest to its image is {:.3g} away",
                     match.unmatched, first.size(), second.size(), scene.name_of(match.example),
                     match.nearest));
  }
  if (match.pairs.empty()) fail(periodic.text, "every vertex on its two sides is its own image");
  return std::move(match.pairs);
}

// What slides on a curved track has no image to repeat its moves.
bool tie(const PeriodicPair& pair, Points points, Motion& motion) {
  const auto [a, b] = pair;
  if (motion.track(a) != nullptr || motion.track(b) != nullptr) {
    motion.fix(a);
    motion.fix(b);
    return false;
  }
  motion.tie(b, a, points);
  return true;
}

}  // namespace

ConstraintSummary mirror(const Scene& scene, const Symmetry& symmetry, Arrangement& arrangement) {
  const std::vector<char> in_plane = vertices_in_plane(scene.mesh, symmetry.plane);
  const std::size_t number = count(in_plane);
  if (number == 0) {
    const Index nearest = nearest_to(symmetry.plane, scene);
    fail(symmetry.text,
         fmt::format("no vertex lies in this plane; the nearest, {}, is {:.3g} away",
                     scene.name_of(nearest), scene.distance(symmetry.plane, nearest)));
  }
  std::size_t stuck = 0;
  for (Index v = 0; v < in_plane.size(); ++v) {
    if (!in_plane[v] || !arrangement.moves(v)) continue;
    arrangement.motion.keep_in_plane(v, scene.points[v], symmetry.plane.normal);
    if (!arrangement.moves(v)) ++stuck;
  }
  std::string note;
  if (stuck > 0) note = vertices(stuck) + " in it stay: what they slide on leaves the plane";
  return {"symmetry", symmetry.text, Entry::eliminated, number, "vertices", note};
}

ConstraintSummary repeat(const Scene& scene, const Periodic& periodic, Arrangement& arrangement) {
  const std::vector<PeriodicPair> pairs = find_pairs(scene, periodic);
  std::size_t stuck = 0;
  for (const PeriodicPair& pair : pairs) {
    const auto [a, b] = pair;
    if (!tie(pair, scene.points, arrangement.motion)) ++stuck;
    arrangement.images.push_back({a, b, &periodic});
    arrangement.images.push_back({b, a, &periodic});
  }
  std::string note;
  if (stuck > 0) note = fmt::format("{} of the pairs stay: they slide on something curved", stuck);
  return {"periodic", periodic.text, Entry::eliminated, 2 * pairs.size(), "vertices", note};
}

}  // namespace evenmesh
