// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/mesh_tracks.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"

namespace evenmesh {

/// What a vertex may do without changing the shape of its mesh.
enum class Hold : std::uint8_t {
  nothing,  // it may do anything: it is inside, or in no cell
  corner,   // stays: curves end, meet or turn there
  curved,   // stays: it lies on a curve or face that bends there
  file,     // stays: something else in the file hangs on its place
  layer,    // stays: it belongs to a wall layer
  line,     // slides along a straight stretch
  plane,    // slides within a flat part of the skin of a volume mesh
  run,      // slides along its polyline
  surface   // slides on the faces of the input
};

struct Held {
  Hold hold = Hold::nothing;
  Vec3 direction = Vec3::Zero();  // line: of the stretch; plane: normal; unit. Else zero
};

enum class Curved : std::uint8_t {
  stays,  // the shape does not change at all
  slides  // along itself, which cuts its bends a little short
};

/// What every vertex may do, by where it lies on the input's geometry.
///
/// A vertex slides along a line where the curve it is on is straight from the vertex before it to
/// the one behind, up to kStraightSlack of the mesh's size, and within a plane where the faces of
/// the skin around it lie in one. Its neighbours where a bend begins stay, so that it does not come
/// past the bend.
/// @param curved  what becomes of the rest of the boundary; that of a surface mesh always slides
/// @pre  topology and tracks are those of the mesh
std::vector<Held> keep_shape(const Mesh& mesh, const Orientation& orientation,
                             const Topology& topology, const MeshTracks& tracks, Curved curved);

/// Relative to the diagonal of the mesh's box. Single-precision files need it.
inline constexpr double kStraightSlack = 1e-7;

}  // namespace evenmesh
