// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "evenmesh/geometry/area.h"
#include "evenmesh/mesh/extent.h"

namespace evenmesh {
namespace {

// Mean normal around each vertex of a surface mesh, unit or zero.
std::vector<Vec3> tangent_plane_normals(const Mesh& mesh) {
  const Cells& cells = mesh.cells();
  std::vector<Vec3> areas(cells.size());
  std::vector<Vec3> corners;
  // Areas and their products must not leave the range of double, whatever the unit of length.
  const double half = extent_of(mesh.points(), cells.corners()).half();
  const double unit = half > 0.0 ? half : 1.0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    corners.clear();
    const Vec3& first = mesh.points()[cells.vertices(c)[0]];
    for (const Index v : cells.vertices(c)) corners.push_back((mesh.points()[v] - first) / unit);
    areas[c] = area_vector(corners);
  }
  // Files wind neighbouring cells either way. The greatest cell around a vertex says which way its
  // normal points; it does not matter which, only that the others do not cancel it.
  std::vector<std::uint32_t> greatest(mesh.point_count(), ~0u);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const Index v : cells.vertices(c)) {
      if (greatest[v] == ~0u || areas[c].squaredNorm() > areas[greatest[v]].squaredNorm()) {
        greatest[v] = static_cast<std::uint32_t>(c);
      }
    }
  }
  std::vector<Vec3> normals(mesh.point_count(), Vec3::Zero());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const Index v : cells.vertices(c)) {
      const bool agrees = areas[c].dot(areas[greatest[v]]) >= 0.0;
      normals[v] += agrees ? areas[c] : Vec3(-areas[c]);
    }
  }
  for (Vec3& n : normals) {
    const double length = n.stableNorm();
    n = length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
  }
  return normals;
}

}  // namespace

Motion::Motion(const Mesh& mesh, const Orientation& orientation, std::span<const char> fixed)
    : freedom_(mesh.point_count(), Freedom::fixed) {
  assert(fixed.size() == mesh.point_count());
  if (orientation.type == MeshType::planar) common_normal_ = orientation.normal;
  for (const Index v : mesh.cells().corners()) {
    if (fixed[v]) continue;
    freedom_[v] = orientation.type == MeshType::volume ? Freedom::free : Freedom::plane;
  }
  if (orientation.type != MeshType::surface) return;
  const std::vector<Vec3> normals = tangent_plane_normals(mesh);
  for (Index v = 0; v < freedom_.size(); ++v) {
    if (freedom_[v] == Freedom::fixed) continue;
    if (normals[v].isZero()) {
      freedom_[v] = Freedom::fixed;
    } else {
      start_[own_slot(v)] = {mesh.points()[v], normals[v], 0};
    }
  }
}

std::uint32_t Motion::own_slot(Index vertex) {
  if (slot_.empty()) slot_.assign(freedom_.size(), kNone);
  if (slot_[vertex] == kNone) {
    slot_[vertex] = static_cast<std::uint32_t>(slots_.size());
    slots_.push_back(vertex);
    tracks_.emplace_back();
    start_.emplace_back();
  }
  return slot_[vertex];
}

void Motion::fix(Index vertex) {
  for_tied(vertex, [&](Index v) { freedom_[v] = Freedom::fixed; });
}

Vec3 Motion::direction(Index vertex) const {
  const std::uint32_t own = slot(vertex);
  return own == kNone ? common_normal_ : start_[own].direction;
}

// Intersects the line or plane that a vertex moves in with another through the same point.
void Motion::restrict_to(Index vertex, const Vec3& position, Freedom freedom, const Vec3& u) {
  constexpr double kParallel = 1e-9;  // sine of the angle below which directions are the same
  const Freedom now = freedom_[vertex];
  if (now == Freedom::fixed || freedom == Freedom::free) return;
  if (freedom == Freedom::fixed) return fix(vertex);
  const Vec3 v = direction(vertex);
  if (const Track* curved = track(vertex)) {
    // Its tangent says where it is going only here.
    const bool within = freedom == Freedom::plane && curved->lies_in_plane(start_[slot(vertex)], u);
    return within ? void() : fix(vertex);
  }
  const auto set = [&](Freedom result, const Vec3& along) {
    freedom_[vertex] = result;
    start_[own_slot(vertex)] = {position, along, 0};
  };
  if (now == Freedom::free) return set(freedom, u);
  if (now == Freedom::plane && freedom == Freedom::plane) {
    const Vec3 common = u.cross(v);
    if (common.norm() > kParallel) set(Freedom::line, common.normalized());
    return;
  }
  if (now == Freedom::line && freedom == Freedom::line) {
    if (u.cross(v).norm() > kParallel) fix(vertex);
    return;
  }
  // A line and a plane.
  if (std::abs(u.dot(v)) > kParallel) return fix(vertex);
  if (freedom == Freedom::line) set(Freedom::line, u);
}

void Motion::keep_in_plane(Index vertex, const Vec3& position, const Vec3& normal) {
  restrict_to(vertex, position, Freedom::plane, normal);
}

