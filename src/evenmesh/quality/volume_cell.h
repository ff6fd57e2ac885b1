// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"

namespace evenmesh {

/// A tet, hex, wedge or pyramid reduced to what its measures are made of, mostly the edges and the
/// determinant at each corner, in a unit of the cell's own (see SurfaceCell). One object may be set
/// again and again.
class VolumeCell {
 public:
  /// The edges that leave a corner, in the order of CellTraits::Corner.
  struct Corner {
    Vec3 a, b, c;
    double determinant;  // of (a, b, c) times the cell's sign
  };

  /// @param points  the vertices in the order of the kind. If a coordinate is not finite the cell
  ///                counts as collapsed to one point.
  /// @param sign    -1 if the cell is wound the other way on purpose, else 1
  /// @pre  traits(kind).dimension == 3
  void set(CellKind kind, std::span<const Vec3> points, double sign);

  CellKind kind() const { return kind_; }
  std::span<const Corner> corners() const { return {corners_.data(), count_}; }
  double sign() const { return sign_; }

  /// Hex: the three axes, each the sum of its four edges, as if they met in a corner.
  const Corner& axes() const { return axes_; }

  /// The vertices in the order of the kind, the first at the origin.
  std::span<const Vec3> points() const { return {points_.data(), point_count_}; }

  double longest() const { return longest_; }  // edge
  double shortest() const { return shortest_; }

 private:
  bool try_set(std::span<const Vec3> points);

  CellKind kind_ = CellKind::tet;
  double sign_ = 1.0;
  std::array<Corner, 8> corners_;
  Corner axes_;
  std::size_t count_ = 0;
  std::array<Vec3, 8> points_;
  std::size_t point_count_ = 0;
  double longest_ = 0.0;
  double shortest_ = 0.0;
};

}  // namespace evenmesh
