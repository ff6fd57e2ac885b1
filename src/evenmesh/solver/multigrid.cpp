// SPDX-License-Identifier: MIT
#include "evenmesh/solver/multigrid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "evenmesh/solver/coarsen.h"
#include "evenmesh/solver/layout.h"

namespace evenmesh {
namespace {

constexpr std::size_t kCoarsest = 400;         // rows that dense Cholesky takes
constexpr std::size_t kCoarsestCoupled = 150;  // where it takes three unknowns per row
// Part of its scalar stiffness below which a direction is none in which a row can move.
constexpr float kSingular = 1e-4f;
constexpr int kMostLevels = 20;
constexpr std::size_t kChunk = 2048;  // rows that Gauss-Seidel sweeps on one thread

// Chunks of rows coupled to each other, directly, must not be swept at the same time.
std::vector<std::vector<std::uint32_t>> colour_rows(const SparseMatrix& matrix) {
  const std::size_t count = (matrix.rows() + kChunk - 1) / kChunk;
  std::vector<std::vector<std::uint32_t>> edges(count);
  // Every pair of coupled chunks is a resource of its own that both need.
  std::uint32_t pairs = 0;
  for (std::size_t c = 0; c < count; ++c) {
    std::vector<std::uint32_t> others;
    for (std::size_t i = c * kChunk; i < std::min(matrix.rows(), (c + 1) * kChunk); ++i) {
      for (const auto& entry : matrix.row(i)) {
        const auto other = static_cast<std::uint32_t>(entry.column / kChunk);
        if (other <= c || std::find(others.begin(), others.end(), other) != others.end()) continue;
        others.push_back(other);
      }
    }
    for (const std::uint32_t other : others) {
      edges[c].push_back(pairs);
      edges[other].push_back(pairs++);
    }
  }
  return colour_items(edges, pairs);
}

Projections projections_of(std::span<const Projector> projectors, std::size_t rows) {
  Projections result;
  std::vector<Index> chosen;
  for (const Projector& projector : projectors) {
    chosen.push_back(projector.row);
    result.of.emplace_back(projector.matrix);
  }
  result.chosen = Chosen(chosen, rows);
  return result;
}

// The inverse in the directions that have stiffness, compared with that of the scalar matrix; 0 in
// the others.
Block inverse(const Block& block, float scalar) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> eigen(block.topRows<3>());
  const Eigen::Vector3f inverses = eigen.eigenvalues().unaryExpr(
      [&](float value) { return value > kSingular * scalar ? 1.0f / value : 0.0f; });
  Block result = Block::Zero();
  result.topRows<3>() =
      eigen.eigenvectors() * inverses.asDiagonal() * eigen.eigenvectors().transpose();
  return result;
}

}  // namespace

Multigrid::Multigrid(Workers& workers, SymmetricMatrix matrix,
                     std::span<const Projector> projectors)
    : scale_(matrix.scale) {
  Level& finest = levels_.emplace_back();
  finest.matrix = std::move(matrix);
  finest.projections = projections_of(projectors, finest.matrix.rows());
  const std::size_t coarsest = projectors.empty() ? kCoarsest : kCoarsestCoupled;
  coarsen(workers, coarsest);
  const Level& last = levels_.back();
  if (last.matrix.rows() > coarsest * 4) return;  // could not be coarsened: smoothing has to do
  if (last.is_constrained()) {
    factorise_coupled(last);
  } else {
    factorise(last);
  }
}

void Multigrid::coarsen(Workers& workers, std::size_t coarsest) {
  while (static_cast<int>(levels_.size()) < kMostLevels) {
    Level& fine = levels_.back();
    prepare(workers, fine);
    if (fine.matrix.rows() <= coarsest) break;
    const Aggregates aggregates = aggregate(fine.matrix);
    if (aggregates.count == 0 || aggregates.count * 10 > fine.matrix.rows() * 9) break;
    fine.interpolation = smoothed_interpolation(workers, fine.matrix, aggregates);
    fine.restriction = transpose(fine.interpolation, aggregates.count);
    Level coarse;
    coarse.matrix = galerkin_product(workers, fine.matrix, fine.interpolation, fine.restriction);
    if (!fine.projections.chosen.empty()) {
      coarse.coupled = galerkin_couplings(workers, fine.matrix, fine.projections,
                                          fine.interpolation, fine.restriction, coarse.matrix);
    } else if (!fine.coupled.chosen.empty()) {
      coarse.coupled = galerkin_couplings(workers, fine.matrix, fine.coupled, fine.interpolation,
                                          fine.restriction, coarse.matrix);
    }
    levels_.push_back(std::move(coarse));
  }
}

