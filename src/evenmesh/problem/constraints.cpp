// SPDX-License-Identifier: MIT
#include "evenmesh/problem/constraints.h"

#include <cassert>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/mesh/extent.h"
#include "evenmesh/problem/defaults.h"
#include "evenmesh/problem/demands.h"
#include "evenmesh/problem/joint.h"
#include "evenmesh/problem/prescriptions.h"
#include "evenmesh/problem/scene.h"
#include "evenmesh/problem/slides.h"

namespace evenmesh {
namespace {

using Summaries = std::vector<ConstraintSummary>;

void append(Summaries& lines, const Summaries& more) {
  lines.insert(lines.end(), more.begin(), more.end());
}

void check_selection([[maybe_unused]] const Scene& scene, const std::string& text,
                     const std::vector<char>& flags) {
  assert(flags.size() == scene.points.size());
  if (count(flags) == 0) fail(text, "it selects no vertex of this mesh");
}

// --fix none is fine: nothing is to stay.
void check_selections(const Scene& scene) {
  const Constraints& constraints = scene.constraints;
  for (const Selection& free : constraints.free) check_selection(scene, free.text, free.vertices);
  for (const Slide& s : constraints.slides) {
    check_selection(scene, s.selection.text, s.selection.vertices);
  }
  for (const Periodic& p : constraints.periodic) {
    check_selection(scene, p.text, p.first);
    check_selection(scene, p.text, p.second);
  }
  for (const MoveLimit& limit : constraints.move_limits) {
    check_selection(scene, limit.selection.text, limit.selection.vertices);
  }
  for (const Prescription& p : constraints.prescriptions) {
    if (p.targets.empty()) fail(p.text, "it moves no vertex of this mesh");
  }
  for (const Selection& free : constraints.free) {
    for (Index v = 0; v < free.vertices.size(); ++v) {
      if (!free.vertices[v] || !scene.is_fixed(v)) continue;
      contradict(constraints.fixed->text, free.text,
                 fmt::format("{} is in both selections", scene.name_of(v)));
    }
  }
}

Summaries summarize_selections(const Scene& scene) {
  Summaries lines;
  const auto add = [&](const char* kind, const Selection& selection) {
    lines.push_back(
        {kind, selection.text, Entry::eliminated, count(selection.vertices), "vertices"});
  };
  if (scene.constraints.fixed) add("fixed", *scene.constraints.fixed);
  for (const Selection& free : scene.constraints.free) add("free", free);
  return lines;
}

// Arranges how vertices move, and where they are to be brought.
// @return  what was asked for and holds
Summaries arrange(const Scene& scene, Arrangement& arrangement) {
  Summaries lines = summarize_selections(scene);
  const std::size_t n = scene.points.size();
  arrangement.motion = Motion(scene.mesh, scene.orientation, std::vector<char>(n, 0));
  arrangement.default_of = find_defaults(scene);
  arrangement.slide_of.assign(n, Arrangement::kNone);
  Slides slides(scene, arrangement);
  apply_defaults(scene, arrangement);
  append(lines, slides.put_all());
  for (Index v = 0; v < n; ++v) {
    if (scene.is_fixed(v)) arrangement.motion.fix(v);
  }
  for (const Symmetry& symmetry : scene.constraints.symmetries) {
    lines.push_back(mirror(scene, symmetry, arrangement));
  }
  for (const Periodic& periodic : scene.constraints.periodic) {
    lines.push_back(repeat(scene, periodic, arrangement));
  }
  prescribe(scene, arrangement);
  append(lines, summarize_prescriptions(scene));
  return lines;
}

}  // namespace

std::string_view name(Entry entry) {
  constexpr std::string_view kNames[] = {"eliminated", "inequality", "bordered"};
  return kNames[static_cast<int>(entry)];
}

std::vector<char> vertices_in_plane(const Mesh& mesh, const Plane& plane) {
  const double slack = kInPlane * extent_of(mesh.points(), mesh.cells().corners()).diagonal();
  std::vector<char> result(mesh.point_count(), 0);
  for (const Index v : mesh.cells().corners()) {
    result[v] = std::abs(plane.normal.dot(mesh.points()[v] - plane.point)) <= slack;
  }
  return result;
}

std::vector<ConstraintSummary> apply(const Mesh& mesh, const Topology& topology,
                                     const Constraints& constraints, Problem& problem) {
  const Scene scene(mesh, topology, constraints, problem.orientation);
  check_selections(scene);
  check_lengths(scene);
  Arrangement arrangement{problem.motion, TargetList(mesh.points())};
  const Summaries asked_for = arrange(scene, arrangement);
  problem.targets = arrangement.targets.moves();
  demand(scene, arrangement, problem);
  Summaries lines = summarize_defaults(scene, arrangement);
  append(lines, asked_for);
  append(lines, summarize_demands(scene, arrangement, problem));
  return lines;
}

}  // namespace evenmesh
