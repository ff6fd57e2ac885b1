// SPDX-License-Identifier: MIT
#include "tests/support/triangulation.h"

#include <span>

namespace evenmesh::shapes {
namespace {

std::uint32_t next(std::uint32_t e) { return e % 3 == 2 ? e - 2 : e + 1; }
std::uint32_t previous(std::uint32_t e) { return e % 3 == 0 ? e + 2 : e - 1; }

double doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
}

/// True when the fourth point lies inside the circle through the other three by more than rounding
/// can make up, so that flipping ends.
bool in_circle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 p = a - d;
  const Vec3 q = b - d;
  const Vec3 r = c - d;
  const double pp = p.head<2>().squaredNorm();
  const double qq = q.head<2>().squaredNorm();
  const double rr = r.head<2>().squaredNorm();
  const double det = pp * (q.x() * r.y() - r.x() * q.y()) + qq * (r.x() * p.y() - p.x() * r.y()) +
                     rr * (p.x() * q.y() - q.x() * p.y());
  const double size = pp + qq + rr;
  return det > 1e-10 * size * size;
}

/// Flips the side if that makes it Delaunay. Its two triangles (a, b, c) and (b, a, d) become
/// (d, b, c) and (c, a, d), so that half-edge e now runs c -> d.
bool flip_if_better(Triangulation& mesh, std::uint32_t e) {
  const std::uint32_t f = mesh.twin[e];
  if (f == kNone) return false;
  const Index a = mesh.start[e];
  const Index b = mesh.start[f];
  const Index c = mesh.start[previous(e)];
  const Index d = mesh.start[previous(f)];
  const auto& x = mesh.points;
  if (!in_circle(x[a], x[b], x[c], x[d])) return false;
  if (doubled_area(x[d], x[b], x[c]) <= 0.0 || doubled_area(x[c], x[a], x[d]) <= 0.0) return false;

  const std::uint32_t outer_of_e = mesh.twin[previous(e)];  // side c a
  const std::uint32_t outer_of_f = mesh.twin[previous(f)];  // side d b
  mesh.start[e] = d;
  mesh.start[f] = c;
  mesh.link(e, outer_of_f);
  mesh.twin[e] = outer_of_f;
  mesh.link(f, outer_of_e);
  mesh.twin[f] = outer_of_e;
  mesh.link(previous(e), previous(f));
  return true;
}

}  // namespace

void Triangulation::reserve(std::size_t vertices, std::size_t triangles) {
  points.reserve(vertices);
  start.reserve(3 * triangles);
  twin.reserve(3 * triangles);
}

std::uint32_t Triangulation::add_triangle(Index a, Index b, Index c) {
  const auto e = static_cast<std::uint32_t>(start.size());
  start.insert(start.end(), {a, b, c});
  twin.insert(twin.end(), 3, kNone);
  return e;
}

void make_delaunay(Triangulation& mesh) {
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t first = 0; first < mesh.start.size(); ++first) {
    waiting.push_back(first);
    while (!waiting.empty()) {
      const std::uint32_t e = waiting.back();
      waiting.pop_back();
      const std::uint32_t f = mesh.twin[e];
      if (!flip_if_better(mesh, e)) continue;
      for (const std::uint32_t side : {e, next(e), f, next(f)}) waiting.push_back(side);
    }
  }
}

Cells cells_of(const Triangulation& mesh) {
  Cells cells;
  cells.reserve(mesh.start.size() / 3, mesh.start.size());
  for (std::size_t e = 0; e < mesh.start.size(); e += 3) {
    cells.add(CellKind::triangle, std::span(mesh.start).subspan(e, 3));
  }
  return cells;
}

}  // namespace evenmesh::shapes
