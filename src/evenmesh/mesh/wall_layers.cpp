// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/wall_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "evenmesh/mesh/determinants.h"
#include "evenmesh/mesh/sides.h"

namespace evenmesh {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Two opposite sides of a cell by their local vertices, in such an order that edges lead from each
/// vertex of one to the same place in the other.
struct Slab {
  int count;  // of vertices of a side
  std::array<std::uint8_t, 4> bottom, top;
};

std::span<const Slab> slabs_of(CellKind kind) {
  static constexpr Slab kQuad[] = {{2, {0, 1}, {3, 2}}, {2, {1, 2}, {0, 3}}};
  static constexpr Slab kHex[] = {{4, {0, 1, 2, 3}, {4, 5, 6, 7}},
                                  {4, {0, 3, 7, 4}, {1, 2, 6, 5}},
                                  {4, {0, 1, 5, 4}, {3, 2, 6, 7}}};
  static constexpr Slab kWedge[] = {{3, {0, 1, 2}, {3, 4, 5}}};
  if (kind == CellKind::quad) return kQuad;
  if (kind == CellKind::hex) return kHex;
  if (kind == CellKind::wedge) return kWedge;
  return {};
}

/// A cell with one of its sides down.
struct Standing {
  std::uint32_t cell = kNone;
  std::uint8_t slab = 0;
  bool upside_down = false;
};

using SideKey = std::array<Index, 4>;  // vertices, ascending; the last may be missing

SideKey side_of(std::span<const Index> cell, const std::array<std::uint8_t, 4>& side, int count) {
  SideKey key;
  key.fill(kNone);
  for (int k = 0; k < count; ++k) {
    key[static_cast<std::size_t>(k)] = cell[side[static_cast<std::size_t>(k)]];
  }
  std::sort(key.begin(), key.end());
  return key;
}

class Finder {
 public:
  Finder(const Mesh& mesh, const Orientation& orientation)
      : mesh_(mesh), orientation_(orientation), layer_(mesh.cells().size(), 0) {
    const int dimension = orientation.type == MeshType::volume ? 3 : 2;
    for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
      const CellKind kind = mesh.cells().kind(c);
      if (traits(kind).dimension != dimension) continue;
      const auto slabs = slabs_of(kind);
      for (std::size_t s = 0; s < slabs.size(); ++s) {
        const Standing standing{static_cast<std::uint32_t>(c), static_cast<std::uint8_t>(s)};
        if (!(thickness_if_flat(standing) > 0.0)) continue;
        const auto cell = mesh.cells().vertices(c);
        sides_.push_back({side_of(cell, slabs[s].bottom, slabs[s].count), standing});
        sides_.push_back(
            {side_of(cell, slabs[s].top, slabs[s].count), {standing.cell, standing.slab, true}});
      }
    }
    std::sort(sides_.begin(), sides_.end(), [](const Entry& a, const Entry& b) {
      return a.key != b.key ? a.key < b.key : a.standing.cell < b.standing.cell;
    });
  }

  std::vector<char> find() {
    if (sides_.empty()) return std::move(layer_);
    const int dimension = orientation_.type == MeshType::volume ? 3 : 2;
    for_each_side(mesh_.cells(), mesh_.point_count(), dimension, [&](const Side& side) {
      if (side.cells == 1) climb_from(key_of(side));
    });
    return std::move(layer_);
  }

 private:
  struct Entry {
    SideKey key;
    Standing standing;
  };

  SideKey key_of(const Side& side) const {
    SideKey key;
    key.fill(kNone);
    if (orientation_.type == MeshType::volume) {
      const FaceVertices face = face_vertices(mesh_.cells(), side.uses[0].cell, side.uses[0].face);
      std::copy_n(face.vertices.begin(), face.count, key.begin());
    } else {
      key[0] = side.first;
      key[1] = side.uses[0].second;
    }
    std::sort(key.begin(), key.end());
    return key;
  }

  std::span<const Entry> entries_of(const SideKey& key) const {
    const auto range =
        std::equal_range(sides_.begin(), sides_.end(), Entry{key, {}},
                         [](const Entry& a, const Entry& b) { return a.key < b.key; });
    return {range.first, range.second};
  }

