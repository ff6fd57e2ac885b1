// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/surface_track.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "evenmesh/geometry/area.h"
#include "evenmesh/geometry/ball.h"
#include "evenmesh/geometry/parity_sets.h"

namespace evenmesh {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr std::uint8_t kOwnNormalTurned = 1u << 3u;

std::size_t next(std::size_t corner) { return corner == 2 ? 0 : corner + 1; }

/// The triangles seen so far, in the order in which they were met. Few are searched one by one,
/// many through a hash table.
class Seen {
 public:
  void start(std::uint32_t first) {
    list_.clear();
    hashed_ = 0;
    list_.push_back(first);
  }

  std::size_t size() const { return list_.size(); }
  std::uint32_t operator[](std::size_t i) const { return list_[i]; }

  /// False if it was there.
  bool add(std::uint32_t triangle) {
    if (list_.size() < kFew) {
      if (std::find(list_.begin(), list_.end(), triangle) != list_.end()) return false;
      list_.push_back(triangle);
      return true;
    }
    if (hashed_ == 0 || 2 * list_.size() > hashed_) rehash();
    if (!insert(triangle)) return false;
    list_.push_back(triangle);
    return true;
  }

 private:
  static constexpr std::size_t kFew = 32;

  bool insert(std::uint32_t triangle) {
    const std::size_t mask = hashed_ - 1;
    std::size_t slot = (triangle * std::size_t{0x9e3779b1u} >> 7u) & mask;
    for (; table_[slot] != SurfaceTrack::kNone; slot = (slot + 1) & mask) {
      if (table_[slot] == triangle) return false;
    }
    table_[slot] = triangle;
    return true;
  }

  void rehash() {
    hashed_ = std::max(4 * kFew, 2 * hashed_);
    table_.assign(hashed_, SurfaceTrack::kNone);
    for (const std::uint32_t triangle : list_) insert(triangle);
  }

  std::vector<std::uint32_t> list_;
  std::vector<std::uint32_t> table_;
  std::size_t hashed_ = 0;  // how much of the table is in use, a power of two; 0: none
};

/// A triangle's edge, for the search for those that are the same.
struct EdgeUse {
  Index second;  // its greater vertex
  std::uint32_t triangle;
  std::uint8_t edge;
};

}  // namespace

SurfaceTrack::SurfaceTrack(std::vector<Vec3> points, std::vector<VertexTriple> triangles,
                           std::span<const std::uint8_t> barriers)
    : scale_(unit_scale(points)), points_(std::move(points)), triangles_(std::move(triangles)) {
  assert(barriers.empty() || barriers.size() == triangles_.size());
  assert(triangles_.size() < kNone / 3);
  for (Vec3& p : points_) p *= scale_.to_unit;
  find_neighbours(barriers);
  find_patches();
  find_flat_patches();
  find_normals();
}

void SurfaceTrack::find_neighbours(std::span<const std::uint8_t> barriers) {
  neighbours_.assign(triangles_.size(), {kNone, kNone, kNone});
  // Edges by their lesser vertex: a counting sort.
  std::vector<std::uint32_t> ends(points_.size() + 1, 0);
  const auto for_each_edge = [&](const auto& body) {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (std::uint8_t j = 0; j < 3; ++j) {
        const auto [a, b] = std::minmax(triangles_[t][j], triangles_[t][next(j)]);
        if (a != b) body(a, EdgeUse{b, t, j});
      }
    }
  };
  for_each_edge([&](Index first, const EdgeUse&) { ++ends[first + 1]; });
  for (std::size_t v = 1; v < ends.size(); ++v) ends[v] += ends[v - 1];
  std::vector<EdgeUse> uses(ends.back());
  for_each_edge([&](Index first, const EdgeUse& use) { uses[ends[first]++] = use; });

  const auto is_barrier = [&](const EdgeUse& use) {
    return !barriers.empty() && ((barriers[use.triangle] >> use.edge) & 1u) != 0;
  };
  std::size_t begin = 0;
  for (std::size_t v = 0; v < points_.size(); ++v) {
    const std::span<EdgeUse> around(uses.data() + begin, uses.data() + ends[v]);
    begin = ends[v];
    std::stable_sort(around.begin(), around.end(),
                     [](const EdgeUse& a, const EdgeUse& b) { return a.second < b.second; });
    for (std::size_t i = 0; i < around.size();) {
      std::size_t end = i + 1;
      while (end < around.size() && around[end].second == around[i].second) ++end;
      const EdgeUse& a = around[i];
      const EdgeUse& b = around[end - 1];
      if (end - i == 2 && a.triangle != b.triangle && !is_barrier(a) && !is_barrier(b)) {
        neighbours_[a.triangle][a.edge] = b.triangle;
        neighbours_[b.triangle][b.edge] = a.triangle;
      }
      i = end;
    }
  }
}