void Multigrid::factorise(const Level& level) {
  const SymmetricMatrix& matrix = level.matrix;
  const auto n = static_cast<Eigen::Index>(matrix.rows());
  Eigen::MatrixXf dense = Eigen::MatrixXf::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    dense(i, i) = matrix.diagonal[row] > 0.0f ? matrix.diagonal[row] * (1.0f + 1e-6f) : 1.0f;
    for (const auto& entry : matrix.off_diagonal.row(row)) dense(i, entry.column) = entry.value;
  }
  coarsest_.compute(dense);
}

void Multigrid::factorise_coupled(const Level& level) {
  const auto n = static_cast<Eigen::Index>(level.matrix.rows());
  Eigen::MatrixXf dense = Eigen::MatrixXf::Zero(3 * n, 3 * n);
  const auto put = [&](Eigen::Index i, Eigen::Index j, const Eigen::Matrix3f& block) {
    dense.block<3, 3>(3 * i, 3 * j) = block;
  };
  const auto projector = [&](Eigen::Index i) -> Eigen::Matrix3f {
    const std::uint32_t k = level.projections.chosen[static_cast<std::size_t>(i)];
    if (k == Chosen::kNone) return Eigen::Matrix3f::Identity();
    return (Block(identity_block()) * level.projections.of[k]).topRows<3>();
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const float d = level.matrix.diagonal[row];
    const float shift = d > 0.0f ? kSingular * d : 1.0f;
    const std::uint32_t k = level.coupled.chosen[row];
    const float* values = k == Chosen::kNone ? nullptr : level.coupled.couplings(k);
    put(i, i, values ? level.coupled.diagonal[k].topRows<3>() : Eigen::Matrix3f(d * projector(i)));
    dense.diagonal().segment<3>(3 * i).array() += shift;
    for (const auto& entry : level.matrix.off_diagonal.row(row)) {
      if (values) {
        put(i, entry.column, Eigen::Map<const Eigen::Matrix3f>(values));
        values += 9;
      } else {
        put(i, entry.column, entry.value * projector(i) * projector(entry.column));
      }
    }
  }
  coarsest_.compute(dense);
}

void Multigrid::prepare(Workers& workers, Level& level) {
  const std::size_t n = level.matrix.rows();
  level.inverse_diagonal.resize(n);
  level.inverse_block.resize(level.coupled.diagonal.size());
  for_ranges(workers, n, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const float d = level.matrix.diagonal[i];
      level.inverse_diagonal[i] = d > 0.0f ? 1.0f / d : 0.0f;
      const std::uint32_t k = level.coupled.chosen[i];
      if (k != Chosen::kNone) level.inverse_block[k] = inverse(level.coupled.diagonal[k], d);
    }
  });
  level.colours = colour_rows(level.matrix.off_diagonal);
  level.right.assign(n, Row::Zero());
  level.solution.assign(n, Row::Zero());
  level.residual.assign(n, Row::Zero());
}

inline void Multigrid::Level::project(std::size_t i, Row& vector) const {
  const std::uint32_t k = projections.chosen[i];
  if (k != Chosen::kNone) vector = projections.of[k] * vector;
}

Row Multigrid::Level::without_coupled(std::size_t i, std::uint32_t k, Row sum) const {
  const float* block = coupled.couplings(k);
  for (const auto& entry : matrix.off_diagonal.row(i)) {
    sum -= times(unpacked(block), solution[entry.column]);
    block += 9;
  }
  return sum;
}

inline void Multigrid::Level::relax(std::size_t i) {
  Row sum = right[i];
  for (const auto& entry : matrix.off_diagonal.row(i)) sum -= entry.value * solution[entry.column];
  solution[i] = inverse_diagonal[i] * sum;
}

inline void Multigrid::Level::relax_constrained(std::size_t i) {
  const std::uint32_t k = coupled.chosen[i];
  if (k != Chosen::kNone) {
    solution[i] = times(inverse_block[k], without_coupled(i, k, right[i]));
  } else {
    relax(i);
    project(i, solution[i]);
  }
}

inline void Multigrid::Level::find_residual(std::size_t i) {
  Row sum = right[i] - matrix.diagonal[i] * solution[i];
  for (const auto& entry : matrix.off_diagonal.row(i)) sum -= entry.value * solution[entry.column];
  residual[i] = sum;
}

inline void Multigrid::Level::find_residual_constrained(std::size_t i) {
  const std::uint32_t k = coupled.chosen[i];
  if (k != Chosen::kNone) {
    residual[i] = without_coupled(i, k, right[i] - times(coupled.diagonal[k], solution[i]));
  } else {
    find_residual(i);
    project(i, residual[i]);
  }
}

double Multigrid::operator_complexity() const {
  const auto entries = [](const SymmetricMatrix& m) {
    return static_cast<double>(m.rows() + m.off_diagonal.entries.size());
  };
  double sum = 0.0;
  for (const Level& level : levels_) sum += entries(level.matrix);
  return sum / entries(levels_.front().matrix);
}

