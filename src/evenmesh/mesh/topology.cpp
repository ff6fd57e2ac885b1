// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/curves.h"
#include "evenmesh/mesh/extent.h"
#include "evenmesh/mesh/sides.h"
#include "evenmesh/mesh/twins.h"

namespace evenmesh {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

void check(const TopologyOptions& options) {
  if (options.feature_angle > 0.0 && options.feature_angle < 180.0) return;
  throw InvalidOption(fmt::format(
      "a feature angle of {} degrees is not between 0 and 180 (45 is usual; 179 finds none)",
      options.feature_angle));
}

void mark(std::vector<char>& flags, std::span<const Index> vertices) {
  for (const Index v : vertices) flags[v] = 1;
}

/// Is there nothing beyond the side? A cell that is listed twice is no neighbour of itself.
bool is_border(const Side& side, Twins& twins) {
  if (side.cells == 1) return true;
  return side.cells == 2 && twins.are_twins(side.uses.front().cell, side.uses.back().cell);
}

bool is_between_groups(const Side& side, const Cells& cells) {
  return side.cells == 2 &&
         cells.group(side.uses.front().cell) != cells.group(side.uses.back().cell);
}

/// Two cells at a side: are they bent against each other by more than the angle of the cosine?
bool is_bent(const Side& side, std::span<const Vec3> normals, double cosine) {
  const Vec3& a = normals[side.uses[0].cell];
  const Vec3& b = normals[side.uses[1].cell];
  if (a.isZero(0.0) || b.isZero(0.0)) return false;
  const bool wound_alike = side.uses[0].forward != side.uses[1].forward;
  // An angle of exactly the limit is not beyond it, whatever rounding says.
  constexpr double kRounding = 1e-12;
  return (wound_alike ? 1.0 : -1.0) * a.dot(b) < cosine - kRounding;
}

/// The edges of a surface mesh.
/// @param normals  unit or zero, per cell; empty if nothing can be bent
std::vector<VertexPair> mark_edges(const Mesh& mesh, std::span<const Vec3> normals,
                                   double feature_angle_rad, Topology& result) {
  const Cells& cells = mesh.cells();
  const double cosine = std::cos(feature_angle_rad);
  std::vector<VertexPair> curves;
  Twins twins(cells);
  const auto visit = [&](const Side& side) {
    const VertexPair edge{side.first, side.uses[0].second};
    bool on_curve = false;
    const auto count = [&](bool is_one, std::size_t& sides, std::vector<char>& flags) {
      if (!is_one) return;
      ++sides;
      mark(flags, edge);
      on_curve = true;
    };
    const bool border = is_border(side, twins);
    count(border, result.boundary_sides, result.boundary);
    count(side.cells > 2, result.non_manifold_sides, result.non_manifold);
    const bool bent =
        !border && !normals.empty() && side.is_shared_by_two() && is_bent(side, normals, cosine);
    count(bent, result.feature_sides, result.features);
    count(is_between_groups(side, cells), result.interface_sides, result.interface);
    if (on_curve) curves.push_back(edge);
  };
  for_each_side(cells, mesh.point_count(), 2, visit,
                [&](std::uint32_t cell) { twins.expect(cell); });
  return curves;
}

/// The faces of a volume mesh.
/// @return  those that only one cell has, as cells wound as that cell has them, in its group
Cells mark_faces(const Mesh& mesh, Topology& result) {
  const Cells& cells = mesh.cells();
  Cells skin;
  Twins twins(cells);
  for_each_side(cells, mesh.point_count(), 3, [&](const Side& side) {
    const SideUse& use = side.uses.front();
    const FaceVertices face = face_vertices(cells, use.cell, use.face);
    if (is_border(side, twins)) {
      ++result.boundary_sides;
      mark(result.boundary, face.span());
      skin.add(face.count == 3 ? CellKind::triangle : CellKind::quad, face.span(),
               cells.group(use.cell));
    } else if (side.cells > 2) {
      ++result.non_manifold_sides;
      mark(result.non_manifold, face.span());
    } else if (is_between_groups(side, cells)) {
      ++result.interface_sides;
      mark(result.interface, face.span());
    }
  });
  return skin;
}

/// Marks the features of the skin and returns its curves: features and where interfaces come out.
std::vector<VertexPair> mark_skin_edges(const Mesh& mesh, const Cells& skin,
                                        double feature_angle_rad, Topology& result) {
  std::vector<Vec3> normals(skin.size());
  for (std::size_t face = 0; face < skin.size(); ++face) {
    normals[face] = unit_normal(mesh.points(), skin.vertices(face));
  }
  const double cosine = std::cos(feature_angle_rad);
  std::vector<VertexPair> curves;
  for_each_side(skin, mesh.point_count(), 2, [&](const Side& side) {
    const VertexPair edge{side.first, side.uses[0].second};
    const bool crossing = side.cells > 2;
    const bool feature = crossing || (side.is_shared_by_two() && is_bent(side, normals, cosine));
    if (feature) {
      ++result.feature_sides;
      mark(result.features, edge);
    }
    if (feature || is_between_groups(side, skin) || side.cells == 1) curves.push_back(edge);
  });
  return curves;
}

/// Surface cells inside a volume (a membrane, a crack, a load) hold their vertices.
void mark_inner_surface_cells(const Cells& cells, Topology& result) {
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (traits(cells.kind(cell)).dimension != 2) continue;
    const auto vertices = cells.vertices(cell);
    const bool on_skin = std::all_of(vertices.begin(), vertices.end(),
                                     [&](Index v) { return result.boundary[v] != 0; });
    if (on_skin) continue;
    ++result.interface_sides;
    mark(result.interface, vertices);
  }
}

/// Pieces connected through shared vertices.
std::size_t count_components(const Cells& cells, const std::vector<char>& used) {
  std::vector<Index> parent(used.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&](Index v) {
    while (parent[v] != v) {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  };
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const auto vertices = cells.vertices(cell);
    Index first = root(vertices[0]);
    for (const Index v : vertices.subspan(1)) {
      const Index other = root(v);
      const auto [low, high] = std::minmax(first, other);
      parent[high] = low;
      first = low;
    }
  }
  std::size_t count = 0;
  for (std::size_t v = 0; v < used.size(); ++v) count += used[v] && parent[v] == v;
  return count;
}

}  // namespace

Topology find_topology(const Mesh& mesh, const Orientation& orientation,
                       const TopologyOptions& options) {
  check(options);
  const Cells& cells = mesh.cells();
  Topology result;
  for (auto* flags : {&result.boundary, &result.non_manifold, &result.features, &result.interface,
                      &result.corners, &result.used}) {
    flags->assign(mesh.point_count(), 0);
  }
  mark(result.used, cells.corners());
  result.components = count_components(cells, result.used);

  const double angle_rad = radians(options.feature_angle);
  if (orientation.type == MeshType::volume) {
    result.skin = mark_faces(mesh, result);
    result.curves = mark_skin_edges(mesh, result.skin, angle_rad, result);
    mark_inner_surface_cells(cells, result);
  } else {
    result.curves = mark_edges(mesh, orientation.normals, angle_rad, result);
  }
  mark_corners(mesh.points(), result.curves, angle_rad, result.corners);
  return result;
}

}  // namespace evenmesh
