// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/mesh.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include <fmt/core.h>

#include "evenmesh/base/error.h"

namespace evenmesh {

void Cells::add(CellKind kind, std::span<const Index> vertices, std::uint32_t group) {
  assert(traits(kind).vertices == 0
             ? vertices.size() >= 3
             : vertices.size() == static_cast<std::size_t>(traits(kind).vertices));
  if (group != 0 && groups_.empty()) groups_.assign(kinds_.size(), 0);
  corners_.insert(corners_.end(), vertices.begin(), vertices.end());
  offsets_.push_back(corners_.size());
  kinds_.push_back(kind);
  if (group != 0 || !groups_.empty()) groups_.push_back(group);
}

void Cells::set_group(std::size_t cell, std::uint32_t group) {
  if (groups_.empty() && group == 0) return;
  groups_.resize(kinds_.size(), 0);
  groups_[cell] = group;
}

void Cells::reserve(std::size_t cells, std::size_t corners) {
  corners_.reserve(corners);
  offsets_.reserve(cells + 1);
  kinds_.reserve(cells);
}

Mesh::Mesh(std::vector<Vec3> points, Cells cells)
    : points_(std::move(points)), cells_(std::make_shared<const Cells>(std::move(cells))) {
  if (points_.size() >= std::numeric_limits<Index>::max()) {
    throw InvalidMesh(
        fmt::format("{} points are more than 32-bit vertex numbers can count", points_.size()));
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!points_[i].allFinite()) {
      throw InvalidMesh(fmt::format("point {} has a coordinate that is not finite", i));
    }
  }
  const auto corners = cells_->corners();
  const auto bad =
      std::find_if(corners.begin(), corners.end(), [&](Index v) { return v >= points_.size(); });
  if (bad == corners.end()) return;
  const auto offsets = cells_->offsets();
  const auto corner = static_cast<Offset>(bad - corners.begin());
  const auto cell = std::upper_bound(offsets.begin(), offsets.end(), corner) - offsets.begin() - 1;
  throw InvalidMesh(fmt::format("{} {} uses vertex {}, but the mesh has {} points",
                                traits(cells_->kind(static_cast<std::size_t>(cell))).name, cell,
                                *bad, points_.size()));
}

void Mesh::set_points(std::vector<Vec3> points) {
  assert(points.size() == points_.size());
  points_ = std::move(points);
}

}  // namespace evenmesh
