// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/triangulation.h"

#include <algorithm>
#include <utility>

#include "evenmesh/mesh/extent.h"

namespace evenmesh {
namespace {

constexpr std::size_t kMostTried = 32;  // lest a polygon of many corners take for ever

// Differences first, which keeps the digits far from the origin and the range of double.
Vec3 mean(Points points, std::span<const Index> corners) {
  const Vec3 origin = points[corners[0]];
  Vec3 sum = Vec3::Zero();
  for (const Index v : corners) {
    sum += (points[v] / 2.0 - origin / 2.0) / static_cast<double>(corners.size());
  }
  return origin + 2.0 * sum;
}

// One face at a time, without repetitions of vertices.
class Cutter {
 public:
  Cutter(Points points, double unit) : points_(points), unit_(unit) {}

  void take(std::span<const Index> vertices) {
    face_.clear();
    for (const Index v : vertices) {
      if (face_.empty() || face_.back() != v) face_.push_back(v);
    }
    while (face_.size() > 1 && face_.front() == face_.back()) face_.pop_back();
    if (face_.size() >= 3) normal_ = doubled_area(points_, face_, unit_);
  }
  const std::vector<Index>& face() const { return face_; }

  bool mean_sees_all() const {
    const Vec3 centre = mean(points_, face_);
    for (std::size_t i = 0; i < face_.size(); ++i) {
      if (!agrees(points_[face_[i]], points_[face_[(i + 1) % face_.size()]], centre)) return false;
    }
    return true;
  }

  // The number of a corner from which all others are seen; that of corners if none was found.
  std::size_t corner_that_sees_all() const {
    const std::size_t n = face_.size();
    for (std::size_t c = 0; c < std::min(n, kMostTried); ++c) {
      bool sees = true;
      for (std::size_t i = 1; i + 1 < n && sees; ++i) {
        sees =
            agrees(points_[face_[c]], points_[face_[(c + i) % n]], points_[face_[(c + i + 1) % n]]);
      }
      if (sees) return c;
    }
    return n;
  }

 private:
  bool agrees(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return ((b - a) / unit_).cross((c - a) / unit_).dot(normal_) > 0.0;
  }

  Points points_;
  double unit_;
  std::vector<Index> face_;
  Vec3 normal_ = Vec3::Zero();
};

}  // namespace

Triangulation::Triangulation(Points points, const Cells& faces) : vertices_(points.size()) {
  const double half = extent_of(points, faces.corners()).half();
  Cutter cutter(points, half > 0.0 ? half : 1.0);
  for (std::size_t c = 0; c < faces.size(); ++c) {
    if (traits(faces.kind(c)).dimension != 2) continue;
    cutter.take(faces.vertices(c));
    const std::vector<Index>& face = cutter.face();
    const std::size_t n = face.size();
    if (n == 3) triangles_.push_back({face[0], face[1], face[2]});
    if (n <= 3) continue;
    const std::size_t corner = cutter.mean_sees_all() ? n : cutter.corner_that_sees_all();
    if (corner < n) {
      for (std::size_t i = 1; i + 1 < n; ++i) {
        triangles_.push_back({face[corner], face[(corner + i) % n], face[(corner + i + 1) % n]});
      }
      continue;
    }
    const auto centre = static_cast<Index>(vertices_ + rings_.size());
    for (std::size_t i = 0; i < n; ++i) {
      triangles_.push_back({face[i], face[(i + 1) % n], centre});
    }
    rings_.push_back(face);
  }
}

std::vector<Vec3> Triangulation::positions(Points points) const {
  std::vector<Vec3> all;
  all.reserve(points.size() + rings_.size());
  all.assign(points.begin(), points.end());
  for (const std::vector<Index>& ring : rings_) all.push_back(mean(points, ring));
  return all;
}

}  // namespace evenmesh
