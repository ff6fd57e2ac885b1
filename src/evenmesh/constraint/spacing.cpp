// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/spacing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/curves.h"
#include "evenmesh/mesh/extent.h"
#include "evenmesh/mesh/sides.h"

namespace evenmesh {
namespace {

// ---- places on a polyline -----------------------------------------------------------------------

class Polyline {
 public:
  explicit Polyline(std::vector<Vec3> points) : points_(std::move(points)) {
    arc_lengths_.push_back(0.0);
    for (std::size_t i = 1; i < points_.size(); ++i) {
      arc_lengths_.push_back(arc_lengths_.back() + (points_[i] - points_[i - 1]).norm());
    }
  }

  double length() const { return arc_lengths_.back(); }
  const std::vector<Vec3>& points() const { return points_; }

  /// The places that stretches of the given lengths, one after the other, lead to.
  /// @pre  the lengths add up to length()
  std::vector<Vec3> places(std::span<const double> stretches) const {
    std::vector<Vec3> result{points_.front()};
    double s = 0.0;
    std::size_t i = 1;  // the end of the segment that s is on
    for (std::size_t k = 0; k + 1 < stretches.size(); ++k) {
      s += stretches[k];
      while (i + 1 < points_.size() && arc_lengths_[i] < s) ++i;
      const double whole = arc_lengths_[i] - arc_lengths_[i - 1];
      const double part = whole > 0.0 ? (s - arc_lengths_[i - 1]) / whole : 0.0;
      result.push_back(points_[i - 1] + std::min(part, 1.0) * (points_[i] - points_[i - 1]));
    }
    result.push_back(points_.back());
    return result;
  }

 private:
  std::vector<Vec3> points_;
  std::vector<double> arc_lengths_;
};

std::vector<double> distances(const std::vector<Vec3>& places) {
  std::vector<double> result;
  for (std::size_t i = 1; i < places.size(); ++i) {
    result.push_back((places[i] - places[i - 1]).norm());
  }
  return result;
}

double sum(std::span<const double> values) {
  double result = 0.0;
  for (const double value : values) result += value;
  return result;
}

/// By how much distances differ from their mean at most, in parts of it.
double unevenness(std::span<const double> distances, double mean) {
  double largest = 0.0;
  for (const double d : distances) largest = std::max(largest, std::abs(d - mean));
  return largest / mean;
}

/// Stretches that span too much get shorter, others longer; together they stay as long.
void adjust(std::span<double> stretches, std::span<const double> distances, double mean,
            double length) {
  constexpr double kMost = 2.0;  // per round
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    stretches[k] *= distances[k] * kMost > mean ? mean / distances[k] : kMost;
  }
  const double factor = length / sum(stretches);
  for (double& stretch : stretches) stretch *= factor;
}

std::vector<Vec3> even_places(const Polyline& line, std::size_t stretch_count) {
  constexpr int kRounds = 500;
  const double count = static_cast<double>(stretch_count);
  const double even = 1e-12 + 1e-15 * count;  // arc lengths of many edges have fewer digits
  std::vector<double> stretches(stretch_count, line.length() / count);
  std::vector<Vec3> best;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds && least > even; ++round) {
    std::vector<Vec3> places = line.places(stretches);
    const std::vector<double> spans = distances(places);
    const double mean = sum(spans) / count;
    const double uneven = mean > 0.0 ? unevenness(spans, mean) : 0.0;
    adjust(stretches, spans, mean, line.length());
    if (uneven >= least) continue;
    least = uneven;
    best = std::move(places);
  }
  return best;
}

// ---- edges --------------------------------------------------------------------------------------

using Edges = std::vector<VertexPair>;