bool SurfaceTrack::are_wound_alike(std::uint32_t triangle, std::size_t edge,
                                   std::uint32_t other) const {
  const Index from = triangles_[triangle][edge];
  const Index to = triangles_[triangle][next(edge)];
  for (std::size_t j = 0; j < 3; ++j) {
    if (triangles_[other][j] == to && triangles_[other][next(j)] == from) return true;
  }
  return false;
}

void SurfaceTrack::find_patches() {
  ParitySets sets(triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::uint32_t other = neighbours_[t][j];
      if (other != kNone && other > t) sets.unite(t, other, !are_wound_alike(t, j, other));
    }
  }
  patches_.resize(triangles_.size());
  turned_.resize(triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const auto [root, reversed] = sets.find(t);
    patches_[t] = root;
    turned_[t] = reversed ? kOwnNormalTurned : 0;
  }
}

Vec3 SurfaceTrack::area_vector(std::uint32_t triangle) const {
  const auto [a, b, c] = triangles_[triangle];
  const std::array corners{points_[a], points_[b], points_[c]};
  const Vec3 area = evenmesh::area_vector(corners);
  const double longest = std::sqrt(
      std::max({(corners[1] - corners[0]).squaredNorm(), (corners[2] - corners[1]).squaredNorm(),
                (corners[0] - corners[2]).squaredNorm()}));
  // A height that rounding of the coordinates can make is none.
  const double least_height = 1e-13 * longest + kEpsilon * corners[0].lpNorm<Eigen::Infinity>();
  return area.norm() > least_height * longest ? area : Vec3(Vec3::Zero());
}

void SurfaceTrack::find_normals() {
  const auto count = static_cast<std::uint32_t>(3 * triangles_.size());
  // Corners are compared among themselves and not by what the patch says, because a patch with one
  // side only contradicts itself somewhere and a vertex's surroundings do not.
  ParitySets sets(count);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      const std::uint32_t other = neighbours_[t][j];
      if (other == kNone || other < t) continue;
      const bool opposite = !are_wound_alike(t, j, other);
      for (const std::uint32_t corner : {j, static_cast<std::uint32_t>(next(j))}) {
        for (std::uint32_t k = 0; k < 3; ++k) {
          if (triangles_[other][k] == triangles_[t][corner]) {
            sets.unite(3 * t + corner, 3 * other + k, opposite);
          }
        }
      }
    }
  }
  sectors_.resize(triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const bool patch_turned = (turned_[t] & kOwnNormalTurned) != 0;
    const Vec3 area = area_vector(t);
    for (std::uint32_t j = 0; j < 3; ++j) {
      const auto [root, reversed] = sets.find(3 * t + j);
      // The root is the least corner of its sector, so it has been met before or is this one.
      if (root == 3 * t + j) {
        sectors_[t][j] = static_cast<std::uint32_t>(normals_.size());
        normals_.emplace_back(Vec3::Zero());
      } else {
        sectors_[t][j] = sectors_[root / 3][root % 3];
      }
      normals_[sectors_[t][j]] += reversed ? Vec3(-area) : area;
      if (reversed != patch_turned) turned_[t] |= static_cast<std::uint8_t>(1u << j);
    }
  }
  for (Vec3& n : normals_) n = n.stableNormalized();
}