  void climb_from(const SideKey& boundary) {
    for (const Entry& entry : entries_of(boundary)) climb(entry.standing);
  }

  // The other flat cell that stands on a side.
  Standing partner_of(const Standing& own, const SideKey& key) const {
    Standing found;
    for (const Entry& entry : entries_of(key)) {
      if (entry.standing.cell == own.cell) continue;
      if (found.cell != kNone) return {};  // more than two
      found = entry.standing;
    }
    return found;
  }

  void climb(Standing at) {
    stack_.clear();
    double first = 0.0;
    double thickest = 0.0;
    while (at.cell != kNone) {
      const double thickness = thickness_if_flat(at);
      if (!(thickness > 0.0)) break;
      if (stack_.empty()) first = thickness;
      thickest = std::max(thickest, thickness);
      stack_.push_back(at.cell);
      if (stack_.size() > layer_.size()) break;  // a ring
      const Slab& slab = slabs_of(mesh_.cells().kind(at.cell))[at.slab];
      const auto& ahead = at.upside_down ? slab.bottom : slab.top;
      at = partner_of(at, side_of(mesh_.cells().vertices(at.cell), ahead, slab.count));
    }
    if (stack_.size() < kLeastLayerCells || thickest < kLayerGrowth * first) return;
    for (const std::uint32_t c : stack_) layer_[c] = 1;
  }

  // 0 if the cell is bad, or not flat.
  double thickness_if_flat(const Standing& at) const {
    const auto cell = mesh_.cells().vertices(at.cell);
    const Points x = mesh_.points();
    const Slab& slab = slabs_of(mesh_.cells().kind(at.cell))[at.slab];
    const auto n = static_cast<std::size_t>(slab.count);
    double thickness = 0.0;
    std::array<double, 2> width{};
    for (std::size_t k = 0; k < n; ++k) {
      thickness += (x[cell[slab.top[k]]] - x[cell[slab.bottom[k]]]).norm();
      for (const auto& side : {slab.bottom, slab.top}) {
        if (n == 2 && k == 1) continue;
        const double edge = (x[cell[side[(k + 1) % n]]] - x[cell[side[k]]]).norm();
        width[n == 4 ? k % 2 : 0] += edge;
      }
    }
    thickness /= static_cast<double>(n);
    width[0] /= n == 2 ? 2.0 : n == 4 ? 4.0 : 6.0;
    const double least = n == 4 ? std::min(width[0], width[1] / 4.0) : width[0];
    if (!(least >= kFlatLayer * thickness)) return 0.0;
    return least_scaled_jacobian(at.cell) >= kLeastLayerJacobian ? thickness : 0.0;
  }

  double least_scaled_jacobian(std::uint32_t cell) const {
    double least = std::numeric_limits<double>::infinity();
    for_determinants(mesh_.cells().kind(cell), mesh_.cells().vertices(cell), mesh_.points(),
                     orientation_.up(cell), orientation_.sign(cell),
                     [&](std::uint32_t, const auto& corner) {
                       double lengths = 0.0;
                       if constexpr (requires { corner.r; }) {
                         lengths = corner.p.norm() * corner.q.norm() * corner.r.norm();
                       } else if constexpr (requires { corner.p; }) {
                         lengths = corner.p.norm() * corner.q.norm();
                       }
                       const double value = lengths > 0.0 ? corner.determinant() / lengths : 0.0;
                       least = std::min(least, value);
                     });
    return least;
  }

  const Mesh& mesh_;
  const Orientation& orientation_;
  std::vector<char> layer_;
  std::vector<Entry> sides_;
  std::vector<std::uint32_t> stack_;
};

}  // namespace

std::vector<char> find_wall_layers(const Mesh& mesh, const Orientation& orientation) {
  if (orientation.type == MeshType::surface) return std::vector<char>(mesh.cells().size(), 0);
  return Finder(mesh, orientation).find();
}

}  // namespace evenmesh
