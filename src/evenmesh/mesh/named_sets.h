// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// Vertices that a file calls by a name: those of a node set, of the cells of an element set, of
/// the sides of a marker.
struct NamedSet {
  std::string kind = {};    // the word for it: "nset", "elset", "marker"
  std::string name = {};    // as in the file
  std::size_t members = 0;  // how many things the file lists in it
  std::string unit = {};    // what these are: "vertices", "cells", "sides"
  /// Numbers of its vertices, in any order, perhaps repeated. Made when asked for: sets may overlap
  /// so much that all of them together would take far more memory than the file.
  std::function<std::vector<Index>(const Cells& cells)> vertices = {};
};

/// A set whose vertices are at hand.
inline NamedSet named_list(std::string kind, std::string name, std::size_t members,
                           std::string unit, std::vector<Index> vertices) {
  auto shared = std::make_shared<const std::vector<Index>>(std::move(vertices));
  return {std::move(kind), std::move(name), members, std::move(unit),
          [shared](const Cells&) { return *shared; }};
}

}  // namespace evenmesh
