// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/surface_track.h"
#include "evenmesh/geometry/track.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"

namespace evenmesh {

/// Where on the input geometry a vertex lies.
enum class VertexPlace : std::uint8_t {
  unused,  // belongs to no cell
  inside,  // of a planar or volume mesh: on no curve and no skin
  patch,   // of a surface or of a volume's skin: between the curves
  run,     // on a curve between two corners
  corner   // held: where curves end, meet or turn sharply, and where there is nothing to slide on
};

/// The geometry of an input mesh, for its vertices to slide on.
///
/// Curves (boundary, feature, non-manifold and interface edges) are cut at corners into runs, each
/// of which is a CurveTrack; closed curves without a corner are runs too. The faces of a surface
/// mesh, or of a volume mesh's skin, are one SurfaceTrack that the curves divide into patches. A
/// planar mesh has no surface track: its vertices move freely in the plane.
///
/// Faces with four corners and more count as the triangles that Triangulation makes of them.
///
/// Held as corners are also the vertices of interfaces and of non-manifold faces within a volume,
/// those in which two parts of the surface meet and share no edge, and those around which no face
/// has area.
struct MeshTracks {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  struct Run {
    std::vector<Index> vertices;  // in order; a closed run does not repeat the first
    bool closed = false;
    /// Between its ends along a straight line, up to kStraightTolerance times their distance, and
    /// never back. Closed: never.
    bool straight = false;
  };
  struct Patch {
    /// The plane all of its vertices lie in, up to kPlanarTolerance; zero if there is none.
    Vec3 normal = Vec3::Zero();

    bool flat() const { return !normal.isZero(0.0); }
  };

  /// Those of the runs, in their order, and then that of the surface if there is one.
  std::vector<std::shared_ptr<const Track>> tracks;
  std::vector<Run> runs;       // of tracks[0], tracks[1], ...
  std::vector<Patch> patches;  // of the surface

  // Per vertex:
  std::vector<VertexPlace> place;
  std::vector<std::uint32_t> track;  // which of tracks; kNone unless on a run or patch
  std::vector<std::uint32_t> patch;  // which of patches; kNone unless on one
  std::vector<TrackPoint> start;     // where on its track; the position has the vertex's bits

  bool is_on_straight_run(Index vertex) const {
    return place[vertex] == VertexPlace::run && runs[track[vertex]].straight;
  }
  bool is_on_flat_patch(Index vertex) const {
    return place[vertex] == VertexPlace::patch && patches[patch[vertex]].flat();
  }
};

/// How far from the line between its ends, relative to their distance, a straight run's vertices
/// may lie. Single-precision files need the slack.
inline constexpr double kStraightTolerance = 1e-7;

/// Do the points follow the straight line from the first to the last?
bool is_straight(Points points);

/// O(corners) time for meshes with a bounded number of edges per vertex.
/// @pre  orientation and topology are those of the mesh
MeshTracks find_mesh_tracks(const Mesh& mesh, const Orientation& orientation,
                            const Topology& topology);

/// The faces of a mesh as one surface that no curves divide but edges of other than two triangles.
/// Numbers of vertices beyond the mesh's are those of centres (see Triangulation).
std::shared_ptr<const SurfaceTrack> undivided_surface(const Mesh& mesh);

}  // namespace evenmesh
