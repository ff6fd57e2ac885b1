// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "evenmesh/cost/cost.h"

namespace evenmesh {

/// The edges of every cell of a block, as local vertex numbers.
inline std::vector<LocalEdge> local_edges(const CellBlock& cells) {
  std::vector<LocalEdge> edges(
      static_cast<std::size_t>(edge_count(cells.kind, cells.vertices_per_cell)));
  for (std::size_t j = 0; j < edges.size(); ++j) {
    edges[j] = edge(cells.kind, cells.vertices_per_cell, static_cast<int>(j));
  }
  return edges;
}

namespace detail {

// An edge shorter than this has no direction worth the name: its pull is as if it were this long.
inline constexpr double kShortestEdge = 1e-150;

// Triangles and quads, by far the most: the number of edges is known to the compiler.
template <std::size_t Count, typename Function>
double sum_over_rings(const CellBlock& cells, Points x, double weight, std::span<Vec3> gradient,
                      const Function& function) {
  double sum = 0.0;
  const Index* const end = cells.vertices.data() + cells.vertices.size();
  for (const Index* cell = cells.vertices.data(); cell != end; cell += Count) {
    std::array<Vec3, Count> side;
    std::array<double, Count> length;
    std::array<double, Count> slope;
    for (std::size_t j = 0; j < Count; ++j) {
      side[j] = x[cell[j + 1 == Count ? 0 : j + 1]] - x[cell[j]];
    }
    for (std::size_t j = 0; j < Count; ++j) length[j] = side[j].norm();
    sum += function(std::span<const double>(length), std::span<double>(slope));

    if (gradient.empty()) continue;
    for (std::size_t j = 0; j < Count; ++j) {
      side[j] *= weight * slope[j] / std::max(length[j], kShortestEdge);
    }
    for (std::size_t j = 0; j < Count; ++j) {
      gradient[cell[j]] += side[j == 0 ? Count - 1 : j - 1] - side[j];
    }
  }
  return weight * sum;
}

template <typename Function>
double sum_over_cells(const CellBlock& cells, Points x, double weight, std::span<Vec3> gradient,
                      const Function& function) {
  const std::vector<LocalEdge> edges = local_edges(cells);
  std::vector<double> length(edges.size());
  std::vector<double> slope(edges.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto cell = cells.cell(i);
    for (std::size_t j = 0; j < edges.size(); ++j) {
      length[j] = (x[cell[edges[j].b]] - x[cell[edges[j].a]]).norm();
    }
    sum += function(std::span<const double>(length), std::span<double>(slope));

    if (gradient.empty()) continue;
    for (std::size_t j = 0; j < edges.size(); ++j) {
      const Index a = cell[edges[j].a];
      const Index b = cell[edges[j].b];
      const Vec3 pull = (weight * slope[j] / std::max(length[j], kShortestEdge)) * (x[b] - x[a]);
      gradient[a] -= pull;
      gradient[b] += pull;
    }
  }
  return weight * sum;
}

}  // namespace detail

/// The weight times the sum over a block's cells of a function of the cell's edge lengths.
/// @param weight, gradient  as in Cost::evaluate
/// @param function  value = function(lengths, slopes): gets the lengths of the cell's edges in
///                  the order of its kind, and fills in the derivative with respect to each
template <typename Function>
double sum_over_edge_lengths(const CellBlock& cells, Points x, double weight,
                             std::span<Vec3> gradient, const Function& function) {
  if (cells.kind == CellKind::triangle) {
    return detail::sum_over_rings<3>(cells, x, weight, gradient, function);
  }
  if (cells.kind == CellKind::quad)
    return detail::sum_over_rings<4>(cells, x, weight, gradient, function);
  return detail::sum_over_cells(cells, x, weight, gradient, function);
}

}  // namespace evenmesh