void Motion::keep_on_line(Index vertex, const Vec3& position, const Vec3& direction) {
  freedom_[vertex] = Freedom::line;
  const std::uint32_t own = own_slot(vertex);
  tracks_[own] = nullptr;
  start_[own] = {position, direction, 0};
}

void Motion::put_on_track(Index vertex, std::shared_ptr<const Track> track, const TrackPoint& at) {
  freedom_[vertex] = track->dimension() == 1 ? Freedom::line : Freedom::plane;
  const std::uint32_t own = own_slot(vertex);
  tracks_[own] = std::move(track);
  start_[own] = at;
}

void Motion::tie(Index follower, Index leader, Points points) {
  if (leader_.empty()) {
    leader_.resize(freedom_.size());
    std::iota(leader_.begin(), leader_.end(), Index{0});
    next_ = leader_;
  }
  const Index old = leader_[follower];
  leader = leader_[leader];
  if (old == leader) return;
  restrict_to(leader, points[leader], freedom_[old], direction(old));
  for_tied(old, [&](Index v) { leader_[v] = leader; });
  tied_.push_back(old);
  std::swap(next_[old], next_[leader]);  // makes one ring of two
  for_tied(leader, [&](Index v) {
    freedom_[v] = freedom_[leader];
    if (v == leader || slot(leader) == kNone) return;
    start_[own_slot(v)] = {points[v], direction(leader), 0};
  });
}

std::size_t Motion::moving() const {
  return static_cast<std::size_t>(std::count_if(freedom_.begin(), freedom_.end(),
                                                [](Freedom f) { return f != Freedom::fixed; }));
}

bool Motion::has_kinks() const {
  return std::any_of(tracks_.begin(), tracks_.end(),
                     [](const auto& track) { return track && track->has_kinks(); });
}

const Track* Motion::track(Index vertex) const {
  const std::uint32_t own = slot(vertex);
  return own == kNone ? nullptr : tracks_[own].get();
}

Vec3 Motion::normal(Index vertex) const {
  return freedom_[vertex] == Freedom::plane ? direction(vertex) : Vec3(Vec3::Zero());
}

void Motion::reduce(Workers& workers, const Places& places, std::span<Vec3> gradient) const {
  for (const Index v : tied_) {
    gradient[leader_[v]] += gradient[v];
    gradient[v] = Vec3::Zero();
  }
  project(workers, places, gradient);
}

void Motion::project(Workers& workers, const Places& places, std::span<Vec3> step) const {
  for_ranges(workers, step.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      step[v] = project(places, static_cast<Index>(v), step[v]);
    }
  });
  for (const Index v : tied_) step[v] = Vec3::Zero();
}

void Motion::retract(Workers& workers, Points x_0, const Places& from, std::span<Vec3> x,
                     Places& to) const {
  to.resize(from.size());
  for_ranges(workers, slots_.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Index v = slots_[k];
      to[k] = from[k];
      if (!tracks_[k] || x[v] == x_0[v]) continue;
      to[k] = tracks_[k]->nearest(x[v], from[k]);
      x[v] = to[k].position;
    }
  });
  for (const Index v : tied_) x[v] = x_0[v] + (x[leader_[v]] - x_0[leader_[v]]);
}

void Motion::retract(Index vertex, Points x_0, const Places& from, std::span<Vec3> x,
                     Places& to) const {
  const std::uint32_t own = slot(vertex);
  if (own != kNone) {
    to[own] = from[own];
    if (tracks_[own] && x[vertex] != x_0[vertex]) {
      to[own] = tracks_[own]->nearest(x[vertex], from[own]);
      x[vertex] = to[own].position;
    }
  }
  for_tied(vertex, [&](Index v) {
    if (v != vertex) x[v] = x_0[v] + (x[vertex] - x_0[vertex]);
  });
}

void Motion::start_from(Workers& workers, Points x_0, Points x) {
  std::vector<Vec3> there(x.begin(), x.end());
  Places places;
  retract(workers, x_0, start_, there, places);
  start_ = std::move(places);
}

Motion Motion::selected(std::span<const Index> vertices) const {
  Motion result;
  result.common_normal_ = common_normal_;
  result.freedom_.reserve(vertices.size());
  for (const Index v : vertices) result.freedom_.push_back(freedom_[v]);
  for (Index k = 0; k < vertices.size() && !slot_.empty(); ++k) {
    const std::uint32_t old = slot_[vertices[k]];
    if (old == kNone) continue;
    const std::uint32_t own = result.own_slot(k);
    result.tracks_[own] = tracks_[old];
    result.start_[own] = start_[old];
  }
  return result;
}

Motion Motion::renumbered(std::span<const Index> order) const {
  Motion result = selected(order);
  if (leader_.empty()) return result;
  std::vector<Index> number(order.size());
  for (Index k = 0; k < order.size(); ++k) number[order[k]] = k;
  for (const Index v : order) {
    result.leader_.push_back(number[leader_[v]]);
    result.next_.push_back(number[next_[v]]);
  }
  for (const Index v : tied_) result.tied_.push_back(number[v]);
  return result;
}

}  // namespace evenmesh
