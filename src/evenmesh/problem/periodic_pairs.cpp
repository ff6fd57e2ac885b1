// SPDX-License-Identifier: MIT
#include "evenmesh/problem/periodic_pairs.h"

#include <algorithm>
#include <limits>

#include "evenmesh/mesh/extent.h"

namespace evenmesh {
namespace {

constexpr Index kNone = ~Index{0};

// Vertices of one side sorted along the axis in which they are spread the most.
class Side {
 public:
  Side(Points points, std::span<const Index> vertices) : points_(points) {
    if (vertices.empty()) return;
    const Extent extent = extent_of(points, vertices);
    (extent.high - extent.low).maxCoeff(&axis_);
    sorted_.assign(vertices.begin(), vertices.end());
    std::sort(sorted_.begin(), sorted_.end(), [&](Index a, Index b) {
      const double x = points[a][axis_];
      const double y = points[b][axis_];
      return x != y ? x < y : a < b;
    });
  }

  struct Near {
    Index vertex = kNone;
    double distance = std::numeric_limits<double>::infinity();
  };

  /// The nearest vertex at most that far away in the axis.
  Near nearest(const Vec3& p, double within) const {
    Near best;
    const auto begin =
        std::lower_bound(sorted_.begin(), sorted_.end(), p[axis_] - within,
                         [&](Index v, double limit) { return points_[v][axis_] < limit; });
    for (auto v = begin; v != sorted_.end() && points_[*v][axis_] <= p[axis_] + within; ++v) {
      const double distance = (points_[*v] - p).norm();
      if (distance < best.distance || (distance == best.distance && *v < best.vertex)) {
        best = {*v, distance};
      }
    }
    return best;
  }

 private:
  Points points_;
  std::vector<Index> sorted_;
  Eigen::Index axis_ = 0;
};

}  // namespace

PeriodicMatch match_periodic(Points points, std::span<const Index> first,
                             std::span<const Index> second, const Vec3& translation,
                             double tolerance) {
  PeriodicMatch match;
  const auto miss = [&](Index vertex, const Side& others, const Vec3& image) {
    if (match.unmatched++ > 0) return;
    match.example = vertex;
    match.nearest = others.nearest(image, std::numeric_limits<double>::infinity()).distance;
  };
  const Side images(points, second);
  std::vector<char> found(points.size(), 0);
  for (const Index v : first) {
    const Vec3 image = points[v] + translation;
    const Side::Near near = images.nearest(image, tolerance);
    if (near.distance > tolerance || found[near.vertex]) {
      miss(v, images, image);
      continue;
    }
    found[near.vertex] = 1;
    if (near.vertex != v) match.pairs.emplace_back(v, near.vertex);
  }
  const Side originals(points, first);
  for (const Index v : second) {
    if (!found[v]) miss(v, originals, points[v] - translation);
  }
  std::sort(match.pairs.begin(), match.pairs.end());
  return match;
}

}  // namespace evenmesh
