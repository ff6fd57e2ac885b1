// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/support/triangulation.h"

namespace evenmesh::shapes {
namespace {

constexpr double kJitter = 0.3;     // of the width of a ring
constexpr double kMostSlide = 0.4;  // along the circle; below one half keeps the order

/// Ring k > 0 has 6 k vertices; ring 0 is the centre.
std::size_t ring_size(std::size_t ring) { return 6 * ring; }
Index ring_start(std::size_t ring) {
  return ring == 0 ? 0 : static_cast<Index>(1 + 3 * ring * (ring - 1));
}

Vec3 on_circle(double turns) {
  const double angle_rad = 2.0 * std::numbers::pi * turns;
  return {std::cos(angle_rad), std::sin(angle_rad), 0.0};
}

std::vector<Vec3> ring_points(std::size_t rings, Random& random) {
  const double h = 1.0 / static_cast<double>(rings);
  std::vector<Vec3> points{kJitter * h * random.in_disc()};
  for (std::size_t ring = 1; ring <= rings; ++ring) {
    const double radius = static_cast<double>(ring) / static_cast<double>(rings);
    const std::size_t size = ring_size(ring);
    for (std::size_t i = 0; i < size; ++i) {
      Vec3 p = radius * on_circle(static_cast<double>(i) / static_cast<double>(size));
      if (ring < rings) p += kJitter * h * random.in_disc();
      points.push_back(p);
    }
  }
  return points;
}

/// The six triangles around the centre; returns their outer sides.
std::vector<std::uint32_t> add_hub(Triangulation& mesh) {
  std::vector<std::uint32_t> outer;
  for (Index i = 0; i < 6; ++i) {
    outer.push_back(mesh.add_triangle(0, 1 + i, 1 + (i + 1) % 6) + 1);
    if (i > 0) mesh.link(outer[i] - 1, outer[i - 1] + 1);
  }
  mesh.link(outer.front() - 1, outer.back() + 1);
  return outer;
}

/// Fills the strip between a ring and the next with triangles, links them with each other and with
/// `inner`, the half-edges inside along the ring, and returns those along the next ring.
std::vector<std::uint32_t> add_strip(Triangulation& mesh, std::size_t ring,
                                     const std::vector<std::uint32_t>& inner) {
  const std::size_t low_size = ring_size(ring);
  const std::size_t high_size = ring_size(ring + 1);
  const auto first = static_cast<std::uint32_t>(mesh.start.size());
  std::vector<std::uint32_t> outer;
  std::uint32_t last = kNone;  // the cross side that the next triangle shares
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < low_size || j < high_size) {
    const Index low = ring_start(ring) + static_cast<Index>(i % low_size);
    const Index high = ring_start(ring + 1) + static_cast<Index>(j % high_size);
    if ((j + 1) * low_size <= (i + 1) * high_size) {  // the next one out is the nearer
      ++j;
      const Index next = ring_start(ring + 1) + static_cast<Index>(j % high_size);
      const std::uint32_t e = mesh.add_triangle(high, next, low);
      outer.push_back(e);
      mesh.link(e + 2, last);
      last = e + 1;
    } else {
      const std::uint32_t inside = inner[i++];
      const Index next = ring_start(ring) + static_cast<Index>(i % low_size);
      const std::uint32_t e = mesh.add_triangle(high, next, low);
      mesh.link(e + 1, inside);
      mesh.link(e + 2, last);
      last = e;
    }
  }
  mesh.link(first + 2, last);
  return outer;
}

void add_noise(std::vector<Vec3>& points, std::size_t rings, double noise, Random& random) {
  const double h = 1.0 / static_cast<double>(rings);
  const Index circle = ring_start(rings);
  for (Index v = 0; v < circle; ++v) {
    points[v].x() += noise * h * random.signed_unit();
    points[v].y() += noise * h * random.signed_unit();
  }
  const auto size = static_cast<double>(ring_size(rings));
  for (Index i = 0; circle + i < points.size(); ++i) {
    const double slide = kMostSlide * std::min(noise, 1.0) * random.signed_unit();
    points[circle + i] = on_circle((i + slide) / size);
  }
}

}  // namespace

Mesh disk_triangles(std::size_t vertices, std::uint64_t seed, double noise) {
  assert(vertices >= 19 && noise >= 0.0);
  // Rings 0 to k have 1 + 3 k (k + 1) vertices.
  const auto rings = static_cast<std::size_t>(
      std::lround(std::sqrt(static_cast<double>(vertices - 1) / 3.0 + 0.25) - 0.5));
  Random random(seed);
  Triangulation mesh;
  mesh.reserve(0, 6 * rings * rings);
  mesh.points = ring_points(rings, random);
  std::vector<std::uint32_t> outer = add_hub(mesh);
  for (std::size_t ring = 1; ring < rings; ++ring) outer = add_strip(mesh, ring, outer);
  make_delaunay(mesh);
  mesh.twin = {};
  Cells cells = cells_of(mesh);
  if (noise > 0.0) add_noise(mesh.points, rings, noise, random);
  return Mesh(std::move(mesh.points), std::move(cells));
}

}  // namespace evenmesh::shapes
