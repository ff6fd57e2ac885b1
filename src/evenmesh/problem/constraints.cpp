// SPDX-License-Identifier: MIT
#include "evenmesh/problem/constraints.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/constraint/mesh_tracks.h"
#include "evenmesh/mesh/extent.h"
#include "evenmesh/mesh/measure.h"
#include "evenmesh/problem/figures.h"
#include "evenmesh/problem/periodic_pairs.h"
#include "evenmesh/problem/shape_keeping.h"

namespace evenmesh {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Relative to the diagonal of the mesh's box:
constexpr double kFits = 1e-6;           // how far from a fitted figure a vertex may lie
constexpr double kOnIt = 1e-9;           // so near a given figure a vertex is on it
constexpr double kInPlane = 1e-7;        // so near a symmetry plane a vertex is in it
constexpr double kImage = 1e-6;          // how far from its image a periodic vertex may lie
constexpr double kContradicts = 1e-6;    // places further apart are not the same
constexpr double kSameDirection = 1e-6;  // sine of the angle

std::size_t count(std::span<const char> flags) {
  return static_cast<std::size_t>(
      std::count_if(flags.begin(), flags.end(), [](char f) { return f != 0; }));
}

bool is_curve(SlideOn on) { return on == SlideOn::line || on == SlideOn::circle; }
bool is_figure(SlideOn on) { return on <= SlideOn::sphere; }
bool is_line_or_plane(SlideOn on) { return on == SlideOn::line || on == SlideOn::plane; }

std::string vertices(std::size_t number) {
  return number == 1 ? "1 vertex" : fmt::format("{} vertices", number);
}

// The steps of apply() in their order.
class Application {
 public:
  Application(const Mesh& mesh, const Topology& topology, const Constraints& constraints,
              Problem& problem)
      : mesh_(mesh),
        points_(mesh.points()),
        topology_(topology),
        constraints_(constraints),
        problem_(problem),
        motion_(problem.motion),
        type_(problem.orientation.type) {
    size_ = extent_of(points_, mesh.cells().corners()).diagonal();
  }

  std::vector<ConstraintSummary> perform() {
    check_selections();
    const std::size_t n = points_.size();
    motion_ = Motion(mesh_, problem_.orientation, std::vector<char>(n, 0));
    held_.resize(n);
    slide_.assign(n, kNone);
    target_.assign(n, kNone);
    if (!(size_ > 0.0)) {  // one place: nothing has a direction
      for (Index v = 0; v < n; ++v) motion_.fix(v);
      return {};
    }
    find_defaults();
    take_for_slides();
    apply_defaults();
    std::vector<ConstraintSummary> slides;
    for (std::uint32_t s = 0; s < constraints_.slides.size(); ++s) slides.push_back(slide(s));
    if (constraints_.fixed) {
      for (Index v = 0; v < n; ++v) {
        if (is_fixed(v)) motion_.fix(v);
      }
    }
    std::vector<ConstraintSummary> joint;
    for (const Symmetry& symmetry : constraints_.symmetries) joint.push_back(mirror(symmetry));
    for (const Periodic& periodic : constraints_.periodic) joint.push_back(repeat(periodic));
    prescribe();
    limit_moves();
    demand();
    summarize_defaults();
    summarize_selections();
    summary_.insert(summary_.end(), slides.begin(), slides.end());
    summary_.insert(summary_.end(), joint.begin(), joint.end());
    summarize_prescriptions();
    summarize_demands();
    return std::move(summary_);
  }

 private:
  [[noreturn]] static void fail(std::string_view text, std::string_view what) {
    throw InvalidOption(fmt::format("{}: {}", text, what));
  }
  [[noreturn]] static void contradict(std::string_view a, std::string_view b,
                                      std::string_view what) {
    throw InvalidOption(fmt::format("{} and {} contradict each other: {}", a, b, what));
  }

