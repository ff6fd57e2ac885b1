// SPDX-License-Identifier: MIT
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh::shapes {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// Half-edge e = 3 t + i runs from corner i of triangle t to the next one.
std::uint32_t next(std::uint32_t e) { return e % 3 == 2 ? e - 2 : e + 1; }
std::uint32_t previous(std::uint32_t e) { return e % 3 == 0 ? e + 2 : e - 1; }

struct Triangulation {
  std::vector<Vec3> points;
  std::vector<Index> start;         // per half-edge: the vertex it leaves
  std::vector<std::uint32_t> twin;  // per half-edge: the same side seen from the other triangle

  void link(std::uint32_t e, std::uint32_t f) {
    if (e != kNone) twin[e] = f;
    if (f != kNone) twin[f] = e;
  }
  std::uint32_t add_triangle(Index a, Index b, Index c) {
    const auto e = static_cast<std::uint32_t>(start.size());
    start.insert(start.end(), {a, b, c});
    twin.insert(twin.end(), 3, kNone);
    return e;
  }
};

double doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
}

/// Where the vertices of a row lie before they are displaced, in units of the spacing.
std::vector<double> row_places(int row, int columns) {
  std::vector<double> places;
  places.push_back(0.0);
  const double shift = row % 2 == 0 ? 0.0 : 0.5;
  for (int i = row % 2 == 0 ? 1 : 0; i < columns; ++i) places.push_back(i + shift);
  places.push_back(columns);
  return places;
}

/// Fills the strip between two rows with triangles, links them with each other and with `below`,
/// the half-edges of the strip beneath along the lower row, and returns those along the upper row.
std::vector<std::uint32_t> add_strip(Triangulation& mesh, int row, int columns, Index lower,
                                     Index upper, const std::vector<std::uint32_t>& below) {
  const std::vector<double> a = row_places(row, columns);
  const std::vector<double> b = row_places(row + 1, columns);
  std::vector<std::uint32_t> above;
  std::uint32_t last = kNone;  // the cross side that the next triangle shares
  std::size_t i = 0;
  std::size_t j = 0;
  while (i + 1 < a.size() || j + 1 < b.size()) {
    bool advance_lower = j + 1 == b.size();
    if (i + 1 < a.size() && j + 1 < b.size()) {
      advance_lower = a[i + 1] < b[j + 1] || (a[i + 1] == b[j + 1] && row % 2 == 0);
    }
    const auto low = lower + static_cast<Index>(i);
    const auto high = upper + static_cast<Index>(j);
    if (advance_lower) {
      const std::uint32_t e = mesh.add_triangle(low, low + 1, high);
      if (!below.empty()) mesh.link(e, below[i]);
      mesh.link(e + 2, last);
      last = e + 1;
      ++i;
    } else {
      const std::uint32_t e = mesh.add_triangle(low, high + 1, high);
      above.push_back(e + 1);
      mesh.link(e + 2, last);
      last = e;
      ++j;
    }
  }
  return above;
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

}  // namespace

Mesh irregular_triangles(std::size_t vertices, double jitter, std::uint64_t seed, double noise) {
  assert(vertices >= 9 && jitter >= 0.0 && jitter <= 0.4);
  const double flatness = std::sqrt(3.0) / 2.0;  // height of an equilateral triangle of side 1
  const int columns = std::max(
      2, static_cast<int>(std::lround(std::sqrt(static_cast<double>(vertices) * flatness))) - 1);
  const double h = 1.0 / columns;
  const int rows = std::max(2, static_cast<int>(std::lround(columns / flatness)));

  Random random(seed);
  Triangulation mesh;
  mesh.points.reserve(static_cast<std::size_t>(rows + 1) * static_cast<std::size_t>(columns + 2));
  mesh.start.reserve(6 * static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns + 1));
  mesh.twin.reserve(mesh.start.capacity());
  std::vector<Index> row_starts;
  std::vector<Index> interior;
  for (int row = 0; row <= rows; ++row) {
    row_starts.push_back(static_cast<Index>(mesh.points.size()));
    const auto places = row_places(row, columns);
    for (std::size_t i = 0; i < places.size(); ++i) {
      Vec3 p(places[i] / columns, static_cast<double>(row) / rows, 0.0);
      if (row > 0 && row < rows && i > 0 && i + 1 < places.size()) {
        interior.push_back(static_cast<Index>(mesh.points.size()));
        double u = 0.0;
        double v = 0.0;
        do {  // uniform in the unit disc
          u = random.signed_unit();
          v = random.signed_unit();
        } while (u * u + v * v > 1.0);
        p += Vec3(jitter * h * u, jitter * h * v, 0.0);
      }
      mesh.points.push_back(p);
    }
  }
  std::vector<std::uint32_t> below;
  for (int row = 0; row < rows; ++row) {
    const auto r = static_cast<std::size_t>(row);
    below = add_strip(mesh, row, columns, row_starts[r], row_starts[r + 1], below);
  }
  make_delaunay(mesh);
  mesh.twin = {};

  Cells cells;
  cells.reserve(mesh.start.size() / 3, mesh.start.size());
  for (std::size_t e = 0; e < mesh.start.size(); e += 3) {
    cells.add(CellKind::triangle, std::span(mesh.start).subspan(e, 3));
  }
  if (noise > 0.0) {
    for (const Index v : interior) {
      mesh.points[v].x() += noise * h * random.signed_unit();
      mesh.points[v].y() += noise * h * random.signed_unit();
    }
  }
  return Mesh(std::move(mesh.points), std::move(cells));
}

}  // namespace evenmesh::shapes
