// SPDX-License-Identifier: MIT
#include "evenmesh/problem/defaults.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include "evenmesh/geometry/surface_track.h"

namespace evenmesh {
namespace {

// What is free on a surface goes wherever there is surface, over its edges too.
void free_on_surface(const Scene& scene, Arrangement& arrangement) {
  const auto& free = scene.constraints.free;
  std::vector<char> waiting(scene.points.size(), 0);
  for (Index v = 0; v < waiting.size(); ++v) {
    const bool is_free = std::any_of(free.begin(), free.end(),
                                     [v](const Selection& s) { return s.vertices[v] != 0; });
    waiting[v] = is_free && !arrangement.slides(v) && arrangement.moves(v);
  }
  const std::shared_ptr<const SurfaceTrack> surface = undivided_surface(scene.mesh);
  for (std::uint32_t t = 0; t < surface->triangles(); ++t) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Index v = surface->vertices(t)[j];
      if (v >= waiting.size() || !waiting[v]) continue;
      const TrackPoint at = surface->at(t, j);
      if (at.direction.isZero(0.0)) continue;
      arrangement.motion.put_on_track(v, surface, at);
      waiting[v] = 0;
    }
  }
  for (Index v = 0; v < waiting.size(); ++v) {
    if (waiting[v]) arrangement.motion.fix(v);
  }
}

}  // namespace

std::vector<Held> find_defaults(const Scene& scene) {
  const Constraints& constraints = scene.constraints;
  // In a mesh without extent nothing has a direction.
  if (!(scene.size > 0.0)) return std::vector<Held>(scene.points.size(), {Hold::corner});
  const bool surface = scene.type == MeshType::surface;
  if (constraints.fixed && !surface) return std::vector<Held>(scene.points.size());
  const MeshTracks& tracks = scene.tracks();
  const bool slides = surface || constraints.max_deviation.has_value();
  std::vector<Held> held = keep_shape(scene.mesh, scene.orientation, scene.topology, tracks,
                                      slides ? Curved::slides : Curved::stays);
  for (Index v = 0; v < held.size(); ++v) {
    const bool on_run = held[v].hold == Hold::curved && tracks.place[v] == VertexPlace::run;
    if (constraints.fixed && on_run) held[v].hold = Hold::run;
    if (!constraints.fixed && !constraints.held.vertices.empty() && constraints.held.vertices[v]) {
      held[v] = {Hold::file};
    } else if (!constraints.fixed && !constraints.layers.vertices.empty() &&
               constraints.layers.vertices[v]) {
      held[v] = {Hold::layer};
    }
    for (const Selection& free : constraints.free) {
      if (free.vertices[v]) held[v] = {};
    }
  }
  return held;
}

void apply_defaults(const Scene& scene, Arrangement& arrangement) {
  Motion& motion = arrangement.motion;
  for (Index v = 0; v < scene.points.size(); ++v) {
    if (arrangement.slides(v) || !arrangement.moves(v)) continue;
    const Held& held = arrangement.default_of[v];
    switch (held.hold) {
      case Hold::nothing:
        break;
      case Hold::corner:
      case Hold::curved:
      case Hold::file:
      case Hold::layer:
        motion.fix(v);
        break;
      case Hold::line:
        motion.keep_on_line(v, scene.points[v], held.direction);
        break;
      case Hold::plane:
        motion.keep_in_plane(v, scene.points[v], held.direction);
        break;
      case Hold::run:
      case Hold::surface: {
        const MeshTracks& tracks = scene.tracks();
        motion.put_on_track(v, tracks.tracks[tracks.track[v]], tracks.start[v]);
      }
    }
  }
  if (scene.type == MeshType::surface && !scene.constraints.free.empty()) {
    free_on_surface(scene, arrangement);
  }
}

std::vector<ConstraintSummary> summarize_defaults(const Scene& scene,
                                                  const Arrangement& arrangement) {
  std::vector<ConstraintSummary> lines;
  const auto add = [&](Hold hold, std::string_view kind, std::string_view note) {
    const bool stays =
        hold == Hold::corner || hold == Hold::curved || hold == Hold::file || hold == Hold::layer;
    std::size_t number = 0;
    for (Index v = 0; v < scene.points.size(); ++v) {
      const bool overruled =
          arrangement.slides(v) || scene.is_fixed(v) || arrangement.targets.has(v);
      if (arrangement.default_of[v].hold == hold && !overruled && arrangement.moves(v) != stays) {
        ++number;
      }
    }
    if (number == 0) return;
    lines.push_back(
        {std::string(kind), "default", Entry::eliminated, number, "vertices", std::string(note)});
  };
  const bool surface = scene.type == MeshType::surface;
  const bool volume = scene.type == MeshType::volume;
  add(Hold::corner, "fixed", "corners");
  add(Hold::file, "fixed", scene.constraints.held.text);
  add(Hold::layer, "fixed", scene.constraints.layers.text);
  add(Hold::curved, "fixed",
      surface  ? "interfaces that bend"
      : volume ? "skin and interfaces that bend"
               : "boundary and interfaces that bend");
  add(Hold::line, "slide on line",
      volume ? "straight edges" : "straight parts of boundary and interfaces");
  add(Hold::plane, "slide on plane", "flat parts of the skin");
  add(Hold::run, "slide on curve", "along the edges of the input");
  add(Hold::surface, "slide on surface",
      volume ? "the skin of the input" : "the surface of the input");
  return lines;
}

}  // namespace evenmesh
