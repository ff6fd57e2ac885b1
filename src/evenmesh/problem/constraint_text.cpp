// SPDX-License-Identifier: MIT
#include "evenmesh/problem/constraint_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/text.h"
#include "evenmesh/constraint/keep.h"
#include "evenmesh/constraint/phrases.h"
#include "evenmesh/constraint/prescribe.h"
#include "evenmesh/constraint/spacing.h"
#include "evenmesh/constraint/triangulation.h"
#include "evenmesh/geometry/bvh.h"
#include "evenmesh/geometry/surface_track.h"
#include "evenmesh/problem/figures.h"

namespace evenmesh {
namespace {

// An option as it was typed, for messages: in quotation marks where it has spaces.
std::string typed(std::string_view option, std::string_view value) {
  const char* const mark = value.find(' ') == std::string_view::npos ? "" : "'";
  return fmt::format("{} {}{}{}", option, mark, value, mark);
}

// The faces of a mesh as a track, and a way to find the nearest point from anywhere.
class OtherSurface {
 public:
  explicit OtherSurface(const Mesh& mesh)
      : faces_(mesh.points(), mesh.cells()),
        points_(faces_.positions(mesh.points())),
        tree_(points_, faces_.triangles()),
        track_(points_, {faces_.triangles().begin(), faces_.triangles().end()}) {}

  bool empty() const { return faces_.triangles().empty(); }
  const SurfaceTrack& track() const { return track_; }
  TrackPoint nearest(const Vec3& p) const {
    const Bvh::Hit hit = tree_.closest(p);
    return track_.nearest(hit.position, track_.at(hit.triangle, 0));
  }

 private:
  Triangulation faces_;
  std::vector<Vec3> points_;
  Bvh tree_;
  SurfaceTrack track_;
};

double parse_jacobian(const std::string& text) {
  const Length value = parse_length(text, "--min-jacobian", Length::Unit::absolute);
  if (!(value.value < 1.0)) {
    throw InvalidOption(
        fmt::format("--min-jacobian must lie between 0 and 1 (an ideal cell has 1), not {}", text));
  }
  return value.value;
}

// Reads the text, phrase by phrase, into Constraints.
class Reader {
 public:
  Reader(const ConstraintText& text, const ConstraintSetting& in) : text_(text), in_(in) {}

  Constraints read() {
    result_.vertex_name = in_.vertex_name;
    result_.held = in_.held;
    result_.layers = in_.layers;
    if (text_.fix != "auto") result_.fixed = selection("--fix", text_.fix);
    for (const std::string& t : text_.free) result_.free.push_back(selection("--free", t));
    for (const std::string& t : text_.slide) read_slide(t);
    read_surface();
    for (const std::string& t : text_.symmetry) {
      result_.symmetries.push_back({typed("--symmetry", t), parse_plane(t)});
    }
    for (const std::string& t : text_.periodic) read_periodic(t);
    read_limits();
    read_demands();
    for (const std::string& t : text_.keep) read_keep(t);
    for (const std::string& t : text_.equal_spacing) read_equal_spacing(t);
    for (const std::string& t : text_.prescribe) read_prescription(t);
    return std::move(result_);
  }

 private:
  std::vector<char> select(std::string_view text) const {
    return select_vertices(text, in_.mesh, in_.topology, in_.names);
  }

  Selection selection(std::string_view option, const std::string& text) const {
    return {typed(option, text), select(text)};
  }

  void read_slide(const std::string& text) {
    const SlidePhrase phrase = parse_slide(text);
    Slide slide{{typed("--slide", text), select(phrase.selector)}, phrase.on};
    if (!phrase.file.empty()) {
      put_on_surface(phrase.file, slide);
    } else if (!phrase.numbers.empty()) {
      slide.track = make_figure(phrase.on, phrase.numbers);
    }
    result_.slides.push_back(std::move(slide));
  }