  std::string name_of(Index v) const {
    return constraints_.vertex_name ? constraints_.vertex_name(v) : fmt::format("vertex {}", v);
  }
  bool is_fixed(Index v) const { return constraints_.fixed && constraints_.fixed->vertices[v]; }
  bool moves(Index v) const { return motion_.freedom(v) != Motion::Freedom::fixed; }
  const MeshTracks& tracks() {
    if (!tracks_) tracks_ = find_mesh_tracks(mesh_, problem_.orientation, topology_);
    return *tracks_;
  }
  void add(std::string kind, std::string text, Entry entry, std::size_t number, std::string unit,
           std::string note = {}) {
    summary_.push_back(
        {std::move(kind), std::move(text), entry, number, std::move(unit), std::move(note)});
  }

  // ---- what is asked for ------------------------------------------------------------------------

  void check_selection(const std::string& text, const std::vector<char>& flags) const {
    assert(flags.size() == points_.size());
    if (count(flags) == 0) fail(text, "it selects no vertex of this mesh");
  }

  // --fix none is fine: nothing is to stay.
  void check_selections() const {
    for (const Selection& free : constraints_.free) check_selection(free.text, free.vertices);
    for (const Slide& s : constraints_.slides) {
      check_selection(s.selection.text, s.selection.vertices);
    }
    for (const Periodic& p : constraints_.periodic) {
      check_selection(p.text, p.first);
      check_selection(p.text, p.second);
    }
    for (const MoveLimit& limit : constraints_.move_limits) {
      check_selection(limit.selection.text, limit.selection.vertices);
      if (limit.distance.value > 0.0) continue;
      fail(limit.selection.text, "vertices that may not move at all are better fixed (--fix)");
    }
    for (const Prescription& p : constraints_.prescriptions) {
      if (p.targets.empty()) fail(p.text, "it moves no vertex of this mesh");
    }
    for (const Selection& free : constraints_.free) {
      if (!constraints_.fixed) continue;
      for (Index v = 0; v < free.vertices.size(); ++v) {
        if (!free.vertices[v] || !is_fixed(v)) continue;
        contradict(constraints_.fixed->text, free.text,
                   fmt::format("{} is in both selections", name_of(v)));
      }
    }
  }

  // ---- defaults ---------------------------------------------------------------------------------

  void find_defaults() {
    const bool surface = type_ == MeshType::surface;
    if (constraints_.fixed && !surface) return;
    const bool slides = surface || constraints_.max_deviation.has_value();
    held_ = keep_shape(mesh_, problem_.orientation, topology_, tracks(),
                       slides ? Curved::slides : Curved::stays);
    if (constraints_.fixed) {
      for (Index v = 0; v < held_.size(); ++v) {
        const bool on_run = held_[v].hold == Hold::curved && tracks().place[v] == VertexPlace::run;
        if (on_run) held_[v].hold = Hold::run;
      }
    }
    for (const Selection& free : constraints_.free) {
      for (Index v = 0; v < held_.size(); ++v) {
        if (free.vertices[v]) held_[v] = {};
      }
    }
  }

  void apply_defaults() {
    for (Index v = 0; v < held_.size(); ++v) {
      if (slide_[v] != kNone || !moves(v)) continue;
      switch (held_[v].hold) {
        case Hold::nothing:
          break;
        case Hold::corner:
        case Hold::curved:
          motion_.fix(v);
          break;
        case Hold::line:
          motion_.keep_on_line(v, points_[v], held_[v].direction);
          break;
        case Hold::plane:
          motion_.keep_in_plane(v, points_[v], held_[v].direction);
          break;
        case Hold::run:
        case Hold::surface:
          motion_.put_on_track(v, tracks().tracks[tracks().track[v]], tracks().start[v]);
      }
    }
  }

  // ---- slides -----------------------------------------------------------------------------------

