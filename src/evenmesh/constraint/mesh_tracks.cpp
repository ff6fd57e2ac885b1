// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/mesh_tracks.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

#include "evenmesh/constraint/chains.h"
#include "evenmesh/constraint/triangulation.h"
#include "evenmesh/geometry/curve_track.h"
#include "evenmesh/mesh/extent.h"
#include "evenmesh/mesh/plane.h"

namespace evenmesh {
namespace {

constexpr std::uint32_t kNone = MeshTracks::kNone;

/// The surface of the faces, which curves divide.
std::shared_ptr<const SurfaceTrack> surface_of(const Mesh& mesh, const Cells& faces,
                                               const EdgeNet& net) {
  const Triangulation triangulation(mesh.points(), faces);
  const auto triangles = triangulation.triangles();
  std::vector<std::uint8_t> barriers(triangles.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Index a = triangles[t][j];
      const Index b = triangles[t][(j + 1) % 3];
      const bool crosses_face = triangulation.is_centre(a) || triangulation.is_centre(b);
      if (!crosses_face && net.has(a, b)) barriers[t] |= static_cast<std::uint8_t>(1u << j);
    }
  }
  return std::make_shared<const SurfaceTrack>(
      triangulation.positions(mesh.points()),
      std::vector<VertexTriple>(triangles.begin(), triangles.end()), barriers);
}

void hold(MeshTracks& result, std::size_t vertex) {
  result.place[vertex] = VertexPlace::corner;
  result.track[vertex] = kNone;
  result.patch[vertex] = kNone;
}

void add_runs(const Mesh& mesh, const EdgeNet& net, const Topology& topology, MeshTracks& result) {
  for (Chain& chain : cut_into_chains(net, topology.corners)) {
    const auto r = static_cast<std::uint32_t>(result.runs.size());
    MeshTracks::Run& run = result.runs.emplace_back();
    run.vertices = std::move(chain.vertices);
    run.closed = chain.closed;
    std::vector<Vec3> points;
    points.reserve(run.vertices.size());
    for (const Index v : run.vertices) points.push_back(mesh.points()[v]);
    run.straight = !run.closed && is_straight(points);
    const auto track = std::make_shared<const CurveTrack>(
        std::move(points), run.closed ? CurveTrack::Shape::closed : CurveTrack::Shape::open);
    result.tracks.push_back(track);
    const std::size_t inner = run.closed ? 0 : 1;
    for (std::size_t k = inner; k + inner < run.vertices.size(); ++k) {
      const Index v = run.vertices[k];
      result.place[v] = VertexPlace::run;
      result.track[v] = r;
      result.start[v] = track->at(k);
    }
  }
}

/// Numbers the patches by their least triangles.
/// @return  per triangle, the number of its patch
std::vector<std::uint32_t> number_patches(const SurfaceTrack& surface, std::size_t& count) {
  std::vector<std::uint32_t> numbers(surface.triangles());
  count = 0;
  for (std::uint32_t t = 0; t < numbers.size(); ++t) {
    const std::uint32_t first = surface.patch(t);
    numbers[t] = first == t ? static_cast<std::uint32_t>(count++) : numbers[first];
  }
  return numbers;
}

void find_flat_patches(const Mesh& mesh, const SurfaceTrack& surface,
                       std::span<const std::uint32_t> patch_of_triangle,
                       std::vector<MeshTracks::Patch>& patches) {
  std::vector<std::vector<Index>> vertices(patches.size());
  for (std::uint32_t t = 0; t < surface.triangles(); ++t) {
    for (const Index v : surface.vertices(t)) {
      if (v < mesh.point_count()) vertices[patch_of_triangle[t]].push_back(v);
    }
  }
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const auto normal = common_plane(mesh.points(), vertices[k], kPlanarTolerance);
    if (normal) patches[k].normal = *normal;
  }
}

