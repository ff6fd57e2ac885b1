// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenmesh/mesh/followers.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// The cells of second order that have a node off the middle of its corners. Such a cell can be
/// inverted although its corners make a good one.
///
/// A cell is x(u) = sum over its nodes of N(u) d, in the hierarchic form of its shape functions
/// (Szabo and Babuska, Finite Element Analysis, 1991): corners have the linear functions, and the
/// node of an edge, a quad or the whole a function that is 1 there and 0 at the nodes of lower
/// order, with what the node is away from where these put it for d. That is the same map as the
/// usual one. A node that the cell has not counts as being there.
///
/// The Jacobian determinant is looked at where a cell of the kind may have a node: at corners, in
/// the middle of edges, quads and the whole. Pyramids, whose shape functions are no polynomials,
/// are judged by their corners alone, as are polygons.
class CurvedCells {
 public:
  /// @param followers, orientation  of the mesh, which must outlive this, as they must
  CurvedCells(const Mesh& mesh, const Followers& followers, const Orientation& orientation);

  std::size_t size() const { return cells_.size(); }

  /// Cells whose determinant is not above zero everywhere, corners included, in ascending order.
  /// @param points  with the followers where they belong
  std::vector<std::size_t> inverted(Points points) const;

  /// Cells whose determinant falls below a twentieth of its mean somewhere and below the lowest
  /// that it had in the mesh itself, both relative to its mean; in ascending order.
  std::vector<std::size_t> spoilt(Points points) const;

 private:
  struct Cell {
    std::size_t number;
    double least;                  // in the mesh, relative to the mean; 0 or less: inverted
    std::vector<Index> followers;  // per function behind the corners; ~0: none
  };

  double least_determinant(const Cell& cell, Points points) const;

  const Mesh& mesh_;
  const Orientation& orientation_;
  std::vector<Cell> cells_;
};

}  // namespace evenmesh
