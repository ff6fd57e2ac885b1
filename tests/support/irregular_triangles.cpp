// SPDX-License-Identifier: MIT
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/support/triangulation.h"

namespace evenmesh::shapes {
namespace {

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
  mesh.reserve(static_cast<std::size_t>(rows + 1) * static_cast<std::size_t>(columns + 2),
               2 * static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns + 1));
  std::vector<Index> row_starts;
  std::vector<Index> interior;
  for (int row = 0; row <= rows; ++row) {
    row_starts.push_back(static_cast<Index>(mesh.points.size()));
    const auto places = row_places(row, columns);
    for (std::size_t i = 0; i < places.size(); ++i) {
      Vec3 p(places[i] / columns, static_cast<double>(row) / rows, 0.0);
      if (row > 0 && row < rows && i > 0 && i + 1 < places.size()) {
        interior.push_back(static_cast<Index>(mesh.points.size()));
        p += jitter * h * random.in_disc();
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
  Cells cells = cells_of(mesh);
  if (noise > 0.0) {
    for (const Index v : interior) {
      mesh.points[v].x() += noise * h * random.signed_unit();
      mesh.points[v].y() += noise * h * random.signed_unit();
    }
  }
  return Mesh(std::move(mesh.points), std::move(cells));
}

}  // namespace evenmesh::shapes
