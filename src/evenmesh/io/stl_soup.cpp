// SPDX-License-Identifier: MIT
#include "evenmesh/io/stl_soup.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "evenmesh/base/error.h"

namespace evenmesh {

StlSoup::StlSoup(const ReadOptions& options) : tolerance_(options.weld_tolerance) {
  if (!(tolerance_ >= 0.0) || !std::isfinite(tolerance_)) {
    throw InvalidOption(
        fmt::format("the weld tolerance is {}; give a length of 0 or more", tolerance_));
  }
}

void StlSoup::add(const std::array<Vec3, 3>& corners) {
  for (const Vec3& corner : corners) corners_.push_back(welder_.add(corner));
}

Mesh StlSoup::take_mesh(const std::vector<std::uint32_t>& groups) {
  std::vector<Vec3> points = welder_.take_points();
  if (tolerance_ > 0.0) {
    const std::vector<Index> numbers = merge_close(points, tolerance_);
    for (Index& corner : corners_) corner = numbers[corner];
  }
  Cells cells;
  cells.reserve(size(), corners_.size());
  for (std::size_t i = 0; i < size(); ++i) {
    const std::span<const Index> facet(corners_.data() + 3 * i, 3);
    cells.add(CellKind::triangle, facet, groups.empty() ? 0 : groups[i]);
  }
  return {std::move(points), std::move(cells)};
}

Vec3 facet_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  // Scaled first: products of very large or very small lengths leave the range of double.
  const Vec3 ab = 0.5 * b - 0.5 * a;
  const Vec3 ac = 0.5 * c - 0.5 * a;
  const double longest = std::max(ab.cwiseAbs().maxCoeff(), ac.cwiseAbs().maxCoeff());
  if (longest == 0.0) return Vec3::Zero();
  const Vec3 normal = (ab / longest).cross(ac / longest);
  const double length = normal.norm();
  if (!(length > 0.0)) return Vec3::Zero();
  return (normal / length).array() + 0.0;  // no -0
}

std::string StlPatch::vertex_name(Index vertex) const {
  const auto all = mesh_.cells().corners();
  const auto first = static_cast<std::size_t>(std::ranges::find(all, vertex) - all.begin());
  return fmt::format("vertex {} (corner {} of {})", vertex + 1, first % 3 + 1,
                     cell_name(first / 3));
}

bool StlPatch::moved(std::size_t facet, Points points) const {
  return std::ranges::any_of(mesh_.cells().vertices(facet), [&](Index vertex) {
    return points[vertex] != mesh_.points()[vertex];
  });
}

std::array<Vec3, 3> StlPatch::corners(std::size_t facet, Points points) const {
  const auto vertices = mesh_.cells().vertices(facet);
  return {points[vertices[0]], points[vertices[1]], points[vertices[2]]};
}

}  // namespace evenmesh
