// SPDX-License-Identifier: MIT
#include "evenmesh/solver/deviation_limit.h"

#include <algorithm>
#include <cmath>

#include "evenmesh/mesh/sides.h"

namespace evenmesh {

DeviationLimit::DeviationLimit(Workers&, const Mesh& input, MeshType type, double limit)
    : limit_(limit), points_(input.point_count()) {
  const Cells& cells = input.cells();
  const auto add_face = [&](std::span<const Index> face) {
    if (face.size() == 3) {
      parts_.push_back({face[0], face[1], face[2]});
      return;
    }
    const auto centre = static_cast<Index>(points_ + rings_.size());
    for (std::size_t i = 0; i < face.size(); ++i) {
      parts_.push_back({face[i], face[(i + 1) % face.size()], centre});
    }
    rings_.emplace_back(face.begin(), face.end());
  };
  if (type == MeshType::surface) {
    for (std::size_t c = 0; c < cells.size(); ++c) add_face(cells.vertices(c));
  } else if (type == MeshType::volume) {
    for_each_side(cells, points_, 3, [&](const Side& side) {
      if (side.cells != 1) return;
      const FaceVertices face = face_vertices(cells, side.uses[0].cell, side.uses[0].face);
      if (face.count > 0) add_face(face.span());
    });
  } else {
    for_each_side(cells, points_, 2, [&](const Side& side) {
      const bool border = std::any_of(side.uses.begin(), side.uses.end(), [&](const SideUse& use) {
        return cells.group(use.cell) != cells.group(side.uses[0].cell);
      });
      if (side.cells != 1 && !border) return;
      parts_.push_back({side.first, side.uses[0].second, side.uses[0].second});
    });
  }
  input_ = with_centres(input.points());
}

std::vector<Vec3> DeviationLimit::with_centres(Points points) const {
  std::vector<Vec3> all(points.begin(), points.end());
  all.reserve(points.size() + rings_.size());
  for (const auto& ring : rings_) {
    Vec3 sum = Vec3::Zero();
    for (const Index v : ring) sum += points[v];
    all.push_back(sum / static_cast<double>(ring.size()));
  }
  return all;
}

Deviation DeviationLimit::deviation(Workers& workers, Points points) const {
  return deviation_between(with_centres(points), parts_, input_, parts_, workers);
}

double DeviationLimit::measure(Workers& workers, Points points) const {
  return parts_.empty() ? 0.0 : deviation(workers, points).greatest();
}

void DeviationLimit::mark(Workers& workers, Points points, std::vector<char>& marked) const {
  if (parts_.empty() || !std::isfinite(limit_)) return;
  const Deviation found = deviation(workers, points);
  if (found.greatest() <= limit_) return;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const double far = std::max(found.a_from_b.of_triangle[p], found.b_from_a.of_triangle[p]);
    if (far <= limit_) continue;
    for (const Index v : parts_[p]) {
      if (v < points_) {
        marked[v] = 1;
      } else {
        for (const Index corner : rings_[v - points_]) marked[corner] = 1;
      }
    }
  }
}

}  // namespace evenmesh