  // The vertices of a surface or of a volume's skin, of which those on edges keep to these.
  void read_surface() {
    if (text_.surface.empty()) return;
    const bool volume = in_.orientation.type == MeshType::volume;
    Slide slide{{typed("--surface", text_.surface), select(volume ? "boundary" : "all")},
                SlideOn::surface};
    put_on_surface(text_.surface, slide);
    result_.slides.push_back(std::move(slide));
  }

  void put_on_surface(const std::string& file, Slide& slide) const {
    const auto surface = std::make_shared<const OtherSurface>(in_.read_mesh(file));
    if (surface->empty()) {
      throw InvalidOption(fmt::format("{}: {} has no faces", slide.selection.text, file));
    }
    slide.track = std::shared_ptr<const Track>(surface, &surface->track());
    slide.nearest = [surface](const Vec3& p) { return surface->nearest(p); };
  }

  void read_periodic(const std::string& text) {
    const PeriodicPhrase phrase = parse_periodic(text);
    const std::optional<Plane> first = try_plane(phrase.first);
    const std::optional<Plane> second = try_plane(phrase.second);
    Periodic periodic{typed("--periodic", text), side(first, phrase.first),
                      side(second, phrase.second)};
    if (first && second) {
      if (first->normal.cross(second->normal).norm() > 1e-9) {
        throw InvalidOption(periodic.text + ": the two planes are not parallel");
      }
      const Vec3& normal = first->normal;
      periodic.translation = normal.dot(second->point - first->point) * normal;
    }
    result_.periodic.push_back(std::move(periodic));
  }

  std::vector<char> side(const std::optional<Plane>& plane, const std::string& selector) const {
    return plane ? vertices_in_plane(in_.mesh, *plane) : select(selector);
  }

  void read_limits() {
    if (!text_.max_move.empty()) {
      result_.move_limits.push_back(
          {{typed("--max-move", text_.max_move), std::vector<char>(in_.mesh.point_count(), 1)},
           parse_length(text_.max_move, "--max-move", Length::Unit::of_edges)});
    }
    for (const std::string& t : text_.limit) {
      const LimitPhrase phrase = parse_limit(t);
      result_.move_limits.push_back(
          {{typed("--limit", t), select(phrase.selector)}, phrase.distance});
    }
    if (!text_.max_deviation.empty()) {
      result_.max_deviation =
          parse_length(text_.max_deviation, "--max-deviation", Length::Unit::of_diagonal);
    }
  }

  void read_demands() {
    const bool volume = in_.orientation.type == MeshType::volume;
    const std::string& least = volume ? text_.min_volume : text_.min_area;
    const std::string& other = volume ? text_.min_area : text_.min_volume;
    if (!other.empty()) {
      throw InvalidOption(volume ? "--min-area is for surface cells; this mesh is one of volume "
                                   "cells, for which there is --min-volume"
                                 : "--min-volume is for volume cells; this mesh has surface cells, "
                                   "for which there is --min-area");
    }
    if (!least.empty()) {
      result_.min_size =
          parse_length(least, volume ? "--min-volume" : "--min-area", Length::Unit::of_mean_size);
    }
    if (!text_.min_jacobian.empty()) result_.min_jacobian = parse_jacobian(text_.min_jacobian);
  }

  void read_keep(const std::string& text) {
    const KeepPhrase phrase = parse_keep(text);
    const Keep what = phrase.what == KeepPhrase::What::area ? Keep::area : Keep::volume;
    const std::string option = typed("--keep", text);
    try {
      result_.bounds.push_back(
          {option, make_keep(in_.mesh, in_.orientation, what, only_group(phrase.group))});
    } catch (const InvalidOption& error) {
      throw InvalidOption(fmt::format("{}: {}", option, error.what()));
    }
  }

  std::optional<std::uint32_t> only_group(const std::string& name) const {
    if (name.empty()) return std::nullopt;
    const std::vector<char> groups = find_groups(in_.names.groups, name);
    const auto first = std::find(groups.begin(), groups.end(), 1);
    const auto second = std::find(first + 1, groups.end(), 1);
    const auto number = [&](auto group) {
      return static_cast<std::uint32_t>(group - groups.begin());
    };
    if (second == groups.end()) return number(first);
    throw InvalidOption(fmt::format("'{}' names more than one group: '{}' and '{}'", shown(name),
                                    shown(in_.names.groups[number(first)]),
                                    shown(in_.names.groups[number(second)])));
  }

