// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// The cells of wall layers: stacks of flat cells on the boundary that get thicker away from it, as
/// made for the flow along a wall. Their aspect ratio is wanted, while every cost takes it for bad.
///
/// A stack begins at a cell with a boundary side and goes on through the side opposite, quad by
/// quad or through quad faces of hexes and triangles of wedges, as long as cells are valid and at
/// least kFlatLayer times as wide as thick. It counts if it has at least kLeastLayerCells cells and
/// the thickest is kLayerGrowth times as thick as the first: a plate cut into slices of one
/// thickness has no wall layers. Where a stack comes upon a bad cell, with a scaled Jacobian below
/// kLeastLayerJacobian, it ends before that.
///
/// Surface meshes have none, nor have triangles, tets, polygons and pyramids.
/// @return  one flag per cell
std::vector<char> find_wall_layers(const Mesh& mesh, const Orientation& orientation);

inline constexpr double kFlatLayer = 4.0;           // least width over thickness
inline constexpr double kLayerGrowth = 1.25;        // thickest over first
inline constexpr std::size_t kLeastLayerCells = 3;  // of a stack
inline constexpr double kLeastLayerJacobian = 0.3;  // scaled

}  // namespace evenmesh
