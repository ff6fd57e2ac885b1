// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// Where a vertex shall go.
struct Target {
  Index vertex = 0;
  Vec3 position = Vec3::Zero();
};

/// Reads where vertices shall go from a table, one vertex a line.
///
///   # comments and empty lines are passed over
///   id,x,y,z
///   12,0.5,1.25,0
///
/// The header says what the columns are: new positions (id,x,y,z) or displacements (id,dx,dy,dz).
/// Without one they are positions. Columns are separated by commas, semicolons or blanks.
/// @param points    positions of all vertices of the input
/// @param ids       the number that the file gives each vertex; empty: they are counted
/// @param first_id  the number the file gives its first vertex (1 for OBJ, 0 for
///                  numbered-by-place)
/// @return  by ascending vertex, each once
/// @throws InvalidOption  a line that is none of these, an id that no vertex has, a number that is
///                        not finite, or two lines that send a vertex to different places; the
///                        message starts with the line
std::vector<Target> read_targets(std::string_view text, Points points, std::uint64_t first_id = 1,
                                 std::span<const std::uint64_t> ids = {});

/// Where vertices are in another mesh with the same vertices.
/// @param mask  per vertex: gets a target, moved or not; empty: those whose positions differ
/// @return  by ascending vertex
/// @throws InvalidOption  the meshes differ in the number of vertices.
/// @pre  mask is empty or has one entry per vertex
std::vector<Target> targets_from(const Mesh& mesh, const Mesh& moved,
                                 std::span<const char> mask = {});

}  // namespace evenmesh
