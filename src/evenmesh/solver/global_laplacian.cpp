// SPDX-License-Identifier: MIT
#include "evenmesh/solver/global_laplacian.h"

#include <algorithm>
#include <cmath>

#include "evenmesh/solver/vectors.h"

namespace evenmesh {
namespace {

constexpr double kTolerance = 1e-12;  // of the residual, relative to the right-hand side
constexpr int kMostIterations = 500;

}  // namespace

GlobalLaplacian::GlobalLaplacian(const Mesh& mesh, const Motion& motion)
    : motion_(motion), stars_(mesh, motion) {}

bool GlobalLaplacian::is_unknown(Index v) const {
  return motion_.leader(v) == v && motion_.freedom(v) != Motion::Freedom::fixed;
}

SymmetricMatrix GlobalLaplacian::matrix() const {
  SymmetricMatrix matrix;
  matrix.diagonal.assign(motion_.size(), 0.0f);
  std::vector<std::uint32_t> columns;
  for (Index v = 0; v < motion_.size(); ++v) {
    columns.clear();
    if (is_unknown(v)) {
      const Star star = stars_.of(v);
      // A vertex without edges is a row of its own.
      matrix.diagonal[v] = std::max(1.0f, static_cast<float>(star.links.size()));
      for (const Link& link : star.links) {
        const Index other = motion_.leader(link.to);
        if (is_unknown(other)) columns.push_back(other);
      }
    }
    std::sort(columns.begin(), columns.end());
    auto& entries = matrix.off_diagonal.entries;
    const std::size_t first = entries.size();
    for (const std::uint32_t column : columns) {
      if (entries.size() > first && entries.back().column == column) {
        entries.back().value -= 1.0f;
      } else {
        entries.push_back({column, -1.0f});
      }
    }
    matrix.off_diagonal.start.push_back(entries.size());
  }
  return matrix;
}

std::vector<Projector> GlobalLaplacian::projectors(const Motion::Places& places) const {
  std::vector<Projector> result;
  for (const Index v : motion_.slots()) {
    if (!is_unknown(v)) continue;
    Eigen::Matrix3d columns;
    for (int axis = 0; axis < 3; ++axis) {
      columns.col(axis) = motion_.project(places, v, Vec3::Unit(axis));
    }
    result.push_back({v, columns.cast<float>()});
  }
  std::sort(result.begin(), result.end(),
            [](const Projector& a, const Projector& b) { return a.row < b.row; });
  return result;
}

// q = P L p, with p already projected
void GlobalLaplacian::apply(Workers& workers, const Motion::Places& places, Points p,
                            std::span<Vec3> q) const {
  for_ranges(workers, p.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto v = static_cast<Index>(i);
      q[i] = Vec3::Zero();
      if (!is_unknown(v)) continue;
      for (const Link& link : stars_.of(v).links) q[i] += p[i] - p[motion_.leader(link.to)];
      q[i] = motion_.project(places, v, q[i]);
    }
  });
}

// Conjugate gradients, with the form of beta that bears a preconditioner in single precision.
std::vector<Vec3> GlobalLaplacian::solve(Workers& workers, const Motion::Places& places,
                                         std::vector<Vec3> residual) const {
  const std::size_t n = residual.size();
  std::vector<Vec3> y(n, Vec3::Zero()), z(n), p(n), q(n), old;
  Multigrid preconditioner(workers, matrix(), projectors(places));
  const auto precondition = [&] {
    preconditioner.apply(workers, residual, z);
    motion_.project(workers, places, z);
  };
  precondition();
  p = z;
  double product = dot(workers, residual, z);
  const double enough = kTolerance * kTolerance * product;
  for (int i = 0; i < kMostIterations && product > enough; ++i) {
    apply(workers, places, p, q);
    const double curvature = dot(workers, p, q);
    if (!(curvature > 0.0)) break;
    const double step = product / curvature;
    old = residual;
    add(workers, y, step, p, y);
    add(workers, residual, -step, q, residual);
    precondition();
    const double next = dot(workers, residual, z);
    const double beta = std::max(0.0, (next - dot(workers, old, z)) / product);
    add(workers, z, beta, p, p);
    product = next;
  }
  return y;
}

void GlobalLaplacian::sweep(Workers& workers, std::vector<Vec3>& x, Motion::Places& places) {
  const std::vector<Vec3> x_0 = x;
  std::vector<Vec3> pull(x.size(), Vec3::Zero());
  for_ranges(workers, x.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto v = static_cast<Index>(i);
      if (!is_unknown(v)) continue;
      for (const Link& link : stars_.of(v).links) pull[i] += x_0[link.to] - x_0[link.from];
      pull[i] = motion_.project(places, v, pull[i]);
    }
  });
  const std::vector<Vec3> y = solve(workers, places, std::move(pull));
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (!y[v].isZero(0.0)) x[v] += y[v];
  }
  const Motion::Places from = places;
  motion_.retract(workers, x_0, from, x, places);
}

}  // namespace evenmesh