  // What the shape hangs on stays: corners on every slide, edges where faces slide.
  bool is_held(Index v, const Slide& s) {
    if (held_[v].hold == Hold::nothing) return false;
    if (held_[v].hold == Hold::corner) return true;
    const bool on_faces = is_figure(s.on) ? !is_curve(s.on) : s.track != nullptr;
    if (!on_faces || type_ == MeshType::planar) return false;
    return tracks().place[v] == VertexPlace::run;
  }

  bool takes_part(Index v, const Slide& s) {
    return s.selection.vertices[v] && !is_fixed(v) && moves(v) && !is_held(v, s);
  }

  // Who slides has no default; of several slides the first is noted.
  void take_for_slides() {
    taking_part_.reserve(constraints_.slides.size());
    for (const Slide& s : constraints_.slides) {
      std::vector<char> part(points_.size(), 0);
      for (Index v = 0; v < part.size(); ++v) part[v] = takes_part(v, s);
      taking_part_.push_back(std::move(part));
    }
    for (std::uint32_t s = 0; s < taking_part_.size(); ++s) {
      for (Index v = 0; v < points_.size(); ++v) {
        if (taking_part_[s][v] && slide_[v] == kNone) slide_[v] = s;
      }
    }
  }

  ConstraintSummary slide(std::uint32_t s) {
    const Slide& slide = constraints_.slides[s];
    const bool in_plane = type_ != MeshType::planar || is_line_or_plane(slide.on) ||
                          slide.on == SlideOn::circle || slide.on == SlideOn::boundary ||
                          slide.on == SlideOn::features;
    if (!in_plane) {
      fail(slide.selection.text,
           fmt::format("the vertices of a planar mesh slide on lines, planes, circles and their "
                       "boundary, not on a {}",
                       name(slide.on)));
    }
    farthest_ = 0.0;
    if (slide.track != nullptr) {
      put_on_given(s);
    } else if (is_figure(slide.on)) {
      put_on_fitted(s);
    } else {
      put_on_own(s);
    }
    return summarize_slide(s);
  }

  void put_on_given(std::uint32_t s) {
    const Slide& slide = constraints_.slides[s];
    for (Index v = 0; v < points_.size(); ++v) {
      if (!taking_part_[s][v]) continue;
      settle(v, s, slide.track,
             slide.nearest ? slide.nearest(points_[v]) : place_on(*slide.track, v));
    }
  }

  TrackPoint place_on(const Track& track, Index v) const {
    return track.nearest(points_[v], {points_[v], Vec3::Zero(), 0});
  }

  void put_on_fitted(std::uint32_t s) {
    const Slide& slide = constraints_.slides[s];
    for (const FittedPiece& piece : fit_figures(mesh_, problem_.orientation, topology_, slide.on,
                                                slide.selection.vertices, taking_part_[s])) {
      if (piece.figure == nullptr) {
        fail(slide.selection.text,
             fmt::format("the {} around {} do not say which {}; give its numbers",
                         vertices(piece.vertices.size()), name_of(piece.vertices.front()),
                         name(slide.on)));
      }
      if (!(piece.greatest_distance <= kFits * size_)) {
        fail(slide.selection.text,
             fmt::format("{} is {:.3g} off the {} fitted to the {} it hangs together with (at most "
                         "{:.3g} is allowed)",
                         name_of(piece.farthest), piece.greatest_distance, name(slide.on),
                         vertices(piece.vertices.size()), kFits * size_));
      }
      for (const Index v : piece.vertices) {
        if (taking_part_[s][v]) settle(v, s, piece.figure, place_on(*piece.figure, v));
      }
    }
  }

