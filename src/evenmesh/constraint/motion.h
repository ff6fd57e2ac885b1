// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/track.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// How each vertex may move: not at all, along a line, in a plane, or freely; on a track (a curve
/// or surface) the line or plane is tangent to it and turns as the vertex goes.
///
/// This eliminates constraints instead of imposing them: x = x_0 + Z y with an orthonormal block Z
/// of 0 to 3 columns per vertex. Solvers project gradients and steps with Z Z^T, and after each
/// step bring vertices back onto their tracks.
class Motion {
 public:
  enum class Freedom : std::uint8_t { fixed, line, plane, free };

  /// Where the vertices with a line or plane of their own are, in the order of slots(). It goes
  /// with one set of positions: solvers that try a step keep two.
  using Places = std::vector<TrackPoint>;

  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  Motion() = default;
  /// @param fixed  per vertex: may not move
  /// @pre  fixed has one entry per vertex of the mesh
  ///
  /// Vertices that are not fixed move in the plane of a planar mesh, freely inside a volume mesh,
  /// and in the tangent plane of the input surface on a surface mesh. The tangent plane is normal
  /// to the area-weighted mean of the normals of the incident cells, each turned to agree with the
  /// greatest of them; where that is undefined (no area around) the vertex is fixed. Vertices
  /// that belong to no cell are fixed.
  Motion(const Mesh& mesh, const Orientation& orientation, std::span<const char> fixed);

  // ---- setting up -------------------------------------------------------------------------------

  /// Also fixes what is tied to the vertex.
  void fix(Index vertex);
  /// Keeps a vertex, on top of what keeps it already, in the plane through where it is. What is on
  /// a track that does not lie in that plane as a whole gets fixed.
  /// @param position  of the vertex
  /// @param normal    unit
  void keep_in_plane(Index vertex, const Vec3& position, const Vec3& normal);
  /// Keeps a vertex on the line through where it is, instead of what kept it before.
  /// @param direction  unit
  void keep_on_line(Index vertex, const Vec3& position, const Vec3& direction);
  /// Puts a vertex on a track, instead of what kept it before.
  /// @param at  where on the track
  void put_on_track(Index vertex, std::shared_ptr<const Track> track, const TrackPoint& at);
  /// Lets one vertex repeat the moves of another, as on both sides of a periodic mesh: what keeps
  /// either keeps both.
  /// @pre  neither is on a curved track
  void tie(Index follower, Index leader, Points points);

  // ---- asking -----------------------------------------------------------------------------------

  std::size_t size() const { return freedom_.size(); }
  Freedom freedom(Index vertex) const { return freedom_[vertex]; }
  /// Vertices that may move.
  std::size_t moving() const;
  /// The vertex that this one repeats the moves of; itself if it goes its own way.
  Index leader(Index vertex) const { return leader_.empty() ? vertex : leader_[vertex]; }
  bool has_ties() const { return !tied_.empty(); }
  /// True for leaders and followers.
  bool is_tied(Index vertex) const { return !next_.empty() && next_[vertex] != vertex; }
  /// Calls body for a vertex and all that move with it.
  template <typename Body>
  void for_tied(Index vertex, const Body& body) const {
    body(vertex);
    if (next_.empty()) return;
    for (Index v = next_[vertex]; v != vertex; v = next_[v]) body(v);
  }
  /// True if some vertex slides on a surface of triangles.
  bool has_kinks() const;
  /// The track a vertex is on, or null.
  const Track* track(Index vertex) const;
  /// The slot of a vertex that has a line or plane of its own, or kNone.
  std::uint32_t slot(Index vertex) const { return slot_.empty() ? kNone : slot_[vertex]; }
  /// The vertices that have a line or plane of their own.
  std::span<const Index> slots() const { return slots_; }
  /// Where these are in the input.
  const Places& start() const { return start_; }

  /// Unit normal of the plane the vertex moves in at the start; zero if it is not bound to one.
  Vec3 normal(Index vertex) const;

  /// The part of a vector that the vertex may follow, Z Z^T d.
  Vec3 project(const Places& places, Index vertex, const Vec3& d) const {
    if (freedom_[vertex] == Freedom::fixed) return Vec3::Zero();
    if (freedom_[vertex] == Freedom::free) return d;
    const std::uint32_t own = slot(vertex);
    const Vec3& u = own == kNone ? common_normal_ : places[own].direction;
    if (freedom_[vertex] == Freedom::line) return u.dot(d) * u;
    return d - u.dot(d) * u;
  }
  /// The same at the start.
  Vec3 project(Index vertex, const Vec3& d) const { return project(start_, vertex, d); }

  // ---- for solvers ------------------------------------------------------------------------------

  /// Turns derivatives with respect to positions into derivatives with respect to what may move:
  /// adds those of tied vertices to their leader's, and projects. 0 for a vertex that is tied.
  void reduce(Workers& workers, const Places& places, std::span<Vec3> gradient) const;
  /// Projects a step, 0 for a vertex that is tied.
  void project(Workers& workers, const Places& places, std::span<Vec3> step) const;
  /// After a step from x_0 to x: brings vertices on tracks back to them and takes tied ones along.
  /// Vertices that have not moved keep their bits.
  /// @param from      where they were at x_0
  /// @param[out] to   where they are
  void retract(Workers& workers, Points x_0, const Places& from, std::span<Vec3> x,
               Places& to) const;
  /// The same for one vertex (and what is tied to it).
  void retract(Index vertex, Points x_0, const Places& from, std::span<Vec3> x, Places& to) const;

  /// Lets the start be where vertices are after moves from x_0, the start so far, to x.
  void start_from(Workers& workers, Points x_0, Points x);

  /// The same for some vertices: vertex k of the result is vertices[k] here. Knows no ties.
  Motion selected(std::span<const Index> vertices) const;
  /// The same for all vertices in another order: vertex k of the result is order[k] here.
  Motion renumbered(std::span<const Index> order) const;

 private:
  std::uint32_t own_slot(Index vertex);
  void restrict_to(Index vertex, const Vec3& position, Freedom freedom, const Vec3& direction);
  Vec3 direction(Index vertex) const;

  std::vector<Freedom> freedom_;
  Vec3 common_normal_ = Vec3::Zero();  // of a planar mesh
  std::vector<std::uint32_t> slot_;    // per vertex, kNone where there is none; or empty
  std::vector<Index> slots_;           // per slot: the vertex
  std::vector<std::shared_ptr<const Track>> tracks_;  // per slot: null for a fixed line or plane
  Places start_;
  std::vector<Index> leader_;  // per vertex, or empty
  std::vector<Index> next_;    // per vertex: the next one that is tied to it, round in a ring
  std::vector<Index> tied_;    // the vertices that are not their own leader
};

}  // namespace evenmesh
