// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/solver/layout.h"

namespace evenmesh {

/// Finds the vertices of cells that a step would turn over or spoil.
///
/// A step offends at a cell that is not inverted before it and is after it; at a cell that is
/// inverted before and after and then worse than in the input mesh; and at a cell whose `shape`
/// after it is below the least allowed. Cells without area in the input are not judged: they have
/// no side to be turned over to. It also offends at a vertex that it takes out of reach, or further
/// out.
class Flips {
 public:
  /// @param input        positions of the input mesh
  /// @param least_shape  in [0, 1]; 0: only inversion counts
  /// All arguments must outlive the object.
  Flips(const Layout& layout, Points input, const Orientation& orientation,
        double least_shape = 0.0)
      : layout_(layout), input_(input), orientation_(orientation), least_shape_(least_shape) {}

  /// How far each vertex may get from where it is in the input (mesh length unit); empty: anywhere.
  void set_reach(std::vector<double> reach) { reach_ = std::move(reach); }

  /// Vertices, ascending and each once, of the cells (or vertices) at which the step from x to
  /// x_new offends.
  std::vector<Index> find(Workers& workers, Points x, Points x_new) const;

 private:
  struct Cell;
  bool offends(const Cell& cell, Points x, Points x_new) const;

  const Layout& layout_;
  Points input_;
  const Orientation& orientation_;
  double least_shape_;
  std::vector<double> reach_;
};

}  // namespace evenmesh
