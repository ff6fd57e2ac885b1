// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/cost/cost.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// Pulls every edge of every cell towards one common length.
///
///   f(x) = sum over cells e, edges j of e:  (l_ej - L)^2
///
/// An edge shared by two cells counts once in each. Minimum 0, reached when all edges have length
/// L. Scale-free: divided by L^2.
///
/// Blind to orientation. Where L is longer than the edges have room for, the mesh is under
/// compression and buckles: a perfect n x n grid of squares with a fixed boundary and edges h is a
/// minimiser only while L / h <= 1 + tan^2(pi / (2 n)). The cures are a little barycenter cost or
/// the length that the area has room for, length_from_size().
/// @see   Kulovec, Kos, Duhovnik 2011, Eqs. 15 and 16 (whose "m + p" must read m times p)
class Global final : public Cost {
 public:
  /// @param length  L, in the mesh's length unit
  /// @throws InvalidOption  L is not positive and finite.
  explicit Global(double length, Scaling scaling = Scaling::absolute);

  std::string_view name() const override { return "global"; }
  double evaluate(const CellBlock& cells, Points x, double weight,
                  std::span<Vec3> gradient) const override;
  void add_springs(const CellBlock& cells, Points x, std::vector<Spring>& springs) const override;
  double length() const { return length_; }

 private:
  double length_;
  double weight_;  // 1, or 1 / L^2 when scale-free
};

/// The mean edge length of a mesh, an edge counted once in every cell that has it (Eq. 16).
/// 0 for a mesh without cells.
double mean_edge_length(const Mesh& mesh);

/// The edge length with which as many ideal cells of the same kinds fill the same area (or, for
/// volume cells, volume). Unlike the mean edge length it is right for a mesh whose cells overlap.
///
///   L^d = |total signed measure| / sum over cells of the measure of the ideal cell with edges 1
///
/// A cell that is turned over counts negatively, whichever way the file winds its cells; those of a
/// surface count with their own (unsigned) area.
/// @param orientation  of the same mesh
double length_from_size(const Mesh& mesh, const Orientation& orientation);

}  // namespace evenmesh
