// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

// What constraints look like as text, on the command line and in configuration files. Nothing here
// knows a mesh. All functions throw InvalidOption if the text does not parse; the message says
// what was expected, with an example.

/// What vertices slide on.
enum class SlideOn : std::uint8_t {
  line,
  plane,
  circle,
  cylinder,
  sphere,
  features,
  boundary,
  surface
};
std::string_view name(SlideOn on);
inline bool is_figure(SlideOn on) { return on <= SlideOn::sphere; }
inline bool is_curve(SlideOn on) { return on == SlideOn::line || on == SlideOn::circle; }

/// The plane through a point.
struct Plane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitX();  // unit
};

/// A number and what it is a multiple of.
struct Length {
  enum class Unit : std::uint8_t {
    absolute,      // the file's unit of length (area, volume)
    of_edges,      // "0.2h": the mean length of the edges around
    of_diagonal,   // "0.5%": a hundredth of the diagonal of the mesh's box (value 0.005)
    of_mean_size,  // "0.2m": the mean area or volume of the cells
  };
  double value = 0.0;
  Unit unit = Unit::absolute;
};

/// Three of the numbers that give a figure, from a place on.
inline Vec3 vector_at(std::span<const double> numbers, std::size_t at) {
  return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

/// "SEL on WHAT".
struct SlidePhrase {
  std::string selector;
  SlideOn on = SlideOn::line;
  /// line: point, direction; plane: point, normal; circle: centre, normal, radius; cylinder: point
  /// of the axis, its direction, radius; sphere: centre, radius. Empty: to be fitted.
  std::vector<double> numbers;
  std::string file;  // surface=FILE; empty: the input
};

/// "boundary on circle", "group:wall on plane:x=0", "all on surface=scan.stl".
/// @return  numbers are finite, directions not zero, radii positive
SlidePhrase parse_slide(std::string_view text);

/// "x=0", "y=-1.5" or "px,py,pz,nx,ny,nz".
Plane parse_plane(std::string_view text);
/// The same, but nothing where the text is no plane at all: then it may be a selector.
std::optional<Plane> try_plane(std::string_view text);

/// "0.1", "0.2h", "0.5%", "0.2m", of which those that make sense are allowed.
/// @param what     for messages: "--max-move"
/// @param allowed  the unit besides absolute
/// @return  value positive and finite
Length parse_length(std::string_view text, std::string_view what, Length::Unit allowed);

/// "SEL max-move 0.2h".
struct LimitPhrase {
  std::string selector;
  Length distance;
};
LimitPhrase parse_limit(std::string_view text);

/// "A B": the two sides of a periodic mesh, each a plane or a selector.
struct PeriodicPhrase {
  std::string first, second;
};
PeriodicPhrase parse_periodic(std::string_view text);

/// "area", "volume", "area of GROUP".
struct KeepPhrase {
  enum class What : std::uint8_t { area, volume };
  What what = What::area;
  std::string group;  // empty: of the whole mesh
};
KeepPhrase parse_keep(std::string_view text);

/// "SEL = dx,dy,dz", "SEL = file.csv", "other_mesh.obj".
struct PrescribePhrase {
  std::string selector;  // empty: all vertices
  std::string formulas;  // three, in x, y and z, with commas between; or empty
  std::string file;      // or empty
};
PrescribePhrase parse_prescribe(std::string_view text);

}  // namespace evenmesh
