// SPDX-License-Identifier: MIT
#include "evenmesh/solver/multigrid.h"

#include <algorithm>
#include <cmath>

#include "evenmesh/solver/coarsen.h"
#include "evenmesh/solver/layout.h"

namespace evenmesh {
namespace {

constexpr std::size_t kCoarsest = 400;  // rows that dense Cholesky takes
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

}  // namespace

Multigrid::Multigrid(Workers& workers, SymmetricMatrix matrix) : scale_(matrix.scale) {
  levels_.emplace_back().matrix = std::move(matrix);
  while (static_cast<int>(levels_.size()) < kMostLevels) {
    Level& fine = levels_.back();
    prepare(workers, fine);
    if (fine.matrix.rows() <= kCoarsest) break;
    const Aggregates aggregates = aggregate(fine.matrix);
    if (aggregates.count == 0 || aggregates.count * 10 > fine.matrix.rows() * 9) break;
    fine.interpolation = smoothed_interpolation(workers, fine.matrix, aggregates);
    fine.restriction = transpose(fine.interpolation, aggregates.count);
    SymmetricMatrix coarse =
        galerkin_product(workers, fine.matrix, fine.interpolation, fine.restriction);
    levels_.emplace_back().matrix = std::move(coarse);
  }
  const SymmetricMatrix& last = levels_.back().matrix;
  if (last.rows() > kCoarsest * 4) return;  // could not be coarsened: smoothing has to do
  const auto n = static_cast<Eigen::Index>(last.rows());
  Eigen::MatrixXf dense = Eigen::MatrixXf::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    dense(i, i) = last.diagonal[row] > 0.0f ? last.diagonal[row] * (1.0f + 1e-6f) : 1.0f;
    for (const auto& entry : last.off_diagonal.row(row)) dense(i, entry.column) = entry.value;
  }
  coarsest_.compute(dense);
}

void Multigrid::prepare(Workers& workers, Level& level) {
  const std::size_t n = level.matrix.rows();
  level.inverse_diagonal.resize(n);
  for_ranges(workers, n, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const float d = level.matrix.diagonal[i];
      level.inverse_diagonal[i] = d > 0.0f ? 1.0f / d : 0.0f;
    }
  });
  level.colours = colour_rows(level.matrix.off_diagonal);
  level.right.assign(n, Row::Zero());
  level.solution.assign(n, Row::Zero());
  level.residual.assign(n, Row::Zero());
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
    if (coarsest_.cols() == 0) {
      smooth_forwards(workers, level);
      smooth_backwards(workers, level);
      return;
    }
    Eigen::MatrixXf right(coarsest_.cols(), 3);
    for (Eigen::Index i = 0; i < right.rows(); ++i) {
      right.row(i) = level.right[static_cast<std::size_t>(i)].head<3>().transpose();
    }
    const Eigen::MatrixXf solution = coarsest_.solve(right);
    for (Eigen::Index i = 0; i < right.rows(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      const bool unknown = level.matrix.diagonal[row] > 0.0f;
      level.solution[row].head<3>() = solution.row(i).transpose() * (unknown ? 1.0f : 0.0f);
    }
    return;
  }
  smooth_forwards(workers, level);
  Level& coarse = levels_[depth + 1];
  const std::size_t n = level.matrix.rows();
  for_ranges(workers, n, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Row sum = level.right[i] - level.matrix.diagonal[i] * level.solution[i];
      for (const auto& entry : level.matrix.off_diagonal.row(i)) {
        sum -= entry.value * level.solution[entry.column];
      }
      level.residual[i] = sum;
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
    }
  });
  smooth_backwards(workers, level);
}

void Multigrid::smooth_forwards(Workers& workers, Level& level) {
  const std::size_t n = level.matrix.rows();
  // From zero: what has not been swept yet contributes nothing.
  for_ranges(workers, n, [&](std::size_t first, std::size_t last) {
    std::fill(level.solution.begin() + static_cast<std::ptrdiff_t>(first),
              level.solution.begin() + static_cast<std::ptrdiff_t>(last), Row::Zero());
  });
  for (const auto& colour : level.colours) {
    workers.run(colour.size(), [&](std::size_t k) {
      const std::size_t last = std::min(n, (colour[k] + std::size_t{1}) * kChunk);
      for (std::size_t i = colour[k] * kChunk; i < last; ++i) {
        Row sum = level.right[i];
        for (const auto& entry : level.matrix.off_diagonal.row(i)) {
          sum -= entry.value * level.solution[entry.column];
        }
        level.solution[i] = level.inverse_diagonal[i] * sum;
      }
    });
  }
}

void Multigrid::smooth_backwards(Workers& workers, Level& level) {
  const std::size_t n = level.matrix.rows();
  for (auto colour = level.colours.rbegin(); colour != level.colours.rend(); ++colour) {
    workers.run(colour->size(), [&](std::size_t k) {
      const std::size_t first = (*colour)[k] * kChunk;
      for (std::size_t i = std::min(n, first + kChunk); i-- > first;) {
        Row sum = level.right[i];
        for (const auto& entry : level.matrix.off_diagonal.row(i)) {
          sum -= entry.value * level.solution[entry.column];
        }
        level.solution[i] = level.inverse_diagonal[i] * sum;
      }
    });
  }
}

}  // namespace evenmesh
