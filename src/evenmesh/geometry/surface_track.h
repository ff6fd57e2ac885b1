// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/closest_point.h"
#include "evenmesh/geometry/track.h"
#include "evenmesh/geometry/unit_scale.h"

namespace evenmesh {

/// A triangulated surface. Pieces are its triangles.
///
/// Vertices cross the edge between two triangles unless it is a barrier: an edge named as one, or
/// one that other than two triangles have. Barriers cut the surface into patches.
///
/// A direction is the normal, blended from those at the triangle's corners, so that it turns
/// smoothly from triangle to triangle. The normal at a corner is the area-weighted mean over the
/// triangles around the vertex as far as the nearest barriers: it does not blend over a crease.
/// Triangles may be wound either way; normals of one patch are on the side that its least triangle
/// says, where the patch has two sides. Where blending cancels the normal or turns it beyond the
/// triangle's plane, it is that of the triangle. It is zero only on a triangle without area all of
/// whose neighbours have none.
class SurfaceTrack final : public Track {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// @param points     finite
  /// @param triangles  vertices as numbers of points; fewer than 2^32 / 3
  /// @param barriers   one per triangle: bit j is set if the edge from corner j to the next is a
  ///                   barrier; empty if there is none. One of the two sides is enough.
  SurfaceTrack(std::vector<Vec3> points, std::vector<VertexTriple> triangles,
               std::span<const std::uint8_t> barriers = {});

  int dimension() const override { return 2; }

  /// Floods the triangles from `from` over edges that reach into the ball. Allocates nothing once
  /// the calling thread has seen a ball of that many triangles. Equally near triangles: the least.
  /// @pre  from lies on this track
  TrackPoint nearest(const Vec3& p, const TrackPoint& from) const override;
  /// Zero: a triangle is flat.
  Vec3 curvature(const TrackPoint& point, const Vec3& t) const override;
  bool lies_in_plane(const TrackPoint& point, const Vec3& normal) const override;
  bool has_kinks() const override { return true; }

  std::size_t triangles() const { return triangles_.size(); }
  const VertexTriple& vertices(std::uint32_t triangle) const { return triangles_[triangle]; }
  Vec3 position(Index vertex) const { return scale_.from_unit * points_[vertex]; }
  /// The triangle beyond the edge from corner j to the next; kNone if that is a barrier.
  std::uint32_t neighbour(std::uint32_t triangle, std::size_t j) const {
    return neighbours_[triangle][j];
  }
  /// A corner of a triangle as a point of the track.
  TrackPoint at(std::uint32_t triangle, std::size_t corner) const;
  /// The least triangle that can be reached without crossing a barrier: the name of the patch.
  std::uint32_t patch(std::uint32_t triangle) const { return patches_[triangle]; }
  /// The triangles around a vertex that can be reached from one another without crossing a barrier
  /// at the vertex have the same sector there.
  std::uint32_t sector(std::uint32_t triangle, std::size_t corner) const {
    return sectors_[triangle][corner];
  }

 private:
  void find_neighbours(std::span<const std::uint8_t> barriers);
  void find_patches();
  void find_flat_patches();
  void find_normals();
  bool are_wound_alike(std::uint32_t triangle, std::size_t edge, std::uint32_t other) const;
  ClosestPoint closest(std::uint32_t triangle, const Vec3& p) const;
  Vec3 area_vector(std::uint32_t triangle) const;
  Vec3 normal(std::uint32_t triangle, const Vec3& weights) const;

  UnitScale scale_;
  std::vector<Vec3> points_;  // times scale_.to_unit
  std::vector<VertexTriple> triangles_;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;  // beyond edge j
  std::vector<std::array<std::uint32_t, 3>> sectors_;     // at corner j: index into normals_
  std::vector<Vec3> normals_;                             // per sector, unit or zero
  std::vector<std::uint32_t> patches_;
  std::vector<char> flat_;  // per patch, by its least triangle
  /// Per triangle: bit j: its sector's normal at corner j is to be turned round; bit 3: its own.
  std::vector<std::uint8_t> turned_;
};

}  // namespace evenmesh
