// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/mesh_tracks.h"
#include "evenmesh/constraint/motion.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/problem/constraints.h"
#include "evenmesh/problem/shape_keeping.h"
#include "evenmesh/problem/target_list.h"

namespace evenmesh {

// What the steps of apply() share: what they look at, what they fill in, and how they complain.

/// A mesh and what is demanded of it.
class Scene {
 public:
  /// Keeps references to all of them.
  Scene(const Mesh& mesh, const Topology& topology, const Constraints& constraints,
        const Orientation& orientation);

  const Mesh& mesh;
  const Points points;
  const Topology& topology;
  const Constraints& constraints;
  const Orientation& orientation;
  const MeshType type;
  const double size;  // diagonal of the box of the cells, mesh length unit

  /// The curves and surfaces of the mesh, found when they are first asked for.
  const MeshTracks& tracks() const;
  bool is_fixed(Index v) const { return constraints.fixed && constraints.fixed->vertices[v]; }
  /// So far apart, places are not the same.
  bool is_apart(double distance) const;
  double distance(const Plane& plane, Index v) const;
  /// For messages: "vertex 7".
  std::string name_of(Index v) const;

 private:
  mutable std::optional<MeshTracks> tracks_;
};

/// A vertex that repeats the moves of another, and who wants that.
struct Image {
  Index of = 0;
  Index vertex = 0;
  const Periodic* periodic = nullptr;
};

/// What the steps have arranged so far.
struct Arrangement {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  Motion& motion;
  TargetList targets;
  std::vector<Held> default_of = {};  // per vertex: what it may do if nobody asks for more
  std::vector<std::uint32_t> slide_of =
      {};                          // per vertex: the first slide it takes part in, or kNone
  std::vector<Image> images = {};  // both ways

  bool moves(Index v) const { return motion.freedom(v) != Motion::Freedom::fixed; }
  bool slides(Index v) const { return slide_of[v] != kNone; }
};

/// @throws InvalidOption  always: "TEXT: WHAT"
[[noreturn]] void fail(std::string_view text, std::string_view what);
/// @throws InvalidOption  always: "A and B contradict each other: WHAT"
[[noreturn]] void contradict(std::string_view a, std::string_view b, std::string_view what);

/// How many flags are set.
std::size_t count(std::span<const char> flags);
/// "1 vertex", "7 vertices".
std::string vertices(std::size_t number);

// Relative to the size of the scene:
inline constexpr double kInPlane = 1e-7;  // so near a symmetry plane a vertex is in it

}  // namespace evenmesh
