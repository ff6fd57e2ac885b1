// SPDX-License-Identifier: MIT
#include "evenmesh/io/second_order.h"

#include <array>
#include <vector>

#include <fmt/core.h>

namespace evenmesh {
namespace {

/// Local numbers of the corners around a node.
using Leaders = std::vector<std::uint8_t>;

std::size_t corners_of(CellKind kind) { return static_cast<std::size_t>(traits(kind).vertices); }

/// Where the j-th node behind the corners has its edge in traits(kind).edges.
std::vector<std::uint8_t> edges_in_order(CellKind kind, EdgeOrder order) {
  if (order == EdgeOrder::gmsh) {
    if (kind == CellKind::tet) return {0, 1, 2, 3, 5, 4};
    if (kind == CellKind::hex) return {0, 3, 8, 1, 9, 2, 10, 11, 4, 7, 5, 6};
    if (kind == CellKind::wedge) return {0, 2, 6, 1, 7, 8, 3, 5, 4};
    if (kind == CellKind::pyramid) return {0, 3, 4, 1, 5, 2, 6, 7};
  }
  if (order == EdgeOrder::nastran) {
    if (kind == CellKind::hex) return {0, 1, 2, 3, 8, 9, 10, 11, 4, 5, 6, 7};
    if (kind == CellKind::wedge) return {0, 1, 2, 6, 7, 8, 3, 4, 5};
  }
  std::vector<std::uint8_t> all(traits(kind).edges.size());
  for (std::size_t j = 0; j < all.size(); ++j) all[j] = static_cast<std::uint8_t>(j);
  return all;
}

/// The quads whose middles follow behind those of the edges.
std::vector<Leaders> quads_in_order(CellKind kind, EdgeOrder order) {
  switch (kind) {
    case CellKind::hex:
      if (order == EdgeOrder::gmsh) {
        return {{0, 1, 2, 3}, {0, 1, 5, 4}, {0, 3, 7, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}};
      }
      return {{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 2, 3}, {4, 5, 6, 7}};
    case CellKind::wedge:
      if (order == EdgeOrder::gmsh) return {{0, 1, 4, 3}, {0, 2, 5, 3}, {1, 2, 5, 4}};
      return {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
    case CellKind::pyramid:
      return {{0, 1, 2, 3}};
    default:
      return {};
  }
}

/// The corners around each node behind the corners.
std::vector<Leaders> make_leaders(CellKind kind, EdgeOrder order) {
  std::vector<Leaders> result;
  for (const std::uint8_t j : edges_in_order(kind, order)) {
    const CellTraits::Edge edge = traits(kind).edges[j];
    result.push_back({edge.a, edge.b});
  }
  for (const Leaders& quad : quads_in_order(kind, order)) result.push_back(quad);
  Leaders whole;
  for (std::size_t i = 0; i < corners_of(kind); ++i) whole.push_back(static_cast<std::uint8_t>(i));
  result.push_back(whole);
  return result;
}

const std::vector<Leaders>& leaders_of(CellKind kind, EdgeOrder order) {
  constexpr int kOrders = 3;
  static const auto kTable = [] {
    std::array<std::vector<Leaders>, kCellKinds * kOrders> table;
    for (int k = 0; k < kCellKinds; ++k) {
      if (static_cast<CellKind>(k) == CellKind::polygon) continue;
      for (int o = 0; o < kOrders; ++o) {
        table[static_cast<std::size_t>(k * kOrders + o)] =
            make_leaders(static_cast<CellKind>(k), static_cast<EdgeOrder>(o));
      }
    }
    return table;
  }();
  return kTable[static_cast<std::size_t>(static_cast<int>(kind) * kOrders +
                                         static_cast<int>(order))];
}

}  // namespace

void add_followers(CellKind kind, EdgeOrder order, std::span<const Index> nodes,
                   Followers& followers) {
  if (kind == CellKind::polygon) return;
  const std::vector<Leaders>& leaders = leaders_of(kind, order);
  const std::size_t corners = corners_of(kind);
  std::array<Index, 8> around{};
  for (std::size_t i = corners; i < nodes.size(); ++i) {
    if (nodes[i] == kNoNode) continue;
    const Leaders& local = leaders[i - corners];
    for (std::size_t k = 0; k < local.size(); ++k) around[k] = nodes[local[k]];
    followers.add(nodes[i], std::span(around).first(local.size()));
  }
}

std::optional<Index> torn_vertex(const Followers& followers, const Cells& cells,
                                 std::size_t vertices) {
  if (followers.empty()) return {};
  std::vector<char> is_corner(vertices, 0);
  for (const Index v : cells.corners()) is_corner[v] = 1;
  for (std::size_t i = 0; i < followers.size(); ++i) {
    if (is_corner[followers.vertex(i)]) return followers.vertex(i);
  }
  return {};
}

std::string torn_message(std::string_view vertex, std::string_view cell) {
  return fmt::format(
      "{} is a corner of one {} and in the middle of an edge of another; the mesh "
      "would tear there when it moves",
      vertex, cell);
}

}  // namespace evenmesh
