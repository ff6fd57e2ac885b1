// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh::shapes {
namespace {

template <class Change>
Mesh with_points(const Mesh& mesh, Change change) {
  Mesh result = mesh;
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  for (Vec3& p : points) p = change(p);
  result.set_points(std::move(points));
  return result;
}

/// The vertices of a cell in an order that winds the other way.
std::vector<Index> wound_back(CellKind kind, std::span<const Index> vertices) {
  std::vector<Index> v(vertices.begin(), vertices.end());
  switch (kind) {
    case CellKind::triangle:
    case CellKind::quad:
    case CellKind::polygon:
      std::reverse(v.begin() + 1, v.end());
      break;
    case CellKind::tet:
      std::swap(v[1], v[2]);
      break;
    case CellKind::pyramid:
      std::swap(v[1], v[3]);
      break;
    case CellKind::hex:
    case CellKind::wedge:  // bottom becomes top
      std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
      break;
  }
  return v;
}

std::vector<Vec3> copy_of_points(const Mesh& mesh) {
  return {mesh.points().begin(), mesh.points().end()};
}

}  // namespace

Mesh shuffled(const Mesh& mesh, std::uint64_t seed, Renumbering* renumbering) {
  Random random(seed);
  std::vector<Index> new_vertex(mesh.point_count());
  std::iota(new_vertex.begin(), new_vertex.end(), Index{0});
  random.shuffle(new_vertex);
  std::vector<std::size_t> order(mesh.cells().size());  // order[new cell] = old cell
  std::iota(order.begin(), order.end(), std::size_t{0});
  random.shuffle(order);

  std::vector<Vec3> points(mesh.point_count());
  for (std::size_t v = 0; v < points.size(); ++v) points[new_vertex[v]] = mesh.points()[v];
  Cells cells;
  cells.reserve(order.size(), mesh.cells().corners().size());
  std::vector<Index> vertices;
  for (const std::size_t old : order) {
    vertices.clear();
    for (const Index v : mesh.cells().vertices(old)) vertices.push_back(new_vertex[v]);
    cells.add(mesh.cells().kind(old), vertices, mesh.cells().group(old));
  }
  if (renumbering != nullptr) {
    renumbering->cells.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) renumbering->cells[order[i]] = i;
    renumbering->vertices = std::move(new_vertex);
  }
  return Mesh(std::move(points), std::move(cells));
}

Mesh rotated(const Mesh& mesh, const Vec3& axis, double angle_rad) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
  return with_points(mesh, [&](const Vec3& p) -> Vec3 { return rotation * p; });
}

Mesh moved(const Mesh& mesh, const Vec3& by) {
  return with_points(mesh, [&](const Vec3& p) -> Vec3 { return p + by; });
}

Mesh scaled(const Mesh& mesh, double factor) {
  return with_points(mesh, [&](const Vec3& p) -> Vec3 { return factor * p; });
}

Mesh reversed(const Mesh& mesh, const std::function<bool(std::size_t)>& chosen) {
  const Cells& old = mesh.cells();
  Cells cells;
  cells.reserve(old.size(), old.corners().size());
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (chosen(i)) {
      cells.add(old.kind(i), wound_back(old.kind(i), old.vertices(i)), old.group(i));
    } else {
      cells.add(old.kind(i), old.vertices(i), old.group(i));
    }
  }
  return Mesh(copy_of_points(mesh), std::move(cells));
}

Mesh grouped(const Mesh& mesh, const std::function<std::uint32_t(std::size_t)>& group) {
  const Cells& old = mesh.cells();
  Cells cells;
  cells.reserve(old.size(), old.corners().size());
  for (std::size_t i = 0; i < old.size(); ++i) {
    cells.add(old.kind(i), old.vertices(i), group(i));
  }
  return Mesh(copy_of_points(mesh), std::move(cells));
}

std::vector<Named> zoo() {
  const auto third = [](std::size_t cell) { return cell % 3 == 0; };
  return {{"fig5", fig5(0.2, -0.1)},
          {"quad_grid", quad_grid(5, 2.0, 0.2)},
          {"triangle_grid", triangle_grid(5, 1.0, 0.2)},
          {"irregular_triangles", irregular_triangles(200)},
          {"tangled_triangles", irregular_triangles(200, 0.3, 1, 0.8)},
          {"wound_both_ways", reversed(triangle_grid(6), third)},
          {"hexagons", hexagons(4)},
          {"bowtie_vertex", bowtie_vertex()},
          {"two_components", two_components(2)},
          {"sphere_triangles", sphere_triangles(2)},
          {"cube_surface", cube_surface(3)},
          {"cylinder_side", cylinder_side(12, 3)},
          {"moebius_strip", moebius_strip(12)},
          {"fan_of_three", fan_of_three()},
          {"mixed_surface", mixed_surface(5)},
          {"tet_grid", tet_grid(2)},
          {"hex_grid", hex_grid(3, 0.2)},
          {"wedge_grid", wedge_grid(2)},
          {"pyramid_grid", pyramid_grid(2)}};
}

}  // namespace evenmesh::shapes
