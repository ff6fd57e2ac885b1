// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "evenmesh/base/vec3.h"
#include "evenmesh/classic/stars.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// The metric `shape` of the cells around a vertex.
class WorstShape {
 public:
  /// Both must outlive the object.
  WorstShape(const Mesh& mesh, const Orientation& orientation)
      : mesh_(mesh), orientation_(orientation) {}

  struct Found {
    double shape = 1.0;  // 1 where there is no cell
    StarCell cell;
  };
  /// The worst cell of a star; the first of several.
  Found of(const Star& star, Points x) const;

  /// The shape of one cell with one of its vertices displaced.
  double of_cell(std::uint32_t cell, Points x, Index vertex = 0,
                 const Vec3& by = Vec3::Zero()) const;

 private:
  const Mesh& mesh_;
  const Orientation& orientation_;
};

}  // namespace evenmesh
