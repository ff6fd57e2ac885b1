// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/quality/metric.h"

namespace evenmesh {

/// One of the pictures side by side: the cells of the mesh at these positions.
struct Panel {
  std::string title;  // "before"; any bytes
  Points points;      // one per vertex of the mesh
};

struct MeshPictureOptions {
  std::string title = {};
  Metric metric = Metric::shape;
  /// From where a surface or a volume is seen, and what is up there; planar meshes are seen from
  /// above their plane. Must not be parallel.
  Vec3 view = Vec3(1.0, 0.6, 1.4);
  Vec3 up = Vec3(0.0, 1.0, 0.0);
  /// The part that is shown, from (0, 0), lower left, to (1, 1), upper right: x0, y0, x1, y1.
  std::array<double, 4> zoom = {0.0, 0.0, 1.0, 1.0};
  double panel_width = 420.0;         // pixels, one per panel
  std::vector<char> fixed = {};       // per vertex; those are marked. Empty: none
  std::size_t edge_budget = 20'000;   // with more cells to draw, edges are left out
  std::size_t cell_budget = 100'000;  // with more, a pixel has the colour of its worst cell
};

/// A mesh, or several states of it side by side at the same scale, as a standalone SVG picture.
///
/// Cells are coloured by a metric, dark for bad and light for good; inverted ones are red. Planar
/// meshes are drawn flat. Surfaces, and the skins of volume meshes, are drawn in parallel
/// projection, lit from the viewer's upper left, without what is hidden; a skin's faces have the
/// colour of the cell behind them. Under each panel stand its worst and mean and how many cells
/// are inverted, inside included.
///
/// What is left out of large meshes is said in the picture. Files stay below a few MB.
/// @param orientation  of the input mesh, whatever the points: it judges what is inverted
/// @pre  at least one panel; every panel has as many points as the mesh
/// @throws InvalidOption  view and up are parallel, or zoom is empty
std::string mesh_picture(const Mesh& mesh, const Orientation& orientation,
                         const std::vector<Panel>& panels, const MeshPictureOptions& options = {});

}  // namespace evenmesh
