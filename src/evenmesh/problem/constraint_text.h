// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evenmesh/constraint/selector.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/problem/constraints.h"

namespace evenmesh {

/// The vocabulary of constraints as text: one member for each option of the command line and key of
/// a configuration file, which have the same names. Empty: not demanded.
struct ConstraintText {
  std::string fix = "auto";                // a selector; auto: what keeps the shape, see apply()
  std::vector<std::string> free = {};      // selectors
  std::vector<std::string> slide = {};     // "SEL on WHAT"
  std::string surface = {};                // a file: short for a slide of all on surface=FILE
  std::vector<std::string> symmetry = {};  // planes
  std::vector<std::string> periodic = {};  // "A B"
  std::string max_move = {};               // "0.1", "0.2h"
  std::vector<std::string> limit = {};     // "SEL max-move D"
  std::string max_deviation = {};          // "0.1", "0.5%"
  std::string min_area = {};               // "0.1", "0.2m"
  std::string min_volume = {};
  std::string min_jacobian = {};                // "0.1"
  std::vector<std::string> keep = {};           // "area", "volume of GROUP"
  std::vector<std::string> equal_spacing = {};  // selectors
  std::vector<std::string> prescribe = {};      // "SEL = dx,dy,dz", "SEL = file.csv", "mesh.obj"
};

/// Where the text is to be understood.
struct ConstraintSetting {
  const Mesh& mesh;
  const Orientation& orientation;
  const Topology& topology;
  FileNames names = {};
  Selection held = {};                                 // see Constraints
  Selection layers = {};                               // see Constraints
  std::function<std::string(Index)> vertex_name = {};  // for messages; empty: "vertex 7"
  /// Reads the other files that constraints name; throw what cannot be read.
  std::function<Mesh(const std::string& path)> read_mesh = {};
  std::function<std::string(const std::string& path)> read_text = {};
  /// Makes a displacement from three formulas in x, y and z.
  std::function<std::function<Vec3(const Vec3&)>(const std::string& formulas)> displacement = {};
};

/// Finds mistakes that show without a mesh, so that they are told before one is read.
/// @throws InvalidOption  a phrase does not parse.
void check(const ConstraintText& text);

/// The constraints that a text means for a mesh.
/// @throws InvalidOption  a phrase does not parse, or a selector, group or file is not there.
Constraints understand(const ConstraintText& text, const ConstraintSetting& setting);

}  // namespace evenmesh
