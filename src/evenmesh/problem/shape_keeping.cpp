// SPDX-License-Identifier: MIT
#include "evenmesh/problem/shape_keeping.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>

#include "evenmesh/mesh/extent.h"
#include "evenmesh/mesh/plane.h"

namespace evenmesh {
namespace {

// The straight stretches of a curve.
class Stretches {
 public:
  Stretches(Points points, const MeshTracks::Run& run, double slack)
      : points_(points), curve_(run.vertices), slack_(slack) {
    if (!run.closed || curve_.empty()) return;
    // A loop is cut where it bends.
    const std::size_t n = curve_.size();
    std::size_t start = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Index around[] = {curve_[(k + n - 1) % n], curve_[k], curve_[(k + 1) % n]};
      if (straight(around)) continue;
      start = k;
      break;
    }
    std::rotate(curve_.begin(), curve_.begin() + static_cast<std::ptrdiff_t>(start), curve_.end());
    curve_.push_back(curve_[0]);
  }

  /// Calls visit(vertex, direction) for the vertices within stretches.
  template <typename Visit>
  void for_each_within(const Visit& visit) const {
    for (std::size_t i = 0; i + 1 < curve_.size();) {
      const std::size_t j = end_of_stretch(i);
      const Vec3 direction = (at(j) - at(i)).stableNormalized();
      for (std::size_t k = i + 1; k < j; ++k) visit(curve_[k], direction);
      i = j;
    }
  }

 private:
  const Vec3& at(std::size_t k) const { return points_[curve_[k]]; }

  bool straight(std::span<const Index> part) const {
    const Vec3& first = points_[part.front()];
    const Vec3 chord = points_[part.back()] - first;
    const double length = chord.stableNorm();
    if (!(length > 0.0)) return false;
    const Vec3 along = chord / length;
    double way = 0.0;
    for (const Index v : part.subspan(1)) {
      const Vec3 d = points_[v] - first;
      const double next = d.dot(along);
      if (!(next > way) || (d - next * along).stableNorm() > slack_) return false;
      way = next;
    }
    return true;
  }
  bool straight(std::size_t i, std::size_t j) const {
    return straight(std::span(curve_).subspan(i, j - i + 1));
  }

  // Doubles the stretch as long as it is straight, then halves the doubt: O(n log n) over a curve.
  std::size_t end_of_stretch(std::size_t i) const {
    const std::size_t last = curve_.size() - 1;
    std::size_t good = i + 1;
    std::size_t bad = last + 1;
    for (std::size_t step = 2; good < last; step *= 2) {
      const std::size_t next = std::min(i + step, last);
      if (!straight(i, next)) {
        bad = next;
        break;
      }
      good = next;
    }
    while (good + 1 < bad) {
      const std::size_t middle = good + (bad - good) / 2;
      (straight(i, middle) ? good : bad) = middle;
    }
    return good;
  }

  Points points_;
  std::vector<Index> curve_;
  double slack_;
};

// The vertices of the faces around each vertex of the skin.
class SkinRings {
 public:
  explicit SkinRings(const Cells& skin, std::size_t vertex_count)
      : skin_(skin), begins_(vertex_count + 1, 0), faces_(skin.corners().size()) {
    for (const Index v : skin.corners()) ++begins_[v + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    std::vector<Offset> next = begins_;
    for (std::size_t f = 0; f < skin.size(); ++f) {
      for (const Index v : skin.vertices(f)) faces_[next[v]++] = static_cast<std::uint32_t>(f);
    }
  }

  /// The normal of the plane in which all faces around the vertex lie.
  std::optional<Vec3> normal(Points points, Index vertex, double slack) {
    ring_.clear();
    for (Offset k = begins_[vertex]; k < begins_[vertex + 1]; ++k) {
      const auto corners = skin_.vertices(faces_[k]);
      ring_.insert(ring_.end(), corners.begin(), corners.end());
    }
    if (ring_.empty()) return std::nullopt;
    const double size = extent_of(points, ring_).diagonal();
    return size > 0.0 ? common_plane(points, ring_, slack / size) : std::nullopt;
  }

 private:
  const Cells& skin_;
  std::vector<Offset> begins_;
  std::vector<std::uint32_t> faces_;
  std::vector<Index> ring_;
};

void keep_faces(const Mesh& mesh, const Topology& topology, const MeshTracks& tracks, double slack,
                Curved curved, std::vector<Held>& held) {
  SkinRings rings(topology.skin, mesh.point_count());
  for (Index v = 0; v < held.size(); ++v) {
    if (tracks.place[v] != VertexPlace::patch) continue;
    if (tracks.is_on_flat_patch(v)) {
      held[v] = {Hold::plane, tracks.patches[tracks.patch[v]].normal};
    } else if (const auto normal = rings.normal(mesh.points(), v, slack)) {
      held[v] = {Hold::plane, *normal};
    } else {
      held[v].hold = curved == Curved::slides ? Hold::surface : Hold::curved;
    }
  }
}

}  // namespace

std::vector<Held> keep_shape(const Mesh& mesh, const Orientation& orientation,
                             const Topology& topology, const MeshTracks& tracks, Curved curved) {
  const double slack = kStraightSlack * extent_of(mesh.points(), mesh.cells().corners()).diagonal();
  const bool surface = orientation.type == MeshType::surface;
  std::vector<Held> held(mesh.point_count());
  for (Index v = 0; v < held.size(); ++v) {
    if (tracks.place[v] == VertexPlace::corner) held[v].hold = Hold::corner;
    if (tracks.place[v] == VertexPlace::patch) held[v].hold = Hold::surface;
    if (tracks.place[v] != VertexPlace::run) continue;
    // An interface on a surface is where two parts meet, which is nobody's shape.
    const bool only_interface =
        !topology.boundary[v] && !topology.features[v] && !topology.non_manifold[v];
    const bool slides = surface ? !only_interface : curved == Curved::slides;
    held[v].hold = slides ? Hold::run : Hold::curved;
  }
  for (const MeshTracks::Run& run : tracks.runs) {
    Stretches(mesh.points(), run, slack).for_each_within([&](Index v, const Vec3& direction) {
      // What slides on its run is on it exactly; the line is up to the slack beside it.
      if (tracks.place[v] == VertexPlace::run && held[v].hold != Hold::run) {
        held[v] = {Hold::line, direction};
      }
    });
  }
  if (orientation.type == MeshType::volume) {
    keep_faces(mesh, topology, tracks, slack, curved, held);
  }
  return held;
}

}  // namespace evenmesh