/// The faces of a volume mesh that only one cell has; the cells themselves otherwise.
Cells outer_surface(const Mesh& mesh) {
  const Cells& cells = mesh.cells();
  const bool is_volume = std::any_of(cells.kinds().begin(), cells.kinds().end(),
                                     [](CellKind kind) { return traits(kind).dimension == 3; });
  if (!is_volume) return cells;
  Cells skin;
  for_each_side(cells, mesh.point_count(), 3, [&](const Side& side) {
    if (side.cells > 1) return;
    const SideUse& use = side.uses[0];
    const FaceVertices face = face_vertices(cells, use.cell, use.face);
    skin.add(face.count == 3 ? CellKind::triangle : CellKind::quad, face.span(),
             cells.group(use.cell));
  });
  return skin;
}

bool is_bent(const Mesh& mesh, const Cells& surface, const Side& side, double cosine) {
  const SideUse& a = side.uses[0];
  const SideUse& b = side.uses[1];
  const Vec3 normal_a = unit_normal(mesh.points(), surface.vertices(a.cell));
  const Vec3 normal_b = unit_normal(mesh.points(), surface.vertices(b.cell));
  if (normal_a.isZero(0.0) || normal_b.isZero(0.0)) return false;
  constexpr double kRounding = 1e-12;
  const double product = normal_a.dot(normal_b);
  return (a.forward != b.forward ? product : -product) < cosine - kRounding;
}

/// The edges of boundaries, features and the like both of whose ends are selected.
Edges curve_edges(const Mesh& mesh, const Topology& topology, std::span<const char> mask,
                  const TopologyOptions& options) {
  const Cells surface = outer_surface(mesh);
  const double cosine = std::cos(options.feature_angle * std::numbers::pi / 180.0);
  Edges result;
  for_each_side(surface, mesh.point_count(), 2, [&](const Side& side) {
    const VertexPair edge{side.first, side.uses[0].second};
    if (!mask[edge[0]] || !mask[edge[1]]) return;
    bool on_curve = side.cells != 2;
    if (side.is_shared_by_two()) {
      const bool between_groups =
          surface.group(side.uses[0].cell) != surface.group(side.uses[1].cell);
      const bool may_bend = topology.features[edge[0]] && topology.features[edge[1]];
      on_curve = between_groups || (may_bend && is_bent(mesh, surface, side, cosine));
    }
    if (on_curve) result.push_back(edge);
  });
  return result;
}

/// The other edges both of whose ends are selected and not both on curves, each once.
Edges plain_edges(const Cells& cells, std::span<const char> mask,
                  const std::vector<char>& on_curve) {
  Edges result;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto vertices = cells.vertices(c);
    const int count = static_cast<int>(vertices.size());
    for (int j = 0; j < edge_count(cells.kind(c), count); ++j) {
      const LocalEdge local = edge(cells.kind(c), count, j);
      const auto [a, b] = std::minmax(vertices[static_cast<std::size_t>(local.a)],
                                      vertices[static_cast<std::size_t>(local.b)]);
      if (a == b || !mask[a] || !mask[b] || (on_curve[a] && on_curve[b])) continue;
      result.push_back({a, b});
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// ---- chains
// ---------------------------------------------------------------------------------------

/// Edges as a graph that gives away its paths one by one.
class Network {
 public:
  Network(const Edges& edges, std::size_t vertex_count)
      : begins_(vertex_count + 1, 0), neighbours_(2 * edges.size()) {
    for (const auto& [a, b] : edges) {
      ++begins_[a + 1];
      ++begins_[b + 1];
    }
    for (std::size_t v = 1; v < begins_.size(); ++v) begins_[v] += begins_[v - 1];
    std::vector<Offset> ends(begins_.begin(), begins_.end() - 1);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto [a, b] = edges[i];
      neighbours_[ends[a]++] = {b, i};
      neighbours_[ends[b]++] = {a, i};
    }
    for (std::size_t v = 0; v < vertex_count; ++v) {
      std::sort(neighbours_.begin() + static_cast<std::ptrdiff_t>(begins_[v]),
                neighbours_.begin() + static_cast<std::ptrdiff_t>(begins_[v + 1]));
    }
    taken_.assign(edges.size(), 0);
  }

  std::size_t degree(std::size_t vertex) const { return begins_[vertex + 1] - begins_[vertex]; }

  /// Appends the chains that start at a vertex and were not taken before.
  /// @param is_end  per vertex: chains end there
  void take_chains(Index start, const std::vector<char>& is_end, std::vector<Chain>& chains) {
    for (Offset i = begins_[start]; i < begins_[start + 1]; ++i) {
      if (!taken_[neighbours_[i].edge]) chains.push_back(take_chain(start, neighbours_[i], is_end));
    }
  }

 private:
  struct Neighbour {
    Index vertex;
    std::size_t edge;
    auto operator<=>(const Neighbour&) const = default;
  };

  Chain take_chain(Index start, Neighbour step, const std::vector<char>& is_end) {
    Chain chain{{start}, false};
    taken_[step.edge] = 1;
    while (step.vertex != start) {
      const Index at = step.vertex;
      chain.vertices.push_back(at);
      if (is_end[at]) return chain;
      const Neighbour& first = neighbours_[begins_[at]];  // one of two
      step = taken_[first.edge] ? neighbours_[begins_[at] + 1] : first;
      taken_[step.edge] = 1;
    }
    chain.closed = true;
    return chain;
  }

  std::vector<Offset> begins_;
  std::vector<Neighbour> neighbours_;
  std::vector<char> taken_;
};

void mark(const Edges& edges, std::vector<char>& flags) {
  for (const auto& [a, b] : edges) flags[a] = flags[b] = 1;
}

[[noreturn]] void fail_at_branch(Index vertex, std::size_t degree) {
  throw InvalidOption(fmt::format(
      "equal spacing needs paths of edges, but {} selected edges meet at vertex {} (counted from "
      "0); select boundary, features or single lines of vertices",
      degree, vertex));
}

}  // namespace

