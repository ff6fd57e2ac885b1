// SPDX-License-Identifier: MIT
#include "evenmesh/solver/coarsen.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace evenmesh {
namespace {

// Couplings weaker than this fraction of sqrt(a_ii a_jj) do not make neighbours.
constexpr float kStrong = 0.02f;

bool is_strong(const SymmetricMatrix& matrix, std::size_t i, const SparseMatrix::Entry& entry) {
  return entry.value * entry.value >
         kStrong * kStrong * matrix.diagonal[i] * matrix.diagonal[entry.column];
}

// Adds up a row's entries by column: a hash table with linear probing, emptied by taking.
class RowSum {
 public:
  void add(std::uint32_t column, float value) {
    if (2 * (used_.size() + 1) > slots_.size()) grow();
    std::size_t slot = place(column);
    while (slots_[slot].column != column && slots_[slot].column != kEmpty) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    if (slots_[slot].column == kEmpty) {
      slots_[slot] = {column, 0.0f};
      used_.push_back(static_cast<std::uint32_t>(slot));
    }
    slots_[slot].value += value;
  }

  // Appends the entries to a row, in the order their columns first came, and starts anew.
  void take(std::vector<SparseMatrix::Entry>& entries) {
    for (const std::uint32_t slot : used_) {
      entries.push_back(slots_[slot]);
      slots_[slot].column = kEmpty;
    }
    used_.clear();
  }

 private:
  static constexpr std::uint32_t kEmpty = ~0u;

  std::size_t place(std::uint32_t column) const {
    return (column * 2654435761u) & (slots_.size() - 1);
  }

  void grow() {
    std::vector<SparseMatrix::Entry> entries;
    take(entries);
    slots_.assign(2 * slots_.size(), {kEmpty, 0.0f});
    for (const auto& [column, value] : entries) add(column, value);
  }

  std::vector<SparseMatrix::Entry> slots_ = std::vector<SparseMatrix::Entry>(64, {kEmpty, 0.0f});
  std::vector<std::uint32_t> used_;
};

// Makes a matrix row by row in parallel. make(i, sum) adds up row i.
SparseMatrix build_rows(Workers& workers, std::size_t rows,
                        const std::function<void(std::size_t, RowSum&)>& make) {
  struct Part {
    std::vector<SparseMatrix::Entry> entries;
    std::vector<std::uint32_t> length;
  };
  std::vector<Part> parts((rows + kRangeSize - 1) / kRangeSize);
  for_ranges(workers, rows, [&](std::size_t first, std::size_t last) {
    Part& part = parts[first / kRangeSize];
    RowSum sum;
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t before = part.entries.size();
      make(i, sum);
      sum.take(part.entries);
      part.length.push_back(static_cast<std::uint32_t>(part.entries.size() - before));
    }
  });
  SparseMatrix matrix;
  matrix.start.reserve(rows + 1);
  for (const Part& part : parts) {
    for (const std::uint32_t length : part.length) {
      matrix.start.push_back(matrix.start.back() + length);
    }
  }
  matrix.entries.reserve(matrix.start.back());
  for (Part& part : parts) {
    matrix.entries.insert(matrix.entries.end(), part.entries.begin(), part.entries.end());
    part = {};
  }
  return matrix;
}

float gershgorin_bound(const SymmetricMatrix& matrix) {
  float bound = 1.0f;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    if (matrix.diagonal[i] <= 0.0f) continue;
    float sum = matrix.diagonal[i];
    for (const auto& entry : matrix.off_diagonal.row(i)) sum += std::abs(entry.value);
    bound = std::max(bound, sum / matrix.diagonal[i]);
  }
  return bound;
}

}  // namespace

