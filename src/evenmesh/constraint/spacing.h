// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/chains.h"
#include "evenmesh/constraint/prescribe.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/topology.h"

namespace evenmesh {

/// Places on the chain's own polyline at which neighbours are equally far apart, measured straight
/// from one to the next.
///
/// The places keep their order along the polyline, which is where the vertices are now. They are
/// at equal arc lengths at first, and each stretch then grows or shrinks with the distance it
/// spans, until distances agree to 1e-12 of their mean (1e-15 more per edge). On a line both are
/// the same. Where the polyline turns back on itself within a few edges there may be no such
/// places: the most even ones seen are returned. A chain without length stays as it is.
/// @return  one target per vertex of the chain, in its order; those of its ends (closed: of its
///          first vertex) are where these are, so that they stay there
std::vector<Target> space_evenly(Points points, const Chain& chain);

/// Splits the edges between selected vertices into chains.
///
/// The curves' edges come first: boundary, feature, non-manifold and interface edges (see
/// Topology). Other edges count if one of their ends is on no selected curve edge; they must make
/// simple paths. Chains end at corners, where the selection ends, and wherever other than two edges
/// meet; a closed one without such a place stays at its lowest vertex. Vertices with no selected
/// neighbour make no chain.
/// @param mask  per vertex: selected
/// @return  by lowest end (closed: lowest vertex)
/// @throws InvalidOption  more than two edges that are not on curves meet in a vertex that is no
///                        corner and on no curve: the selection is an area, not a path
/// @pre  topology is that of the mesh; mask has one entry per vertex
std::vector<Chain> chains_of(const Mesh& mesh, const Topology& topology,
                             std::span<const char> mask);

}  // namespace evenmesh
