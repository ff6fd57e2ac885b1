// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/curves.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// Which vertices lie on what must usually be kept, found from the input mesh.
///
/// The skin of a volume mesh (faces with one incident cell) is treated as a surface mesh of its
/// own: its vertices are the boundary, and its dihedral angles make the features. So do edges on
/// which more than two of its faces meet. Curves end and meet on the skin only.
///
/// A cell that is listed twice is no neighbour of itself: where there is no other, it has a
/// boundary. A planar mesh has no features: a cell that is turned over there is tangled, not
/// folded.
struct Topology {
  std::vector<char> boundary;      // per vertex: on an edge (volume: face) with one incident cell
  std::vector<char> non_manifold;  // per vertex: on an edge (volume: face) with three or more
  std::vector<char> features;      // per vertex: on an edge with a dihedral angle beyond the limit
  std::vector<char> interface;     // per vertex: on an edge (volume: face) between two groups
  std::vector<char> corners;       // per vertex: where the curves above end, meet or turn sharply
  std::vector<char> used;          // per vertex: belongs to a cell

  std::size_t boundary_sides = 0;  // edges (volume: faces) of each sort
  std::size_t non_manifold_sides = 0;
  std::size_t feature_sides = 0;
  std::size_t interface_sides = 0;
  std::size_t components = 0;  // pieces connected through shared vertices

  /// The edges of the curves, each once: boundary, feature, non-manifold and interface edges. On a
  /// volume mesh those of the skin: features, edges between groups and with one incident face.
  std::vector<VertexPair> curves;
  /// Volume: the faces with one incident cell, wound as that cell has them, in its group. Else
  /// empty.
  Cells skin;
};

struct TopologyOptions {
  /// Normals of two neighbouring faces that differ by more make their common edge a feature;
  /// a boundary or feature curve that turns by more has a corner there. Degrees, in (0, 180).
  double feature_angle = 45.0;
};

/// Surface cells in a volume mesh are where something acts, so those off the skin count as
/// interface.
///
/// O(corners) time; about 100 bytes per vertex of a triangle mesh while it runs.
/// @pre  orientation is that of the mesh
/// @throws InvalidOption  the feature angle is outside (0, 180).
Topology find_topology(const Mesh& mesh, const Orientation& orientation,
                       const TopologyOptions& options = {});

}  // namespace evenmesh
