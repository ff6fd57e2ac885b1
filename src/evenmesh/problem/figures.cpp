// SPDX-License-Identifier: MIT
#include "evenmesh/problem/figures.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <utility>

#include "evenmesh/geometry/analytic_tracks.h"
#include "evenmesh/geometry/fit.h"
#include "evenmesh/geometry/parity_sets.h"
#include "evenmesh/mesh/cell_edges.h"

namespace evenmesh {
namespace {

// Calls visit(a, b) for the edges through which vertices on such a figure hang together. Two
// vertices of a boundary may well be joined by an edge that runs across the mesh.
template <typename Visit>
void for_each_link(const Mesh& mesh, const Orientation& orientation, const Topology& topology,
                   SlideOn on, const Visit& visit) {
  std::vector<char> on_own(mesh.point_count(), 0);  // joined only by the edges visited here
  const auto own = [&](Index a, Index b) {
    on_own[a] = on_own[b] = 1;
    visit(a, b);
  };
  if (is_curve(on)) {
    for (const auto& [a, b] : topology.curves) own(a, b);
  } else if (orientation.type == MeshType::volume) {
    for_each_cell_edge(topology.skin, own);
  }
  for_each_cell_edge(mesh.cells(), [&](Index a, Index b) {
    if (!on_own[a] || !on_own[b]) visit(a, b);
  });
}

template <typename T>
std::shared_ptr<const Track> track_of(const std::optional<Fit<T>>& fit) {
  return fit ? std::make_shared<const T>(fit->track) : nullptr;
}

std::shared_ptr<const Track> fit_one(SlideOn on, Points points) {
  switch (on) {
    case SlideOn::line:
      return track_of(fit_line(points));
    case SlideOn::plane:
      return track_of(fit_plane(points));
    case SlideOn::circle:
      return track_of(fit_circle(points));
    case SlideOn::cylinder:
      return track_of(fit_cylinder(points));
    case SlideOn::sphere:
      return track_of(fit_sphere(points));
    default:
      assert(false);
      return nullptr;
  }
}

void fit(SlideOn on, Points points, FittedPiece& piece) {
  std::vector<Vec3> own;
  own.reserve(piece.vertices.size());
  for (const Index v : piece.vertices) own.push_back(points[v]);
  piece.figure = fit_one(on, own);
  if (piece.figure == nullptr) return;
  piece.farthest = piece.vertices.front();
  for (const Index v : piece.vertices) {
    const Vec3 at = piece.figure->nearest(points[v], {points[v], Vec3::Zero(), 0}).position;
    const double distance = (at - points[v]).norm();
    if (distance <= piece.greatest_distance) continue;
    piece.greatest_distance = distance;
    piece.farthest = v;
  }
}

}  // namespace

std::shared_ptr<const Track> make_figure(SlideOn on, std::span<const double> numbers) {
  const Vec3 a = vector_at(numbers, 0);
  if (on == SlideOn::sphere) return std::make_shared<SphereTrack>(a, numbers[3]);
  const Vec3 b = vector_at(numbers, 3);
  if (on == SlideOn::line) return std::make_shared<LineTrack>(a, b);
  if (on == SlideOn::plane) return std::make_shared<PlaneTrack>(a, b);
  if (on == SlideOn::circle) return std::make_shared<CircleTrack>(a, b, numbers[6]);
  assert(on == SlideOn::cylinder);
  return std::make_shared<CylinderTrack>(a, b, numbers[6]);
}

std::vector<FittedPiece> fit_figures(const Mesh& mesh, const Orientation& orientation,
                                     const Topology& topology, SlideOn on,
                                     std::span<const char> selected,
                                     std::span<const char> sliding) {
  ParitySets sets(mesh.point_count());
  std::vector<std::pair<Index, Index>> ends;  // (sliding vertex, selected neighbour that stays)
  for_each_link(mesh, orientation, topology, on, [&](Index a, Index b) {
    if (!selected[a] || !selected[b]) return;
    if (sliding[a] && sliding[b]) {
      sets.unite(a, b, false);
    } else if (sliding[a]) {
      ends.emplace_back(a, b);
    } else if (sliding[b]) {
      ends.emplace_back(b, a);
    }
  });
  std::map<Index, FittedPiece> pieces;
  for (Index v = 0; v < sliding.size(); ++v) {
    if (sliding[v]) pieces[sets.find(v).root].vertices.push_back(v);
  }
  for (const auto& [v, end] : ends) pieces[sets.find(v).root].vertices.push_back(end);
  std::vector<FittedPiece> result;
  for (auto& [root, piece] : pieces) {
    std::sort(piece.vertices.begin(), piece.vertices.end());
    piece.vertices.erase(std::unique(piece.vertices.begin(), piece.vertices.end()),
                         piece.vertices.end());
    fit(on, mesh.points(), piece);
    result.push_back(std::move(piece));
  }
  return result;
}

}  // namespace evenmesh