Aggregates aggregate(const SymmetricMatrix& matrix) {
  const std::size_t n = matrix.rows();
  Aggregates result{std::vector<std::uint32_t>(n, Aggregates::kNone), 0};
  std::vector<std::uint32_t>& of_row = result.of_row;
  for (std::size_t i = 0; i < n; ++i) {
    if (matrix.diagonal[i] <= 0.0f || of_row[i] != Aggregates::kNone) continue;
    const auto row = matrix.off_diagonal.row(i);
    const bool alone = std::none_of(row.begin(), row.end(), [&](const auto& entry) {
      return of_row[entry.column] != Aggregates::kNone && is_strong(matrix, i, entry);
    });
    if (!alone) continue;
    for (const auto& entry : row) {
      if (is_strong(matrix, i, entry)) of_row[entry.column] = result.count;
    }
    of_row[i] = result.count++;
  }
  // Only aggregates of the first pass are joined, so that none grows in a chain.
  const std::vector<std::uint32_t> founded = of_row;
  for (std::size_t i = 0; i < n; ++i) {
    if (matrix.diagonal[i] <= 0.0f || of_row[i] != Aggregates::kNone) continue;
    float strongest = -1.0f;
    for (const auto& entry : matrix.off_diagonal.row(i)) {
      if (founded[entry.column] == Aggregates::kNone || std::abs(entry.value) <= strongest)
        continue;
      strongest = std::abs(entry.value);
      of_row[i] = founded[entry.column];
    }
    if (of_row[i] == Aggregates::kNone) of_row[i] = result.count++;
  }
  return result;
}

SparseMatrix smoothed_interpolation(Workers& workers, const SymmetricMatrix& matrix,
                                    const Aggregates& aggregates) {
  const float omega = 4.0f / (3.0f * gershgorin_bound(matrix));
  return build_rows(workers, matrix.rows(), [&](std::size_t i, RowSum& sum) {
    if (matrix.diagonal[i] <= 0.0f) return;
    sum.add(aggregates.of_row[i], 1.0f - omega);
    const float factor = -omega / matrix.diagonal[i];
    for (const auto& entry : matrix.off_diagonal.row(i)) {
      sum.add(aggregates.of_row[entry.column], factor * entry.value);
    }
  });
}

SparseMatrix transpose(const SparseMatrix& matrix, std::size_t columns) {
  SparseMatrix result;
  result.start.assign(columns + 1, 0);
  for (const auto& entry : matrix.entries) ++result.start[entry.column + 1];
  for (std::size_t i = 0; i < columns; ++i) result.start[i + 1] += result.start[i];
  result.entries.resize(matrix.entries.size());
  std::vector<std::uint64_t> next(result.start.begin(), result.start.end() - 1);
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    for (const auto& entry : matrix.row(i)) {
      result.entries[next[entry.column]++] = {static_cast<std::uint32_t>(i), entry.value};
    }
  }
  return result;
}

SymmetricMatrix galerkin_product(Workers& workers, const SymmetricMatrix& matrix,
                                 const SparseMatrix& interpolation,
                                 const SparseMatrix& restriction) {
  const SparseMatrix product = build_rows(workers, matrix.rows(), [&](std::size_t i, RowSum& sum) {
    for (const auto& p : interpolation.row(i)) sum.add(p.column, matrix.diagonal[i] * p.value);
    for (const auto& a : matrix.off_diagonal.row(i)) {
      for (const auto& p : interpolation.row(a.column)) sum.add(p.column, a.value * p.value);
    }
  });
  SymmetricMatrix coarse;
  coarse.diagonal.assign(restriction.rows(), 0.0f);
  coarse.off_diagonal = build_rows(workers, restriction.rows(), [&](std::size_t i, RowSum& sum) {
    for (const auto& r : restriction.row(i)) {
      for (const auto& entry : product.row(r.column)) {
        if (entry.column == i) {
          coarse.diagonal[i] += r.value * entry.value;
        } else {
          sum.add(entry.column, r.value * entry.value);
        }
      }
    }
  });
  return coarse;
}

}  // namespace evenmesh