void Multigrid::apply(Workers& workers, std::span<const Vec3> r, std::span<Vec3> z) {
  Level& finest = levels_.front();
  // Single precision has little range; lengths in a file may be anything. Bring r to size 1.
  std::vector<double> greatest((r.size() + kRangeSize - 1) / kRangeSize, 0.0);
  for_ranges(workers, r.size(), [&](std::size_t first, std::size_t last) {
    double& most = greatest[first / kRangeSize];
    for (std::size_t i = first; i < last; ++i) {
      most = std::max(most, r[i].lpNorm<Eigen::Infinity>());
    }
  });
  const double size = *std::max_element(greatest.begin(), greatest.end());
  const double scale = size > 0.0 && std::isfinite(size) ? size : 1.0;
  for_ranges(workers, r.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      finest.right[i].head<3>() = (r[i] / scale).cast<float>();  // 1 / scale may be infinite
      finest.project(i, finest.right[i]);
    }
  });
  cycle(workers, 0);
  for_ranges(workers, r.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      z[i] = scale * (finest.solution[i].head<3>().cast<double>() / scale_);
    }
  });
}

void Multigrid::cycle(Workers& workers, std::size_t depth) {
  Level& level = levels_[depth];
  if (depth + 1 == levels_.size()) {
    if (coarsest_.cols() > 0) return solve_coarsest(level);
    smooth_forwards(workers, level);
    smooth_backwards(workers, level);
    return;
  }
  smooth_forwards(workers, level);
  Level& coarse = levels_[depth + 1];
  const std::size_t n = level.matrix.rows();
  const bool constrained = level.is_constrained();
  for_ranges(workers, n, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      constrained ? level.find_residual_constrained(i) : level.find_residual(i);
    }
  });
  for_ranges(workers, coarse.matrix.rows(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Row sum = Row::Zero();
      for (const auto& entry : level.restriction.row(i)) {
        sum += entry.value * level.residual[entry.column];
      }
      coarse.right[i] = sum;
    }
  });
  cycle(workers, depth + 1);
  for_ranges(workers, n, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Row sum = level.solution[i];
      for (const auto& entry : level.interpolation.row(i)) {
        sum += entry.value * coarse.solution[entry.column];
      }
      level.solution[i] = sum;
      level.project(i, level.solution[i]);
    }
  });
  smooth_backwards(workers, level);
}

void Multigrid::solve_coarsest(Level& level) const {
  // Three columns of scalar unknowns, or one column with three unknowns per row.
  const auto n = static_cast<Eigen::Index>(level.matrix.rows());
  const bool coupled = level.is_constrained();
  Eigen::MatrixXf right = coupled ? Eigen::MatrixXf(3 * n, 1) : Eigen::MatrixXf(n, 3);
  const auto vector = [&](Eigen::Index i) {
    return Eigen::Map<Eigen::Vector3f, 0, Eigen::InnerStride<>>(
        right.data() + (coupled ? 3 * i : i), Eigen::InnerStride<>(coupled ? 1 : n));
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    vector(i) = level.right[static_cast<std::size_t>(i)].head<3>();
  }
  right = coarsest_.solve(right).eval();
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const bool unknown = level.matrix.diagonal[row] > 0.0f;
    level.solution[row].head<3>() = vector(i) * (unknown ? 1.0f : 0.0f);
    level.project(row, level.solution[row]);
  }
}

void Multigrid::smooth_forwards(Workers& workers, Level& level) {
  const std::size_t n = level.matrix.rows();
  const bool constrained = level.is_constrained();
  // From zero: what has not been swept yet contributes nothing.
  for_ranges(workers, n, [&](std::size_t first, std::size_t last) {
    std::fill(level.solution.begin() + static_cast<std::ptrdiff_t>(first),
              level.solution.begin() + static_cast<std::ptrdiff_t>(last), Row::Zero());
  });
  for (const auto& colour : level.colours) {
    workers.run(colour.size(), [&](std::size_t k) {
      const std::size_t last = std::min(n, (colour[k] + std::size_t{1}) * kChunk);
      for (std::size_t i = colour[k] * kChunk; i < last; ++i) {
        constrained ? level.relax_constrained(i) : level.relax(i);
      }
    });
  }
}

void Multigrid::smooth_backwards(Workers& workers, Level& level) {
  const std::size_t n = level.matrix.rows();
  const bool constrained = level.is_constrained();
  for (auto colour = level.colours.rbegin(); colour != level.colours.rend(); ++colour) {
    workers.run(colour->size(), [&](std::size_t k) {
      const std::size_t first = (*colour)[k] * kChunk;
      for (std::size_t i = std::min(n, first + kChunk); i-- > first;) {
        constrained ? level.relax_constrained(i) : level.relax(i);
      }
    });
  }
}

}  // namespace evenmesh
