// SPDX-License-Identifier: MIT
#include "evenmesh/problem/scene.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/extent.h"

namespace evenmesh {

Scene::Scene(const Mesh& m, const Topology& t, const Constraints& c, const Orientation& o)
    : mesh(m),
      points(m.points()),
      topology(t),
      constraints(c),
      orientation(o),
      type(o.type),
      size(extent_of(points, m.cells().corners()).diagonal()) {}

const MeshTracks& Scene::tracks() const {
  if (!tracks_) tracks_ = find_mesh_tracks(mesh, orientation, topology);
  return *tracks_;
}

bool Scene::is_apart(double distance) const {
  constexpr double kSame = 1e-6;  // of the size
  return distance > kSame * size;
}

double Scene::distance(const Plane& plane, Index v) const {
  return std::abs(plane.normal.dot(points[v] - plane.point));
}

std::string Scene::name_of(Index v) const {
  return constraints.vertex_name ? constraints.vertex_name(v) : fmt::format("vertex {}", v);
}

void fail(std::string_view text, std::string_view what) {
  throw InvalidOption(fmt::format("{}: {}", text, what));
}

void contradict(std::string_view a, std::string_view b, std::string_view what) {
  throw InvalidOption(fmt::format("{} and {} contradict each other: {}", a, b, what));
}

std::size_t count(std::span<const char> flags) {
  return static_cast<std::size_t>(
      std::count_if(flags.begin(), flags.end(), [](char f) { return f != 0; }));
}

std::string vertices(std::size_t number) {
  return number == 1 ? "1 vertex" : fmt::format("{} vertices", number);
}

}  // namespace evenmesh