  // Features, boundary and surface of the input itself.
  void put_on_own(std::uint32_t s) {
    const Slide& slide = constraints_.slides[s];
    for (Index v = 0; v < points_.size(); ++v) {
      if (!taking_part_[s][v]) continue;
      const bool is_on = slide.on == SlideOn::features
                             ? topology_.features[v] || topology_.non_manifold[v]
                         : slide.on == SlideOn::boundary ? topology_.boundary[v]
                                                         : tracks().place[v] != VertexPlace::inside;
      if (!is_on) {
        fail(slide.selection.text, fmt::format("{} is not on the {}", name_of(v), name(slide.on)));
      }
      if (tracks().track[v] == MeshTracks::kNone) {
        taking_part_[s][v] = 0;
        motion_.fix(v);
        continue;
      }
      settle(v, s, tracks().tracks[tracks().track[v]], tracks().start[v]);
    }
  }

  // Puts a vertex on a figure, together with those it is on already.
  void settle(Index v, std::uint32_t s, const std::shared_ptr<const Track>& track,
              const TrackPoint& at) {
    check_in_mesh_plane(v, s, *track, at);
    aim_slide(v, s, at.position);
    const SlideOn on = constraints_.slides[s].on;
    if (slide_[v] == s) {
      if (on == SlideOn::line) {
        motion_.keep_on_line(v, at.position, at.direction);
      } else if (on == SlideOn::plane && type_ != MeshType::surface) {
        motion_.keep_in_plane(v, at.position, at.direction);
      } else {
        motion_.put_on_track(v, track, at);
      }
    } else if (on == SlideOn::plane) {
      motion_.keep_in_plane(v, at.position, at.direction);
    } else if (motion_.track(v) != track.get()) {
      settle_again(v, on, at);
    }
  }

  // On two curves, or a curve and a curved surface: there is only the line they may have in common.
  void settle_again(Index v, SlideOn on, const TrackPoint& at) {
    const bool straight = motion_.track(v) == nullptr && on == SlideOn::line;
    if (straight && motion_.project(v, at.direction).norm() > 1.0 - kSameDirection) {
      motion_.keep_on_line(v, at.position, at.direction);
    } else {
      motion_.fix(v);
    }
  }

  void check_in_mesh_plane(Index v, std::uint32_t s, const Track& track,
                           const TrackPoint& at) const {
    if (type_ != MeshType::planar) return;
    const Vec3& normal = problem_.orientation.normal;
    const bool leaves_by_place =
        std::abs(normal.dot(at.position - points_[v])) > kContradicts * size_;
    const bool leaves_by_direction =
        track.dimension() == 1 && std::abs(normal.dot(at.direction)) > kSameDirection;
    if (!leaves_by_place && !leaves_by_direction) return;
    fail(constraints_.slides[s].selection.text,
         fmt::format("{} would leave the plane of the mesh", name_of(v)));
  }

  // ---- places to be brought to ------------------------------------------------------------------

  void aim_slide(Index v, std::uint32_t s, const Vec3& position) {
    const std::string& text = constraints_.slides[s].selection.text;
    const double distance = (position - points_[v]).norm();
    const bool is_second = slide_[v] != s;
    const Vec3 before = target_[v] == kNone ? points_[v] : problem_.targets[target_[v]].position;
    if (is_second && (position - before).norm() > kContradicts * size_) {
      contradict(constraints_.slides[slide_[v]].selection.text, text,
                 fmt::format("{} cannot be on both, which are {:.3g} apart there", name_of(v),
                             (position - before).norm()));
    }
    if (distance <= (constraints_.slides[s].track != nullptr ? kOnIt : kFits) * size_) return;
    farthest_ = std::max(farthest_, distance);
    if (!is_second) aim(v, position, text);
  }

  void aim(Index v, const Vec3& position, const std::string& text) {
    target_[v] = static_cast<std::uint32_t>(problem_.targets.size());
    problem_.targets.push_back({v, position});
    target_texts_.push_back(text);
  }

  // ---- symmetry and periodicity -----------------------------------------------------------------