std::vector<Target> space_evenly(Points points, const Chain& chain) {
  assert(chain.vertices.size() >= (chain.closed ? 3 : 2));
  std::vector<Vec3> corners;
  for (const Index v : chain.vertices) corners.push_back(points[v]);
  if (chain.closed) corners.push_back(corners.front());
  const std::size_t stretches = corners.size() - 1;
  const Polyline line(std::move(corners));
  const std::vector<Vec3> places =
      line.length() > 0.0 ? even_places(line, stretches) : line.points();
  std::vector<Target> result;
  for (std::size_t i = 1; i < stretches; ++i) result.push_back({chain.vertices[i], places[i]});
  return result;
}

std::vector<Chain> chains_of(const Mesh& mesh, const Topology& topology, std::span<const char> mask,
                             const TopologyOptions& options) {
  assert(mask.size() == mesh.point_count());
  Edges edges = curve_edges(mesh, topology, mask, options);
  std::vector<char> on_curve(mesh.point_count(), 0);
  mark(edges, on_curve);
  const Edges plain = plain_edges(mesh.cells(), mask, on_curve);
  std::vector<char> off_curve(mesh.point_count(), 0);
  mark(plain, off_curve);
  edges.insert(edges.end(), plain.begin(), plain.end());

  Network network(edges, mesh.point_count());
  std::vector<char> is_end(mesh.point_count(), 0);
  for (std::size_t v = 0; v < is_end.size(); ++v) {
    const bool branches = network.degree(v) > 2;
    if (branches && !on_curve[v] && !topology.corners[v]) {
      fail_at_branch(static_cast<Index>(v), network.degree(v));
    }
    is_end[v] = topology.corners[v] || network.degree(v) != 2 || (on_curve[v] && off_curve[v]);
  }
  std::vector<Chain> chains;
  for (Index v = 0; v < is_end.size(); ++v) {
    if (is_end[v]) network.take_chains(v, is_end, chains);
  }
  // What is left has no ends.
  for (Index v = 0; v < is_end.size(); ++v) network.take_chains(v, is_end, chains);
  std::stable_sort(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) {
    return a.vertices.front() < b.vertices.front();
  });
  return chains;
}

}  // namespace evenmesh