ClosestPoint SurfaceTrack::closest(std::uint32_t triangle, const Vec3& p) const {
  const auto [a, b, c] = triangles_[triangle];
  return closest_on_triangle(points_[a], points_[b], points_[c], p);
}

Vec3 SurfaceTrack::normal(std::uint32_t triangle, const Vec3& weights) const {
  constexpr double kLeastLength = 1e-3;  // of a blend of unit vectors that tells a direction
  const std::uint8_t turned = turned_[triangle];
  Vec3 blend = Vec3::Zero();
  for (std::size_t j = 0; j < 3; ++j) {
    const double sign = ((turned >> j) & 1u) != 0 ? -1.0 : 1.0;
    blend += sign * weights[static_cast<Eigen::Index>(j)] * normals_[sectors_[triangle][j]];
  }
  const double length = blend.norm();
  Vec3 own = area_vector(triangle).stableNormalized();
  if (own.isZero(0.0)) return length > 0.0 ? Vec3(blend / length) : own;
  if ((turned & kOwnNormalTurned) != 0) own = -own;
  return length > kLeastLength && blend.dot(own) > 0.0 ? Vec3(blend / length) : own;
}

TrackPoint SurfaceTrack::at(std::uint32_t triangle, std::size_t corner) const {
  Vec3 weights = Vec3::Zero();
  weights[static_cast<Eigen::Index>(corner)] = 1.0;
  return {position(triangles_[triangle][corner]), normal(triangle, weights), triangle};
}

TrackPoint SurfaceTrack::nearest(const Vec3& p, const TrackPoint& from) const {
  assert(from.piece < triangles_.size());
  thread_local Seen seen;
  const Vec3 x = scale_.to_unit * p;
  const Ball ball(x, scale_.to_unit * from.position);
  seen.start(from.piece);
  ClosestPoint best;
  std::uint32_t piece = kNone;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const std::uint32_t triangle = seen[i];
    const ClosestPoint found = closest(triangle, x);
    if (piece == kNone || found.squared_distance < best.squared_distance ||
        (found.squared_distance == best.squared_distance && triangle < piece)) {
      best = found;
      piece = triangle;
    }
    for (std::size_t j = 0; j < 3; ++j) {
      const std::uint32_t other = neighbours_[triangle][j];
      if (other == kNone) continue;
      const Vec3& a = points_[triangles_[triangle][j]];
      const Vec3& b = points_[triangles_[triangle][next(j)]];
      if (ball.contains(closest_on_segment(a, b, x).squared_distance)) seen.add(other);
    }
  }
  return {scale_.from_unit * best.position, normal(piece, best.weights), piece};
}

Vec3 SurfaceTrack::curvature(const TrackPoint& /*point*/, const Vec3& /*t*/) const {
  return Vec3::Zero();
}

void SurfaceTrack::find_flat_patches() {
  flat_.assign(triangles_.size(), 1);
  double size = 0.0;
  for (const Vec3& p : points_) size = std::max(size, (p - points_[0]).norm());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const std::uint32_t first = patches_[t];
    const Vec3 normal = area_vector(first).stableNormalized();
    const Vec3& origin = points_[triangles_[first][0]];
    for (const Index v : triangles_[t]) {
      const bool within = std::abs(normal.dot(points_[v] - origin)) <= kFlatTolerance * size;
      if (normal.isZero() || !within) flat_[first] = 0;
    }
  }
}

bool SurfaceTrack::lies_in_plane(const TrackPoint& point, const Vec3& normal) const {
  const std::uint32_t first = patches_[point.piece];
  constexpr double kParallel = 1e-6;  // sine of an angle; the patch is as flat as its slack
  return flat_[first] != 0 &&
         area_vector(first).stableNormalized().cross(normal).norm() <= kParallel;
}

}  // namespace evenmesh