  ConstraintSummary mirror(const Symmetry& symmetry) {
    const std::vector<char> in_plane = vertices_in_plane(mesh_, symmetry.plane);
    const std::size_t number = count(in_plane);
    if (number == 0) {
      fail(symmetry.text, fmt::format("no vertex lies in this plane; the nearest, {}, is {:.3g} "
                                      "away",
                                      name_of(nearest_to(symmetry.plane)),
                                      distance(symmetry.plane, nearest_to(symmetry.plane))));
    }
    std::size_t stuck = 0;
    for (Index v = 0; v < in_plane.size(); ++v) {
      if (!in_plane[v] || !moves(v)) continue;
      motion_.keep_in_plane(v, points_[v], symmetry.plane.normal);
      if (!moves(v)) ++stuck;
    }
    std::string note;
    if (stuck > 0) note = vertices(stuck) + " in it stay: what they slide on leaves the plane";
    return {"symmetry", symmetry.text, Entry::eliminated, number, "vertices", note};
  }

  double distance(const Plane& plane, Index v) const {
    return std::abs(plane.normal.dot(points_[v] - plane.point));
  }
  Index nearest_to(const Plane& plane) const {
    Index best = 0;
    for (const Index v : mesh_.cells().corners()) {
      if (distance(plane, v) < distance(plane, best) || !topology_.used[best]) best = v;
    }
    return best;
  }

  ConstraintSummary repeat(const Periodic& periodic) {
    const auto listed = [&](const std::vector<char>& flags) {
      std::vector<Index> list;
      for (Index v = 0; v < flags.size(); ++v) {
        if (flags[v] && topology_.used[v]) list.push_back(v);
      }
      return list;
    };
    const std::vector<Index> first = listed(periodic.first);
    const std::vector<Index> second = listed(periodic.second);
    const Vec3 between = extent_of(points_, second).middle() - extent_of(points_, first).middle();
    const PeriodicMatch match = match_periodic(
        points_, first, second, periodic.translation.value_or(between), kImage * size_);
    if (match.unmatched > 0) {
      fail(periodic.text,
           fmt::format("{} of {} and {} on its two sides have no image on the other; the first is "
                       "{}, the nearest to its image is {:.3g} away",
                       match.unmatched, first.size(), second.size(), name_of(match.example),
                       match.nearest));
    }
    std::size_t stuck = 0;
    for (const auto& [a, b] : match.pairs) stuck += tie(a, b) ? 0 : 1;
    std::string note;
    if (stuck > 0)
      note = fmt::format("{} of the pairs stay: they slide on something curved", stuck);
    return {"periodic", periodic.text, Entry::eliminated, 2 * match.pairs.size(), "vertices", note};
  }

  // What slides on a curved track has no image to repeat its moves.
  bool tie(Index a, Index b) {
    for (const Index v : {a, b}) {
      if (motion_.track(v) == nullptr) continue;
      motion_.fix(a);
      motion_.fix(b);
      return false;
    }
    motion_.tie(b, a, points_);
    return true;
  }

  // ---- prescribed places ------------------------------------------------------------------------

  void prescribe() {
    for (const Prescription& p : constraints_.prescriptions) {
      for (const Target& target : p.targets) prescribe(target.vertex, target.position, p.text);
    }
    for (const PeriodicPair& pair : tied_pairs()) check_pair(pair);
    std::vector<std::uint32_t> order(problem_.targets.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return problem_.targets[a].vertex < problem_.targets[b].vertex;
    });
    std::vector<Target> targets;
    std::vector<std::string> texts;
    for (const std::uint32_t i : order) {
      target_[problem_.targets[i].vertex] = static_cast<std::uint32_t>(targets.size());
      targets.push_back(problem_.targets[i]);
      texts.push_back(std::move(target_texts_[i]));
    }
    problem_.targets = std::move(targets);
    target_texts_ = std::move(texts);
  }

