// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// What the cells span together. Found from the mesh, never asked for.
enum class MeshType : std::uint8_t {
  planar,   // surface cells, every vertex in one plane
  surface,  // surface cells in space
  volume    // at least one volume cell
};
std::string_view name(MeshType type);

/// Which way is up, cell by cell, in the mesh as it was read.
///
/// Judges "inverted" before and after smoothing alike, so it is made once from the input and kept.
/// Files wind their cells as they please: a whole file may be left-handed, or a part of it wound
/// the other way. That is not an inversion, and evenmesh neither counts nor repairs it:
///
/// - planar: sides shared by two cells say which cells are wound alike; each connected piece
///   takes the sense in which the greater part of its area is positive.
/// - volume: the same over faces shared by two cells; the sense in which more volume is positive.
/// - surface: each cell's own normal in the input is its up, so no cell starts inverted unless a
///   corner of it points against its own mean normal (a concave or bow-tie quad).
///
/// Two cells on the same vertices do not say how they are wound to one another, nor does a side of
/// three or more, nor a
/// quad whose vertices are listed crosswise and so contradict its neighbours. In a piece that
/// cannot be wound consistently every cell of a plane or a volume is taken as positive, and none
/// counts as wound against the majority.
struct Orientation {
  MeshType type = MeshType::surface;
  Vec3 normal = Vec3::Zero();  // planar: the common unit normal; else zero
  /// Per cell, 1 or -1; empty: all 1. planar: whether the cell is positive about normal or about
  /// its opposite. volume: whether it is wound as its kind says or the other way. surface: -1 where
  /// wound against the majority of its piece.
  std::vector<std::int8_t> signs;
  std::vector<Vec3> normals;  // surface: per cell, unit or zero (no area); else empty
  /// Cells wound against the majority of their piece. 0 for a mesh that is wound the other way as
  /// a whole.
  std::size_t against_majority = 0;
  bool orientable = true;  // false: some piece is like a Moebius strip

  double sign(std::size_t cell) const { return signs.empty() ? 1.0 : signs[cell]; }

  /// The direction a surface cell's corners must wind about to count as positive; zero where the
  /// input cell had no area (the cell is then judged by its own normal) and for volume cells.
  Vec3 up(std::size_t cell) const {
    if (type == MeshType::planar) return sign(cell) * normal;
    return normals.empty() ? Vec3(Vec3::Zero()) : normals[cell];
  }
};

/// How far from a common plane, relative to the size of the mesh, vertices may lie for the mesh to
/// count as planar. Single-precision files need the slack.
inline constexpr double kPlanarTolerance = 1e-7;

/// O(corners) time and memory.
Orientation find_orientation(const Mesh& mesh);

}  // namespace evenmesh
