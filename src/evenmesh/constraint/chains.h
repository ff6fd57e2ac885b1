// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/curves.h"

namespace evenmesh {

/// Edges by vertex.
class EdgeNet {
 public:
  /// @param edges  each once, of two different vertices
  EdgeNet(std::size_t vertex_count, std::span<const VertexPair> edges);

  std::size_t vertex_count() const { return begins_.size() - 1; }
  /// The other ends of a vertex's edges, ascending.
  std::span<const Index> around(Index v) const {
    return {neighbours_.data() + begins_[v], neighbours_.data() + begins_[v + 1]};
  }
  std::size_t degree(Index v) const { return around(v).size(); }
  bool has(Index a, Index b) const;

 private:
  std::vector<Offset> begins_;
  std::vector<Index> neighbours_;
};

/// Vertices along a path of edges. A closed one leads from the last vertex back to the first.
struct Chain {
  std::vector<Index> vertices;  // at least 2, closed: at least 3; each once
  bool closed = false;
};

/// Cuts a net into chains where other than two edges meet, and at the ends given besides. Every
/// edge is in one chain.
///
/// A chain that comes back to the end it started from is not closed: it repeats that vertex. Those
/// between ends come first, by their lower ends, then closed ones, by their least vertices, which
/// they start with.
/// @param ends  per vertex
std::vector<Chain> cut_into_chains(const EdgeNet& net, std::span<const char> ends);

}  // namespace evenmesh