  void prescribe(Index v, const Vec3& position, const std::string& text) {
    const Vec3 displacement = position - points_[v];
    const double way = displacement.norm();
    if (!std::isfinite(way)) fail(text, fmt::format("the place of {} is not finite", name_of(v)));
    if (is_fixed(v) && way > 0.0) {
      contradict(constraints_.fixed->text, text,
                 fmt::format("{} is fixed, but would move by {:.3g}", name_of(v), way));
    }
    check_on_planes(v, displacement, text);
    if (target_[v] != kNone) {
      const Vec3& other = problem_.targets[target_[v]].position;
      if ((other - position).norm() > kContradicts * size_) {
        contradict(target_texts_[target_[v]], text,
                   fmt::format("they bring {} to places {:.3g} apart", name_of(v),
                               (other - position).norm()));
      }
    } else if (slide_[v] != kNone && moves(v)) {
      check_on_slide(v, position, text);
    }
    motion_.fix(v);
    if (target_[v] == kNone) aim(v, position, text);
  }

  void check_on_planes(Index v, const Vec3& displacement, const std::string& text) const {
    const double slack = kContradicts * size_;
    if (type_ == MeshType::planar &&
        std::abs(problem_.orientation.normal.dot(displacement)) > slack) {
      fail(text, fmt::format("{} would leave the plane of the mesh", name_of(v)));
    }
    for (const Symmetry& symmetry : constraints_.symmetries) {
      if (distance(symmetry.plane, v) > kInPlane * size_) continue;
      const double off = std::abs(symmetry.plane.normal.dot(displacement));
      if (off <= slack) continue;
      contradict(symmetry.text, text,
                 fmt::format("{} would leave the plane by {:.3g}", name_of(v), off));
    }
  }

  void check_on_slide(Index v, const Vec3& position, const std::string& text) const {
    const Track* track = motion_.track(v);
    const Vec3 d = position - points_[v];
    const double off =
        track != nullptr
            ? (track->nearest(position, motion_.start()[motion_.slot(v)]).position - position)
                  .norm()
            : (d - motion_.project(v, d)).norm();
    if (off <= kContradicts * size_) return;
    contradict(constraints_.slides[slide_[v]].selection.text, text,
               fmt::format("{} would leave what it slides on by {:.3g}", name_of(v), off));
  }

  std::vector<PeriodicPair> tied_pairs() const {
    std::vector<PeriodicPair> pairs;
    for (Index v = 0; v < motion_.size(); ++v) {
      if (motion_.leader(v) != v) pairs.emplace_back(motion_.leader(v), v);
    }
    return pairs;
  }

  // One that is brought somewhere takes its image along.
  void check_pair(const PeriodicPair& pair) {
    const auto displacement = [&](Index v) {
      return Vec3(problem_.targets[target_[v]].position - points_[v]);
    };
    const auto [a, b] = pair;
    if (target_[a] == kNone && target_[b] == kNone) return;
    const Index from = target_[a] != kNone ? a : b;
    const Index to = from == a ? b : a;
    if (target_[to] == kNone) {
      const std::string text = target_texts_[target_[from]];
      return prescribe(to, points_[to] + displacement(from), text);
    }
    const double apart = (displacement(a) - displacement(b)).norm();
    if (apart <= kContradicts * size_) return;
    contradict(constraints_.periodic.front().text, target_texts_[target_[to]],
               fmt::format("{} and its image {} would move differently, by {:.3g}", name_of(a),
                           name_of(b), apart));
  }

  // ---- demands ----------------------------------------------------------------------------------

  void limit_moves() {
    std::vector<double>& limits = problem_.max_move;
    limits.clear();
    if (constraints_.move_limits.empty()) return;
    limits.assign(points_.size(), std::numeric_limits<double>::infinity());
    std::vector<double> sides;
    for (const MoveLimit& limit : constraints_.move_limits) {
      const bool relative = limit.distance.unit == Length::Unit::of_edges;
      if (relative && sides.empty()) sides = local_edge_lengths(mesh_);
      for (Index v = 0; v < limits.size(); ++v) {
        if (!limit.selection.vertices[v]) continue;
        limits[v] = std::min(limits[v], limit.distance.value * (relative ? sides[v] : 1.0));
        check_limit(v, limits[v], limit.selection.text);
      }
    }
  }

