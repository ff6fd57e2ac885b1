// SPDX-License-Identifier: MIT
#include "evenmesh/solver/newton.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "evenmesh/mesh/extent.h"
#include "evenmesh/solver/second_derivatives.h"

namespace evenmesh {
namespace {

// Added to the diagonal of a clamped matrix, relative to it: it may be singular.
constexpr double kLift = 1e-9;

std::vector<Vec3> positions_of(std::span<const Index> vertices, Points x) {
  std::vector<Vec3> own;
  own.reserve(vertices.size());
  for (const Index v : vertices) own.push_back(x[v]);
  return own;
}

double typical_length(Points x) {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
  if (!x.empty()) low = high = x[0];
  for (const Vec3& p : x) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).maxCoeff() / std::sqrt(static_cast<double>(x.size() + 1));
  return size > 0.0 ? size : 1.0;
}

}  // namespace

NewtonSystem::NewtonSystem(const Objective& objective, Points x)
    : objective_(objective),
      matrix_(objective.motion(), x, [&](const auto& visit) { visit_cliques(visit); }) {}

bool NewtonSystem::is_small(std::size_t bound) const {
  return objective_.problem().bounds[bound].function->vertices().size() <= kFewVertices;
}

void NewtonSystem::visit_cliques(const std::function<void(std::span<const Index>)>& visit) const {
  Workers alone;
  objective_.layout().for_blocks(alone, [&](std::size_t, const Layout::Block& block) {
    if (static_cast<std::size_t>(block.cells.vertices_per_cell) > kManyVertices) return;
    for (std::size_t i = 0; i < block.cells.size(); ++i) visit(block.cells.cell(i));
  });
  if (objective_.lagrangian() == nullptr) return;
  const std::vector<Bound>& bounds = objective_.problem().bounds;
  for (std::size_t b = 0; b < bounds.size(); ++b) {
    if (is_small(b)) visit(bounds[b].function->vertices());
  }
}

bool NewtonSystem::update(Workers& workers, Points x, const Motion::Places& places) {
  for (const Kind kind : {Kind::exact, Kind::clamped}) {
    assemble(workers, x, places, kind);
    if (factorise()) return true;
  }
  return false;
}

void NewtonSystem::assemble(Workers& workers, Points x, const Motion::Places& places, Kind kind) {
  kind_ = kind;
  unit_ = typical_length(x);
  matrix_.set_axes(objective_.motion(), places);
  matrix_.set_zero();
  add_cells(workers, x, kind);
  add_tracks(workers, x, places, kind);
  large_.resize(0, 0);
  if (objective_.lagrangian() != nullptr) {
    add_bounds(x, kind);
    add_leashes(x);
  }
  matrix_.lift_diagonal(kind == Kind::clamped ? kLift : 0.0);
}

void NewtonSystem::add(Kind kind, std::span<const Index> vertices, Eigen::MatrixXd& block) {
  if (kind == Kind::clamped) clamp_eigenvalues(block);
  matrix_.add(vertices, block);
}

void NewtonSystem::add_cells(Workers& all_workers, Points x, Kind kind) {
  // Cells of one chunk may share an unknown with those of any other through tied vertices.
  Workers alone;
  Workers& workers = objective_.motion().has_ties() ? alone : all_workers;
  objective_.layout().for_blocks(workers, [&](std::size_t, const Layout::Block& block) {
    if (static_cast<std::size_t>(block.cells.vertices_per_cell) > kManyVertices) {
      add_springs(block, x);
      return;
    }
    differentiate_cells(
        objective_, block, x, matrix_, unit_,
        [&](std::span<const Index> vertices, Eigen::MatrixXd& own) { add(kind, vertices, own); });
  });
}

// A spring k/2 |a - b|^2 is at most k (|a|^2 + |b|^2).
void NewtonSystem::add_springs(const Layout::Block& block, Points x) {
  const int most = matrix_.most();
  std::vector<Spring> springs;
  for (const Term& term : objective_.problem().terms) {
    springs.clear();
    term.cost->add_springs(block.cells, x, springs);
    for (const Spring& spring : springs) {
      const Eigen::MatrixXd own =
          2.0 * term.weight * spring.stiffness * Eigen::MatrixXd::Identity(most, most);
      matrix_.add({&spring.a, 1}, own);
      matrix_.add({&spring.b, 1}, own);
    }
  }
}