/// Puts every vertex that is still without a place and has a face onto the surface.
void place_on_surface(const Mesh& mesh, const SurfaceTrack& surface,
                      std::span<const std::uint32_t> patch_of_triangle, MeshTracks& result) {
  const auto track = static_cast<std::uint32_t>(result.tracks.size() - 1);
  std::vector<std::uint32_t> sector(mesh.point_count(), kNone);
  for (std::uint32_t t = 0; t < surface.triangles(); ++t) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Index v = surface.vertices(t)[j];
      if (v >= mesh.point_count()) continue;
      if (result.place[v] == VertexPlace::inside) {
        sector[v] = surface.sector(t, j);
        result.place[v] = VertexPlace::patch;
        result.track[v] = track;
        result.patch[v] = patch_of_triangle[t];
        result.start[v] = surface.at(t, j);
        if (result.start[v].direction.isZero(0.0)) hold(result, v);
      } else if (result.place[v] == VertexPlace::patch && surface.sector(t, j) != sector[v]) {
        hold(result, v);  // two sheets share the vertex and nothing else
      }
    }
  }
}

void add_surface(const Mesh& mesh, const Cells& faces, const EdgeNet& net, MeshTracks& result) {
  const auto surface = surface_of(mesh, faces, net);
  result.tracks.push_back(surface);
  std::size_t patches = 0;
  const std::vector<std::uint32_t> numbers = number_patches(*surface, patches);
  result.patches.resize(patches);
  find_flat_patches(mesh, *surface, numbers, result.patches);
  place_on_surface(mesh, *surface, numbers, result);
}

/// Interfaces within a volume keep their shape, and there is no track of them. Nor is there one
/// of faces without extent.
void hold_what_has_no_track(MeshType type, const EdgeNet& net, const Topology& topology,
                            MeshTracks& result) {
  for (Index v = 0; v < result.place.size(); ++v) {
    const bool is_inside = result.place[v] == VertexPlace::inside;
    if (type == MeshType::surface) {
      if (is_inside) hold(result, v);
      continue;
    }
    const bool on_inner_face =
        topology.non_manifold[v] || (topology.interface[v] && net.around(v).empty());
    if (on_inner_face || (is_inside && topology.boundary[v])) hold(result, v);
  }
}

}  // namespace

bool is_straight(Points points) {
  assert(points.size() >= 2);
  const Vec3 origin = points.front() / 2.0;  // halves, because a difference may overflow
  const Vec3 whole = points.back() / 2.0 - origin;
  const double size = whole.lpNorm<Eigen::Infinity>();
  if (!(size > 0.0)) return false;
  const double length = (whole / size).norm();
  const Vec3 direction = whole / size / length;
  double before = 0.0;
  for (const Vec3& p : points) {
    const Vec3 d = (p / 2.0 - origin) / size;
    const double along = d.dot(direction);
    if (!((d - along * direction).norm() <= kStraightTolerance * length)) return false;
    if (along < before - kStraightTolerance * length) return false;
    before = std::max(before, along);
  }
  return before <= length * (1.0 + kStraightTolerance);
}

MeshTracks find_mesh_tracks(const Mesh& mesh, const Orientation& orientation,
                            const Topology& topology) {
  const std::size_t n = mesh.point_count();
  assert(topology.used.size() == n);
  MeshTracks result;
  result.place.assign(n, VertexPlace::unused);
  result.track.assign(n, kNone);
  result.patch.assign(n, kNone);
  result.start.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    result.start[v].position = mesh.points()[v];
    if (topology.corners[v]) {
      result.place[v] = VertexPlace::corner;
    } else if (topology.used[v]) {
      result.place[v] = VertexPlace::inside;
    }
  }
  const EdgeNet net(n, topology.curves);
  add_runs(mesh, net, topology, result);
  if (orientation.type == MeshType::planar) return result;
  const bool is_volume = orientation.type == MeshType::volume;
  add_surface(mesh, is_volume ? topology.skin : mesh.cells(), net, result);
  hold_what_has_no_track(orientation.type, net, topology, result);
  return result;
}

std::shared_ptr<const SurfaceTrack> undivided_surface(const Mesh& mesh) {
  return surface_of(mesh, mesh.cells(), EdgeNet(mesh.point_count(), {}));
}

}  // namespace evenmesh
