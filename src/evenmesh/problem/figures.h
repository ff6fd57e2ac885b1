// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "evenmesh/constraint/phrases.h"
#include "evenmesh/geometry/track.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"

namespace evenmesh {

/// The figure that numbers give, in the order of SlidePhrase::numbers.
/// @pre  on is a figure (not features, boundary, surface) and the numbers are as parse_slide() has
///       them
std::shared_ptr<const Track> make_figure(SlideOn on, std::span<const double> numbers);

/// Some vertices that hang together and the figure they lie on.
struct FittedPiece {
  std::vector<Index> vertices;
  std::shared_ptr<const Track> figure;
  double greatest_distance = 0.0;  // of a vertex from the figure, mesh length unit
  Index farthest = 0;              // that vertex
};

/// Fits a figure to each piece of a selection.
///
/// Vertices that may slide hang together through edges: for lines and circles along the curves of
/// the topology, for the other figures over the skin, where both vertices are on such. Selected
/// neighbours that may not slide are fitted along with the piece: the corners at the ends of a
/// line.
/// @param selected  per vertex
/// @param sliding   per vertex: those of the selection that may slide
/// @param on        line, plane, circle, cylinder or sphere
/// @return  by least vertex; without a figure where a piece has too few vertices for one
std::vector<FittedPiece> fit_figures(const Mesh& mesh, const Orientation& orientation,
                                     const Topology& topology, SlideOn on,
                                     std::span<const char> selected, std::span<const char> sliding);

}  // namespace evenmesh
