// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// What is demanded of every cell's Jacobian determinants, one at each corner:
///
///   det_k(x) >= eps_e,   det_k of a triangle is twice its area, of a tet six times its volume
///
/// A polygon, which may be concave, is asked for twice its whole area instead; a surface cell in
/// space is measured about its normal in the input. Linear triangles and tets, quads with
/// straight sides and pyramids, are valid where their corners are; hexes and wedges may in rare
/// cases be inverted in between, which the solver's promise looks for at the end (whole_cell.h).
struct Validity {
  /// False: cells are not asked for anything (steps that turn a valid cell over are shortened
  /// all the same).
  bool demanded = true;
  /// eps as a part of the determinant of the ideal cell of the size around (reference_sizes()).
  /// 0: kDefaultJacobian, but no more than half of what a valid cell has in the input.
  double min_jacobian = 0.0;
  /// eps as the area (volume) of an ideal cell with that determinant, in the file's unit; the
  /// greater of the two demands counts. 0: none.
  double min_size = 0.0;

  static constexpr double kDefaultJacobian = 0.02;
};

/// The area (or volume) that a cell has room for: the signed sizes of the cells around it,
/// averaged over two rings. Unlike a cell's own size it makes sense in a tangled mesh too.
/// @return  per cell, > 0; 0 for cells of the lower dimension in a volume mesh
std::vector<double> reference_sizes(const Mesh& mesh, const Orientation& orientation);

/// Mean of the signed area (volume) of the cells: what a mesh has room for, tangled or not.
double mean_size(const Mesh& mesh, const Orientation& orientation);

/// The determinant at a corner of the ideal cell of a kind with area (volume) 1; of a polygon
/// twice its area.
double ideal_determinant(CellKind kind);

}  // namespace evenmesh