  void check_limit(Index v, double limit, const std::string& text) const {
    if (target_[v] == kNone) return;
    const double way = (problem_.targets[target_[v]].position - points_[v]).norm();
    if (way <= limit * (1.0 + kContradicts)) return;
    contradict(
        text, target_texts_[target_[v]],
        fmt::format("{} has to move by {:.3g}, but may only by {:.3g}", name_of(v), way, limit));
  }

  void demand() {
    problem_.bounds.clear();
    for (const NamedBound& bound : constraints_.bounds) problem_.bounds.push_back(bound.bound);
    if (const auto& least = constraints_.min_size) {
      const bool relative = least->unit == Length::Unit::of_mean_size;
      problem_.validity.min_size =
          least->value * (relative ? mean_size(mesh_, problem_.orientation) : 1.0);
    }
    if (const auto& least = constraints_.min_jacobian) {
      if (!(*least > 0.0 && *least < 1.0)) {
        fail("--min-jacobian", fmt::format("must lie between 0 and 1, not {}", *least));
      }
      problem_.validity.min_jacobian = *least;
    }
    std::optional<Length> deviation = constraints_.max_deviation;
    if (!deviation && type_ == MeshType::surface) {
      deviation = Length{Constraints::kDefaultDeviation, Length::Unit::of_diagonal};
    }
    problem_.max_deviation = std::numeric_limits<double>::infinity();
    if (!deviation) return;
    const bool relative = deviation->unit == Length::Unit::of_diagonal;
    problem_.max_deviation = deviation->value * (relative ? size_ : 1.0);
  }

  // ---- what holds -------------------------------------------------------------------------------

  void summarize_default(Hold hold, std::string_view kind, std::string_view note) {
    const bool stays = hold == Hold::corner || hold == Hold::curved;
    std::size_t number = 0;
    for (Index v = 0; v < held_.size(); ++v) {
      const bool overruled = slide_[v] != kNone || is_fixed(v) || target_[v] != kNone;
      if (held_[v].hold == hold && !overruled && moves(v) != stays) ++number;
    }
    if (number == 0) return;
    add(std::string(kind), "default", Entry::eliminated, number, "vertices", std::string(note));
  }

  void summarize_defaults() {
    const bool volume = type_ == MeshType::volume;
    summarize_default(Hold::corner, "fixed", "corners");
    summarize_default(Hold::curved, "fixed",
                      type_ == MeshType::surface ? "interfaces that bend"
                      : volume                   ? "skin and interfaces that bend"
                                                 : "boundary and interfaces that bend");
    summarize_default(Hold::line, "slide on line",
                      volume ? "straight edges" : "straight parts of boundary and interfaces");
    summarize_default(Hold::plane, "slide on plane", "flat parts of the skin");
    summarize_default(Hold::run, "slide on curve", "along the edges of the input");
    summarize_default(Hold::surface, "slide on surface",
                      volume ? "the skin of the input" : "the surface of the input");
  }

  void summarize_selections() {
    if (constraints_.fixed) {
      add("fixed", constraints_.fixed->text, Entry::eliminated, count(constraints_.fixed->vertices),
          "vertices");
    }
    for (const Selection& free : constraints_.free) {
      add("free", free.text, Entry::eliminated, count(free.vertices), "vertices");
    }
  }

  ConstraintSummary summarize_slide(std::uint32_t s) const {
    const Slide& slide = constraints_.slides[s];
    std::size_t number = 0;
    for (Index v = 0; v < points_.size(); ++v) number += taking_part_[s][v] && moves(v);
    std::string note;
    const std::size_t staying = count(slide.selection.vertices) - number;
    if (staying > 0) note = vertices(staying) + " of the selection stay or keep to their edges";
    if (farthest_ > 0.0) {
      note += fmt::format("{}brought onto it from up to {:.3g} away", note.empty() ? "" : "; ",
                          farthest_);
    }
    return {fmt::format("slide on {}", name(slide.on)),
            slide.selection.text,
            Entry::eliminated,
            number,
            "vertices",
            note};
  }

