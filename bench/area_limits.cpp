// SPDX-License-Identifier: MIT
#include "bench/area_limits.h"

#include <algorithm>

#include "bench/support/case.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh::bench {
namespace {

using Eigen::Vector2d;

constexpr double kNoLimit = 2e19;  // as large as general optimisers want it

double area(const std::array<Vector2d, 3>& corner) {
  const Vector2d b = corner[1] - corner[0];
  const Vector2d c = corner[2] - corner[0];
  return 0.5 * (b.x() * c.y() - b.y() * c.x());
}

// With respect to corner j: half the opposite side, turned to the left.
Vector2d area_slope(const std::array<Vector2d, 3>& corner, std::size_t j) {
  const Vector2d side = corner[(j + 2) % 3] - corner[(j + 1) % 3];
  return 0.5 * Vector2d(-side.y(), side.x());
}

std::vector<std::ptrdiff_t> number_unknowns(std::span<const Index> moving, std::size_t vertices) {
  std::vector<std::ptrdiff_t> first(vertices, -1);
  for (std::size_t i = 0; i < moving.size(); ++i) {
    first[moving[i]] = static_cast<std::ptrdiff_t>(2 * i);
  }
  return first;
}

std::vector<Index> vertices_where(const std::vector<char>& flags, bool value) {
  std::vector<Index> found;
  for (Index v = 0; v < flags.size(); ++v) {
    if ((flags[v] != 0) == value) found.push_back(v);
  }
  return found;
}

std::vector<char> boundary_vertices(const Mesh& mesh) {
  return boundary_of(mesh, find_orientation(mesh));
}

std::vector<Index> all_vertices(const Mesh& mesh) {
  return vertices_where(std::vector<char>(mesh.point_count(), 1), true);
}

}  // namespace

AreaLimits::AreaLimits(const Mesh& mesh, double least, Rim rim)
    : mesh_(mesh),
      least_(least),
      moving_(rim == Rim::fixed ? vertices_where(boundary_vertices(mesh), false)
                                : all_vertices(mesh)),
      on_circle_(rim == Rim::fixed ? std::vector<Index>()
                                   : vertices_where(boundary_vertices(mesh), true)),
      first_unknown_(number_unknowns(moving_, mesh.point_count())),
      hessian_(mesh, first_unknown_) {
  const auto add_row = [&](std::size_t row, Index vertex) {
    const std::ptrdiff_t first = first_unknown_[vertex];
    for (std::ptrdiff_t i = first; first >= 0 && i < first + 2; ++i) {
      jacobian_rows_.push_back(static_cast<int>(row));
      jacobian_columns_.push_back(static_cast<int>(i));
    }
  };
  if (!on_circle_.empty()) radius_ = mesh.points()[on_circle_.front()].head<2>().norm();
  const std::size_t cells = mesh.cells().size();
  for (std::size_t c = 0; c < cells; ++c) {
    for (const Index v : mesh.cells().vertices(c)) add_row(c, v);
  }
  for (std::size_t i = 0; i < on_circle_.size(); ++i) add_row(cells + i, on_circle_[i]);
}

void AreaLimits::bounds(std::span<double> lower, std::span<double> upper) const {
  const auto cells = static_cast<std::ptrdiff_t>(mesh_.cells().size());
  std::fill(lower.begin(), lower.begin() + cells, least_);
  std::fill(upper.begin(), upper.begin() + cells, kNoLimit);
  std::fill(lower.begin() + cells, lower.end(), 0.5 * radius_);
  std::fill(upper.begin() + cells, upper.end(), 0.5 * radius_);
}

std::vector<double> AreaLimits::start() const {
  std::vector<double> y;
  y.reserve(unknowns());
  for (const Index v : moving_) y.insert(y.end(), {mesh_.points()[v].x(), mesh_.points()[v].y()});
  return y;
}

Vector2d AreaLimits::position(Index vertex, std::span<const double> y) const {
  const std::ptrdiff_t first = first_unknown_[vertex];
  if (first < 0) return mesh_.points()[vertex].head<2>();
  const auto i = static_cast<std::size_t>(first);
  return {y[i], y[i + 1]};
}

std::array<Vector2d, 3> AreaLimits::corners(std::size_t cell, std::span<const double> y) const {
  const auto v = mesh_.cells().vertices(cell);
  return {position(v[0], y), position(v[1], y), position(v[2], y)};
}

double AreaLimits::cost(std::span<const double> y, std::span<double> gradient) const {
  std::fill(gradient.begin(), gradient.end(), 0.0);
  const auto add = [&](Index vertex, const Vector2d& slope) {
    const std::ptrdiff_t first = first_unknown_[vertex];
    if (first < 0) return;
    gradient[static_cast<std::size_t>(first)] += slope.x();
    gradient[static_cast<std::size_t>(first) + 1] += slope.y();
  };
  double sum = 0.0;
  for (std::size_t c = 0; c < mesh_.cells().size(); ++c) {
    const auto v = mesh_.cells().vertices(c);
    const auto corner = corners(c, y);
    std::array<double, 3> length{};
    for (std::size_t j = 0; j < 3; ++j) length[j] = (corner[(j + 1) % 3] - corner[j]).norm();
    const double mean = (length[0] + length[1] + length[2]) / 3.0;
    for (std::size_t j = 0; j < 3; ++j) {
      const double excess = length[j] - mean;
      sum += excess * excess;
      if (gradient.empty()) continue;
      const Vector2d slope = 2.0 * excess / length[j] * (corner[(j + 1) % 3] - corner[j]);
      add(v[(j + 1) % 3], slope);
      add(v[j], -slope);
    }
  }
  return sum;
}

void AreaLimits::evaluate(std::span<const double> y, std::span<double> values) const {
  const std::size_t cells = mesh_.cells().size();
  for (std::size_t c = 0; c < cells; ++c) values[c] = area(corners(c, y));
  for (std::size_t i = 0; i < on_circle_.size(); ++i) {
    values[cells + i] = position(on_circle_[i], y).squaredNorm() / (2.0 * radius_);
  }
}

void AreaLimits::jacobian(std::span<const double> y, std::span<double> values) const {
  std::size_t entry = 0;
  const auto add = [&](Index vertex, const Vector2d& slope) {
    if (first_unknown_[vertex] < 0) return;
    values[entry++] = slope.x();
    values[entry++] = slope.y();
  };
  for (std::size_t c = 0; c < mesh_.cells().size(); ++c) {
    const auto v = mesh_.cells().vertices(c);
    const auto corner = corners(c, y);
    for (std::size_t j = 0; j < 3; ++j) add(v[j], area_slope(corner, j));
  }
  for (const Index v : on_circle_) add(v, position(v, y) / radius_);
}

void AreaLimits::hessian(std::span<const double> y, double factor,
                         std::span<const double> multipliers, std::span<double> values) const {
  const std::size_t cells = mesh_.cells().size();
  hessian_.evaluate(y, factor, multipliers.first(cells), values);
  for (std::size_t i = 0; i < on_circle_.size(); ++i) {
    const std::ptrdiff_t first = first_unknown_[on_circle_[i]];
    values[hessian_.entry(first, first)] += multipliers[cells + i] / radius_;
    values[hessian_.entry(first + 1, first + 1)] += multipliers[cells + i] / radius_;
  }
}

}  // namespace evenmesh::bench
