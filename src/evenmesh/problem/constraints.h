// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/function.h"
#include "evenmesh/constraint/phrases.h"
#include "evenmesh/constraint/validity.h"
#include "evenmesh/geometry/track.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/problem/problem.h"

namespace evenmesh {

/// Some vertices, and what asked for them: messages and summaries repeat the text.
struct Selection {
  std::string text = {};  // "--slide boundary on circle"; any words that say where it is from
  std::vector<char> vertices = {};  // one flag per vertex
};

/// Vertices that slide on a figure.
struct Slide {
  Selection selection = {};
  SlideOn on = SlideOn::line;
  /// The figure itself, or another surface to be on: vertices off it are brought onto it. Null: a
  /// figure is fitted to every piece of the selection that edges connect; features, boundary and
  /// surface are those of the input.
  std::shared_ptr<const Track> track = nullptr;
  /// The point of that track nearest to any point in space; needed for tracks that are not figures.
  std::function<TrackPoint(const Vec3&)> nearest = {};
};

/// Vertices in a plane stay in it, on top of what else holds for them.
struct Symmetry {
  std::string text = {};
  Plane plane = {};
};

/// Vertices of one side repeat the moves of those that lie opposite.
struct Periodic {
  std::string text = {};
  std::vector<char> first = {};  // one flag per vertex
  std::vector<char> second = {};
  /// From a vertex of the first side to its image; nothing: from box to box.
  std::optional<Vec3> translation = {};
};

/// Vertices that end at most this far from where they were.
struct MoveLimit {
  Selection selection = {};
  Length distance = {};  // of_edges: times the mean length of the sides of cells around the vertex
};

/// Vertices that are brought to other places, or left where they are, and stay there.
struct Prescription {
  std::string text = {};
  std::vector<Target> targets = {};
  std::string kind = "prescribed";  // the word for it in summaries
};

/// A function kept within bounds, and what asked for it.
struct NamedBound {
  std::string text = {};
  Bound bound = {};
};

/// Everything that may be demanded of the vertices of a mesh, one member for each word of the
/// vocabulary. What is said here beats the defaults, and being fixed beats sliding.
struct Constraints {
  /// Exactly these stay. Nothing: what keeps the shape (see apply()).
  std::optional<Selection> fixed = {};
  /// These stay too unless they are free, slide or `fixed` says which stay: a default that comes
  /// with the file. Empty: none.
  Selection held = {};
  Selection layers = {};             // the same for vertices of wall layers
  std::vector<Selection> free = {};  // without the defaults; on a surface mesh anywhere on it
  std::vector<Slide> slides = {};
  std::vector<Symmetry> symmetries = {};
  std::vector<Periodic> periodic = {};
  std::vector<MoveLimit> move_limits = {};
  std::vector<Prescription> prescriptions = {};
  std::vector<NamedBound> bounds = {};
  /// How far what slides on a curved part of the input may be from it. On planar and volume meshes
  /// curved boundaries slide only if this is given; on surfaces it is kDefaultDeviation if not.
  std::optional<Length> max_deviation = {};  // of_diagonal: times that of the mesh's box
  std::optional<Length> min_size = {};       // area or volume; of_mean_size: times the mean
  std::optional<double> min_jacobian = {};   // Validity::min_jacobian
  /// How messages name a vertex; empty: "vertex 7", counted from 0.
  std::function<std::string(Index)> vertex_name = {};

  static constexpr double kDefaultDeviation = 0.005;  // of the diagonal
};

/// How a constraint enters the optimisation.
enum class Entry : std::uint8_t {
  eliminated,  // what moves cannot break it
  inequality,  // one for each of the vertices or cells
  bordered     // a row that couples many vertices
};
std::string_view name(Entry entry);

/// One line of what holds: for people and for reports.
struct ConstraintSummary {
  std::string kind = {};  // "fixed", "slide on line", "max_move"
  std::string text = {};  // as it was asked for, or "default"
  Entry entry = Entry::eliminated;
  std::size_t count = 0;
  std::string unit = {};  // "vertices" or "cells"
  std::string note = {};  // what else there is to know, one sentence without a full stop; or empty
};

/// The vertices of cells that lie in a plane, up to 1e-7 of the diagonal of the mesh's box.
std::vector<char> vertices_in_plane(const Mesh& mesh, const Plane& plane);

/// Fills in what constrains a problem: motion, validity (but for `demanded`, which it keeps),
/// bounds, max_move, max_deviation, targets. What they were before is forgotten.
///
/// Where `fixed` says nothing, what the shape hangs on is kept:
/// - planar: vertices on straight stretches of boundaries and interfaces slide along these, all
///   others on them are fixed (with a max_deviation they slide along the input's polyline);
/// - volume: vertices inside flat parts of the skin slide in these, those on straight stretches of
///   its edges along these, the rest of the skin and interfaces are fixed (with a max_deviation the
///   skin slides on itself, edges along themselves);
/// - surface: vertices slide on the input surface, feature and boundary vertices along their
///   polyline, corners are fixed; interfaces as on planar meshes.
/// Where `fixed` names some, the others move as the slides say, on a surface mesh on the surface
/// (edges along themselves), else freely. In a mesh without extent, all of whose vertices are in
/// one place, nothing moves.
///
/// A vertex on two figures at once moves along what they have in common where these are lines and
/// planes, and is fixed otherwise.
/// @param topology  of the mesh
/// @param[in,out] problem  its orientation must be that of the mesh
/// @return  what holds, in the order of the members above, defaults first
/// @throws InvalidOption  constraints that contradict each other (both are named, with a vertex),
///                        a selection without vertices, vertices that do not fit a figure, a side
///                        of a periodic pair without image, sides without a pair, a length that
///                        is not positive and finite or in a unit that has no meaning for it.
/// @pre  every mask has one entry per vertex
std::vector<ConstraintSummary> apply(const Mesh& mesh, const Topology& topology,
                                     const Constraints& constraints, Problem& problem);

}  // namespace evenmesh
