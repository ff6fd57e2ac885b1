// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/solver/layout.h"

namespace evenmesh {

/// Finds the vertices of cells that a step would turn over.
///
/// A step offends at a cell that is not inverted before it and is after it, and at a cell that is
/// inverted before and after and then worse than it was in the input mesh. Cells without area in
/// the input are not judged: they have no side to be turned over to.
class Flips {
 public:
  /// All arguments must outlive the object.
  Flips(const Layout& layout, const Mesh& mesh, const Orientation& orientation)
      : layout_(layout), mesh_(mesh), orientation_(orientation) {}

  /// Vertices, ascending and each once, of the cells at which the step from x to x_new offends.
  std::vector<Index> find(Workers& workers, Points x, Points x_new) const;

 private:
  const Layout& layout_;
  const Mesh& mesh_;
  const Orientation& orientation_;
};

}  // namespace evenmesh
