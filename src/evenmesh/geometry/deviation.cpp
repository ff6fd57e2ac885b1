// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/deviation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace evenmesh {
namespace {

constexpr std::size_t kMostSamples = 7;

/// Without overflow, and exact where both are the same.
Vec3 middle(const Vec3& a, const Vec3& b) { return a + (b / 2.0 - a / 2.0); }

Vec3 centroid(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a + 2.0 * ((b / 2.0 - a / 2.0) / 3.0 + (c / 2.0 - a / 2.0) / 3.0);
}

/// A segment's vertices with the repeated one at the end; a triangle's as they are.
VertexTriple segment_first(VertexTriple t) {
  if (t[0] == t[1]) std::swap(t[1], t[2]);
  if (t[0] == t[2]) t[2] = t[1];
  return t;
}

struct Samples {
  std::array<Vec3, kMostSamples> points;
  std::size_t count = 0;

  void add(const Vec3& p) { points[count++] = p; }
};

/// @return  the samples other than corners
Samples inner_samples(Points points, const VertexTriple& triangle) {
  const auto [i, j, k] = segment_first(triangle);
  const Vec3& a = points[i];
  const Vec3& b = points[j];
  const Vec3& c = points[k];
  Samples samples;
  samples.add(middle(a, b));
  if (j != k) {
    samples.add(middle(b, c));
    samples.add(middle(c, a));
    samples.add(centroid(a, b, c));
  }
  return samples;
}

/// Finds the nearest point, starting from a triangle that is known to be near.
Bvh::Hit closest(const Bvh& tree, const Vec3& p, std::uint32_t near) {
  if (near == Bvh::kNone) return tree.closest(p);
  const Bvh::Hit known = tree.closest_on(near, p);
  const Bvh::Hit found = tree.closest(p, known.distance);
  return found.found() ? found : known;
}

/// For every vertex that a triangle has, the nearest point.
std::vector<Bvh::Hit> closest_to_vertices(Points points, std::span<const VertexTriple> triangles,
                                          const Bvh& other, Workers& workers) {
  std::vector<char> used(points.size(), 0);
  for (const VertexTriple& triangle : triangles) {
    for (const Index v : triangle) used[v] = 1;
  }
  std::vector<Bvh::Hit> hits(points.size());
  for_ranges(workers, points.size(), [&](std::size_t first, std::size_t last) {
    std::uint32_t near = Bvh::kNone;
    for (std::size_t v = first; v < last; ++v) {
      if (!used[v]) continue;
      hits[v] = closest(other, points[v], near);
      near = hits[v].triangle;
    }
  });
  return hits;
}

}  // namespace

OneSidedDeviation deviation_from(Points points, std::span<const VertexTriple> triangles,
                                 const Bvh& other, Workers& workers) {
  const std::vector<Bvh::Hit> hits = closest_to_vertices(points, triangles, other, workers);
  OneSidedDeviation result;
  result.of_triangle.assign(triangles.size(), 0.0);
  // Each mean is divided by the number of samples first, lest the sum overflow.
  std::vector<double> means(triangles.size(), 0.0);
  for_ranges(workers, triangles.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto [i, j, k] = segment_first(triangles[t]);
      double& greatest = result.of_triangle[t];
      double sum = 0.0;
      const auto count = [&](double distance) {
        greatest = std::max(greatest, distance);
        sum += distance;
      };
      const std::size_t corners = j == k ? 2 : 3;
      count(hits[i].distance);
      count(hits[j].distance);
      if (corners == 3) count(hits[k].distance);
      const Samples samples = inner_samples(points, triangles[t]);
      for (std::size_t s = 0; s < samples.count; ++s) {
        count(closest(other, samples.points[s], hits[i].triangle).distance);
      }
      means[t] = sum / static_cast<double>(corners + samples.count);
    }
  });
  for (const double d : result.of_triangle) result.greatest = std::max(result.greatest, d);
  const double n = static_cast<double>(std::max<std::size_t>(1, triangles.size()));
  result.mean = sum_over_ranges(workers, means.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t t = first; t < last; ++t) sum += means[t] / n;
    return sum;
  });
  return result;
}

Deviation deviation_between(Points a_points, std::span<const VertexTriple> a_triangles,
                            Points b_points, std::span<const VertexTriple> b_triangles,
                            Workers& workers) {
  return {deviation_from(a_points, a_triangles, Bvh(b_points, b_triangles), workers),
          deviation_from(b_points, b_triangles, Bvh(a_points, a_triangles), workers)};
}

}  // namespace evenmesh
