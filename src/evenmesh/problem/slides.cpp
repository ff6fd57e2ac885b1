// SPDX-License-Identifier: MIT
#include "evenmesh/problem/slides.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/problem/figures.h"

namespace evenmesh {
namespace {

// Relative to the size of the scene:
constexpr double kFits = 1e-6;  // how far from a fitted figure a vertex may lie
constexpr double kOnIt = 1e-9;  // so near a given figure a vertex is on it

constexpr double kSameDirection = 1e-6;  // sine of the angle

// What a planar mesh has room for.
bool lies_in_a_plane(SlideOn on) {
  return on == SlideOn::plane || on == SlideOn::boundary || on == SlideOn::features || is_curve(on);
}

TrackPoint place_on(const Track& track, const Vec3& p) {
  return track.nearest(p, {p, Vec3::Zero(), 0});
}

}  // namespace

Slides::Slides(const Scene& scene, Arrangement& arrangement)
    : scene_(scene), arrangement_(arrangement) {
  const std::size_t n = scene.points.size();
  for (std::uint32_t s = 0; s < scene.constraints.slides.size(); ++s) {
    std::vector<char> part(n, 0);
    for (Index v = 0; v < n; ++v) {
      part[v] = slide(s).selection.vertices[v] && !scene.is_fixed(v) && arrangement.moves(v) &&
                !is_held(v, slide(s));
      if (part[v] && !arrangement.slides(v)) arrangement.slide_of[v] = s;
    }
    taking_part_.push_back(std::move(part));
  }
}

bool Slides::is_held(Index v, const Slide& s) const {
  const Hold hold = arrangement_.default_of[v].hold;
  if (hold == Hold::nothing) return false;
  if (hold == Hold::corner) return true;
  const bool on_faces = is_figure(s.on) ? !is_curve(s.on) : s.track != nullptr;
  if (!on_faces || scene_.type == MeshType::planar) return false;
  return scene_.tracks().place[v] == VertexPlace::run;
}

std::vector<ConstraintSummary> Slides::put_all() {
  std::vector<ConstraintSummary> lines;
  for (std::uint32_t s = 0; s < taking_part_.size(); ++s) lines.push_back(put(s));
  return lines;
}

ConstraintSummary Slides::put(std::uint32_t s) {
  const SlideOn on = slide(s).on;
  if (scene_.type == MeshType::planar && !lies_in_a_plane(on)) {
    fail(slide(s).selection.text,
         fmt::format("the vertices of a planar mesh slide on lines, planes, circles and their "
                     "boundary, not on a {}",
                     name(on)));
  }
  const double farthest = slide(s).track != nullptr ? put_on_given(s)
                          : is_figure(on)           ? put_on_fitted(s)
                                                    : put_on_own(s);
  return summarize(s, farthest);
}

// ---- the three kinds of slides, each with how far a vertex was off ------------------------------

double Slides::put_on_given(std::uint32_t s) {
  double farthest = 0.0;
  for (Index v = 0; v < scene_.points.size(); ++v) {
    if (!taking_part_[s][v]) continue;
    const Vec3& p = scene_.points[v];
    const TrackPoint at = slide(s).nearest ? slide(s).nearest(p) : place_on(*slide(s).track, p);
    farthest = std::max(farthest, put_on(v, s, slide(s).track, at));
  }
  return farthest;
}

double Slides::put_on_fitted(std::uint32_t s) {
  const SlideOn on = slide(s).on;
  const Selection& selection = slide(s).selection;
  double farthest = 0.0;
  for (const FittedPiece& piece : fit_figures(scene_.mesh, scene_.orientation, scene_.topology, on,
                                              selection.vertices, taking_part_[s])) {
    if (piece.figure == nullptr) {
      fail(selection.text, fmt::format("the {} around {} do not say which {}; give its numbers",
                                       vertices(piece.vertices.size()),
                                       scene_.name_of(piece.vertices.front()), name(on)));
    }
    if (!(piece.greatest_distance <= kFits * scene_.size)) {
      fail(selection.text,
           fmt::format("{} is {:.3g} off the {} fitted to the {} it hangs together with (at most "
                       "{:.3g} is allowed)",
                       scene_.name_of(piece.farthest), piece.greatest_distance, name(on),
                       vertices(piece.vertices.size()), kFits * scene_.size));
    }
    for (const Index v : piece.vertices) {
      if (!taking_part_[s][v]) continue;
      const TrackPoint at = place_on(*piece.figure, scene_.points[v]);
      farthest = std::max(farthest, put_on(v, s, piece.figure, at));
    }
  }
  return farthest;
}

// Features, boundary and surface of the input itself.
double Slides::put_on_own(std::uint32_t s) {
  const SlideOn on = slide(s).on;
  const MeshTracks& tracks = scene_.tracks();
  const Topology& topology = scene_.topology;
  double farthest = 0.0;
  for (Index v = 0; v < scene_.points.size(); ++v) {
    if (!taking_part_[s][v]) continue;
    const bool is_on = on == SlideOn::features   ? topology.features[v] || topology.non_manifold[v]
                       : on == SlideOn::boundary ? topology.boundary[v]
                                                 : tracks.place[v] != VertexPlace::inside;
    if (!is_on) {
      fail(slide(s).selection.text,
           fmt::format("{} is not on the {}", scene_.name_of(v), name(on)));
    }
    if (tracks.track[v] == MeshTracks::kNone) {
      taking_part_[s][v] = 0;
      arrangement_.motion.fix(v);
      continue;
    }
    farthest = std::max(farthest, put_on(v, s, tracks.tracks[tracks.track[v]], tracks.start[v]));
  }
  return farthest;
}

// ---- one vertex ---------------------------------------------------------------------------------

// Puts a vertex on a figure, together with those it is on already.
double Slides::put_on(Index v, std::uint32_t s, const std::shared_ptr<const Track>& track,
                      const TrackPoint& at) {
  check_in_mesh_plane(v, slide(s), *track, at);
  const double distance = set_target(v, s, at.position);
  Motion& motion = arrangement_.motion;
  const SlideOn on = slide(s).on;
  if (arrangement_.slide_of[v] == s) {
    if (on == SlideOn::line) {
      motion.keep_on_line(v, at.position, at.direction);
    } else if (on == SlideOn::plane && scene_.type != MeshType::surface) {
      motion.keep_in_plane(v, at.position, at.direction);
    } else {
      motion.put_on_track(v, track, at);
    }
  } else if (on == SlideOn::plane) {
    motion.keep_in_plane(v, at.position, at.direction);
  } else if (motion.track(v) != track.get()) {
    put_on_second(v, on, at);
  }
  return distance;
}

// On two curves, or a curve and a curved surface: there is only the line they may have in common.
void Slides::put_on_second(Index v, SlideOn on, const TrackPoint& at) {
  Motion& motion = arrangement_.motion;
  const bool straight = motion.track(v) == nullptr && on == SlideOn::line;
  if (straight && motion.project(v, at.direction).norm() > 1.0 - kSameDirection) {
    motion.keep_on_line(v, at.position, at.direction);
  } else {
    motion.fix(v);
  }
}

void Slides::check_in_mesh_plane(Index v, const Slide& slide, const Track& track,
                                 const TrackPoint& at) const {
  if (scene_.type != MeshType::planar) return;
  const Vec3& normal = scene_.orientation.normal;
  const bool leaves_by_place =
      scene_.is_apart(std::abs(normal.dot(at.position - scene_.points[v])));
  const bool leaves_by_direction =
      track.dimension() == 1 && std::abs(normal.dot(at.direction)) > kSameDirection;
  if (!leaves_by_place && !leaves_by_direction) return;
  fail(slide.selection.text,
       fmt::format("{} would leave the plane of the mesh", scene_.name_of(v)));
}

// Of a vertex that is not on its slide yet.
// @return  how far it is from it, 0 if it counts as on it
double Slides::set_target(Index v, std::uint32_t s, const Vec3& position) {
  TargetList& targets = arrangement_.targets;
  const std::string& text = slide(s).selection.text;
  const std::uint32_t first = arrangement_.slide_of[v];
  const Vec3 before = targets.has(v) ? targets.position(v) : scene_.points[v];
  const double apart = (position - before).norm();
  if (first != s && scene_.is_apart(apart)) {
    contradict(slide(first).selection.text, text,
               fmt::format("{} cannot be on both, which are {:.3g} apart there", scene_.name_of(v),
                           apart));
  }
  const double distance = (position - scene_.points[v]).norm();
  if (distance <= (slide(s).track != nullptr ? kOnIt : kFits) * scene_.size) return 0.0;
  if (first == s) targets.set(v, position, text);
  return distance;
}

// ---- what came of it ----------------------------------------------------------------------------

ConstraintSummary Slides::summarize(std::uint32_t s, double farthest) const {
  std::size_t number = 0;
  for (Index v = 0; v < scene_.points.size(); ++v) {
    number += taking_part_[s][v] && arrangement_.moves(v);
  }
  std::string note;
  const std::size_t staying = count(slide(s).selection.vertices) - number;
  if (staying > 0) note = vertices(staying) + " of the selection stay or keep to their edges";
  if (farthest > 0.0) {
    note +=
        fmt::format("{}brought onto it from up to {:.3g} away", note.empty() ? "" : "; ", farthest);
  }
  return {fmt::format("slide on {}", name(slide(s).on)),
          slide(s).selection.text,
          Entry::eliminated,
          number,
          "vertices",
          note};
}

}  // namespace evenmesh
