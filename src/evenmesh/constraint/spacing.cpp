// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/spacing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/cell_edges.h"
#include "evenmesh/mesh/curves.h"

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

/// The edges of curves both of whose ends are selected.
Edges curve_edges(const Topology& topology, std::span<const char> mask) {
  Edges result;
  for (const VertexPair& edge : topology.curves) {
    if (mask[edge[0]] && mask[edge[1]]) result.push_back(edge);
  }
  return result;
}

/// The other edges both of whose ends are selected and not both on curves, each once.
Edges plain_edges(const Cells& cells, std::span<const char> mask,
                  const std::vector<char>& on_curve) {
  Edges result;
  for_each_cell_edge(cells, [&](Index first, Index second) {
    const auto [a, b] = std::minmax(first, second);
    if (a == b || !mask[a] || !mask[b] || (on_curve[a] && on_curve[b])) return;
    result.push_back({a, b});
  });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// ---- chains -------------------------------------------------------------------------------------

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
  for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
    result.push_back({chain.vertices[i], places[i]});
  }
  return result;
}

std::vector<Chain> chains_of(const Mesh& mesh, const Topology& topology,
                             std::span<const char> mask) {
  assert(mask.size() == mesh.point_count());
  Edges edges = curve_edges(topology, mask);
  std::vector<char> on_curve(mesh.point_count(), 0);
  mark(edges, on_curve);
  const Edges plain = plain_edges(mesh.cells(), mask, on_curve);
  std::vector<char> off_curve(mesh.point_count(), 0);
  mark(plain, off_curve);
  edges.insert(edges.end(), plain.begin(), plain.end());

  const EdgeNet net(mesh.point_count(), edges);
  std::vector<char> ends(mesh.point_count(), 0);
  for (Index v = 0; v < ends.size(); ++v) {
    const bool branches = net.degree(v) > 2;
    if (branches && !on_curve[v] && !topology.corners[v]) fail_at_branch(v, net.degree(v));
    ends[v] = topology.corners[v] || (on_curve[v] && off_curve[v]);
  }
  std::vector<Chain> chains = cut_into_chains(net, ends);
  for (Chain& chain : chains) {
    if (chain.closed || chain.vertices.front() != chain.vertices.back()) continue;
    chain.vertices.pop_back();
    chain.closed = true;
  }
  std::stable_sort(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) {
    return a.vertices.front() < b.vertices.front();
  });
  return chains;
}

}  // namespace evenmesh