void NewtonSystem::add_bounds(Points x, Kind kind) {
  const Lagrangian& lagrangian = *objective_.lagrangian();
  const std::vector<Bound>& bounds = objective_.problem().bounds;
  std::vector<Eigen::VectorXd> columns;
  for (std::size_t b = 0; b < bounds.size(); ++b) {
    const std::span<const Index> vertices = bounds[b].function->vertices();
    if (is_small(b)) {
      differentiate_function(
          vertices, x, matrix_, unit_,
          [&](Points own, std::span<Vec3> g) { lagrangian.evaluate_bound(b, own, g); },
          [&](std::span<const Index> v, Eigen::MatrixXd& own) { add(kind, v, own); });
      continue;
    }
    std::vector<Vec3> slope(vertices.size(), Vec3::Zero());
    const double factor = lagrangian.curvature_of_bound(b, positions_of(vertices, x), slope);
    if (factor <= 0.0) continue;
    std::vector<Vec3> all(x.size(), Vec3::Zero());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      all[objective_.motion().leader(vertices[i])] += slope[i];
    }
    columns.push_back(std::sqrt(factor) * matrix_.reduced(all));
  }
  large_.resize(static_cast<Eigen::Index>(matrix_.unknowns()),
                static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    large_.col(static_cast<Eigen::Index>(j)) = columns[j];
  }
}

void NewtonSystem::add_leashes(Points x) {
  objective_.lagrangian()->for_leashes(x, [&](Index v, const Eigen::Matrix3d& full) {
    if (matrix_.first(v) == ReducedMatrix::kNone) return;
    Eigen::MatrixXd own(matrix_.count(v), matrix_.count(v));
    for (int c = 0; c < matrix_.count(v); ++c) {
      for (int d = 0; d < matrix_.count(v); ++d) {
        const std::uint32_t first = matrix_.first(v);
        own(c, d) = matrix_.axis(first + static_cast<std::uint32_t>(c))
                        .dot(full * matrix_.axis(first + static_cast<std::uint32_t>(d)));
      }
    }
    matrix_.add({&v, 1}, own);
  });
}

void NewtonSystem::add_tracks(Workers& workers, Points x, const Motion::Places& places, Kind kind) {
  const Motion& motion = objective_.motion();
  const std::span<const Index> slots = motion.slots();
  if (std::none_of(slots.begin(), slots.end(), [&](Index v) { return motion.track(v); })) return;
  std::vector<Vec3> gradient(x.size());
  objective_.evaluate(workers, x, gradient);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const Index v = slots[k];
    const Track* const track = motion.track(v);
    if (track == nullptr || motion.freedom(v) == Motion::Freedom::fixed) continue;
    const auto bend = [&](const Vec3& t) {
      return gradient[v].dot(track->curvature(places[k], t));
    };
    const std::uint32_t first = matrix_.first(v);
    if (first == ReducedMatrix::kNone) continue;
    Eigen::MatrixXd own(matrix_.count(v), matrix_.count(v));
    own(0, 0) = bend(matrix_.axis(first));
    if (matrix_.count(v) == 2) {
      const Vec3& a = matrix_.axis(first);
      const Vec3& b = matrix_.axis(first + 1);
      own(1, 1) = bend(b);
      // Of a quadratic form, from its values along a, b and between them.
      own(0, 1) = own(1, 0) =
          bend((a + b) * (0.5 * std::numbers::sqrt2)) - 0.5 * (own(0, 0) + own(1, 1));
    }
    add(kind, {&v, 1}, own);
  }
}

bool NewtonSystem::factorise() {
  if (!analysed_) factor_.analyzePattern(matrix_.upper());
  analysed_ = true;
  factor_.factorize(matrix_.upper());
  if (factor_.info() != Eigen::Success) return false;
  if (large_.cols() == 0) return true;
  solved_large_ = factor_.solve(large_);
  coupling_.compute(Eigen::MatrixXd::Identity(large_.cols(), large_.cols()) +
                    large_.transpose() * solved_large_);
  return coupling_.info() == Eigen::Success;
}

void NewtonSystem::solve(Points g, std::span<Vec3> p) const {
  Eigen::VectorXd y = factor_.solve(matrix_.reduced(g));
  if (large_.cols() > 0) y -= solved_large_ * coupling_.solve(large_.transpose() * y);
  matrix_.expand(-y, p);
}

}  // namespace evenmesh