  void read_equal_spacing(const std::string& text) {
    const Selection selected = selection("--equal-spacing", text);
    Prescription evenly{selected.text, {}, "equal_spacing"};
    try {
      for (const Chain& chain : chains_of(in_.mesh, in_.topology, selected.vertices)) {
        const std::vector<Target> targets = space_evenly(in_.mesh.points(), chain);
        evenly.targets.insert(evenly.targets.end(), targets.begin(), targets.end());
      }
    } catch (const InvalidOption& error) {
      throw InvalidOption(fmt::format("{}: {}", selected.text, error.what()));
    }
    result_.prescriptions.push_back(std::move(evenly));
  }

  void read_prescription(const std::string& text) {
    const PrescribePhrase phrase = parse_prescribe(text);
    const std::string option = typed("--prescribe", text);
    const bool all = phrase.selector.empty();
    const std::vector<char> selected = all ? std::vector<char>{} : select(phrase.selector);
    result_.prescriptions.push_back({option, !phrase.formulas.empty()
                                                 ? by_formulas(phrase.formulas, selected)
                                                 : by_file(phrase.file, selected)});
  }

  std::vector<Target> by_formulas(const std::string& formulas,
                                  const std::vector<char>& selected) const {
    const auto displacement = in_.displacement(formulas);
    std::vector<Target> targets;
    for (Index v = 0; v < selected.size(); ++v) {
      const Vec3& p = in_.mesh.points()[v];
      if (selected[v]) targets.push_back({v, p + displacement(p)});
    }
    return targets;
  }

  /// A table of places, or another mesh with the same vertices.
  std::vector<Target> by_file(const std::string& file, const std::vector<char>& selected) const {
    const std::string name = lower(file);
    const bool table = name.ends_with(".csv") || name.ends_with(".txt") || name.ends_with(".tsv");
    if (!table) return targets_from(in_.mesh, in_.read_mesh(file), selected);
    std::vector<Target> targets;
    try {
      targets =
          read_targets(in_.read_text(file), in_.mesh.points(), in_.names.first_id, in_.names.ids);
    } catch (const InvalidOption& error) {
      throw InvalidOption(fmt::format("{}: {}", file, error.what()));
    }
    if (!selected.empty())
      std::erase_if(targets, [&](const Target& t) { return !selected[t.vertex]; });
    return targets;
  }

  const ConstraintText& text_;
  const ConstraintSetting& in_;
  Constraints result_;
};

}  // namespace

void check(const ConstraintText& text) {
  for (const std::string& t : text.slide) parse_slide(t);
  for (const std::string& t : text.symmetry) parse_plane(t);
  for (const std::string& t : text.periodic) parse_periodic(t);
  for (const std::string& t : text.limit) parse_limit(t);
  for (const std::string& t : text.keep) parse_keep(t);
  for (const std::string& t : text.prescribe) parse_prescribe(t);
  struct Number {
    std::string_view option;
    const std::string& value;
    Length::Unit unit;
  };
  for (const Number& number :
       {Number{"--max-move", text.max_move, Length::Unit::of_edges},
        Number{"--max-deviation", text.max_deviation, Length::Unit::of_diagonal},
        Number{"--min-area", text.min_area, Length::Unit::of_mean_size},
        Number{"--min-volume", text.min_volume, Length::Unit::of_mean_size}}) {
    if (!number.value.empty()) parse_length(number.value, number.option, number.unit);
  }
  if (!text.min_jacobian.empty()) parse_jacobian(text.min_jacobian);
}

Constraints understand(const ConstraintText& text, const ConstraintSetting& setting) {
  return Reader(text, setting).read();
}

}  // namespace evenmesh