  void summarize_prescriptions() {
    for (const Prescription& p : constraints_.prescriptions) {
      double farthest = 0.0;
      for (const Target& target : p.targets) {
        farthest = std::max(farthest, (target.position - points_[target.vertex]).norm());
      }
      add(p.kind, p.text, Entry::eliminated, p.targets.size(), "vertices",
          fmt::format("by {:.3g} at most", farthest));
    }
  }

  void summarize_demands() {
    for (const MoveLimit& limit : constraints_.move_limits) {
      add("max_move", limit.selection.text, Entry::inequality, count(limit.selection.vertices),
          "vertices");
    }
    for (const NamedBound& named : constraints_.bounds) {
      add(std::string(named.bound.function->name()), named.text,
          named.bound.is_equation() ? Entry::bordered : Entry::inequality,
          named.bound.function->vertices().size(), "vertices");
    }
    if (const std::size_t number = count_on_own_curved(); number > 0) {
      if (std::isfinite(problem_.max_deviation)) {
        add("max_deviation", constraints_.max_deviation ? "--max-deviation" : "default",
            Entry::inequality, number, "vertices",
            fmt::format("at most {:.4g} from the input", problem_.max_deviation));
      }
    }
    if (!problem_.validity.demanded) return;
    const int dimension = type_ == MeshType::volume ? 3 : 2;
    const auto kinds = mesh_.cells().kinds();
    const auto number = std::count_if(kinds.begin(), kinds.end(), [&](CellKind kind) {
      return traits(kind).dimension == dimension;
    });
    std::string note = "no cell is turned over";
    if (problem_.validity.min_size > 0.0) {
      note += fmt::format("; none smaller than {:.4g}", problem_.validity.min_size);
    }
    if (problem_.validity.min_jacobian > 0.0) {
      note += fmt::format("; none with a Jacobian under {:.4g}", problem_.validity.min_jacobian);
    }
    const bool asked = constraints_.min_size || constraints_.min_jacobian;
    add("validity",
        !asked                       ? "default"
        : !constraints_.min_jacobian ? (dimension == 3 ? "--min-volume" : "--min-area")
                                     : "--min-jacobian",
        Entry::inequality, static_cast<std::size_t>(number), "cells", note);
  }

  // Vertices on tracks that are not figures: those of the input, or of another surface.
  std::size_t count_on_own_curved() const {
    std::size_t number = 0;
    for (Index v = 0; v < points_.size(); ++v) {
      if (!moves(v) || motion_.track(v) == nullptr) continue;
      number += slide_[v] == kNone || !is_figure(constraints_.slides[slide_[v]].on) ? 1 : 0;
    }
    return number;
  }

  const Mesh& mesh_;
  const Points points_;
  const Topology& topology_;
  const Constraints& constraints_;
  Problem& problem_;
  Motion& motion_;
  const MeshType type_;
  double size_ = 0.0;  // diagonal of the box
  std::optional<MeshTracks> tracks_;
  std::vector<Held> held_;            // the defaults
  std::vector<std::uint32_t> slide_;  // per vertex: the first slide it takes part in, or kNone
  std::vector<std::vector<char>> taking_part_;  // per slide and vertex
  std::vector<std::uint32_t> target_;           // per vertex: its entry in targets, or kNone
  std::vector<std::string> target_texts_;       // per target: who asked for it
  double farthest_ = 0.0;  // of the present slide: how far a vertex was from it
  std::vector<ConstraintSummary> summary_;
};

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
  problem.targets.clear();
  return Application(mesh, topology, constraints, problem).perform();
}

}  // namespace evenmesh
