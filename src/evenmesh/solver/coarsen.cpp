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
template <class Value>
class RowSum {
 public:
  struct Entry {
    std::uint32_t column;
    Value value;
  };

  explicit RowSum(const Value& zero) : zero_(zero), slots_(64, {kEmpty, zero}) {}

  void add(std::uint32_t column, const Value& value) {
    if (2 * (used_.size() + 1) > slots_.size()) grow();
    const std::size_t slot = find(column);
    if (slots_[slot].column == kEmpty) {
      slots_[slot] = {column, zero_};
      used_.push_back(static_cast<std::uint32_t>(slot));
    }
    slots_[slot].value += value;
  }

  // Null if nothing was added to the column.
  const Value* at(std::uint32_t column) const {
    const Entry& entry = slots_[find(column)];
    return entry.column == column ? &entry.value : nullptr;
  }

  // Passes on the entries, in the order their columns first came, and starts anew.
  template <class Body>
  void take(const Body& body) {
    for (const std::uint32_t slot : used_) {
      body(slots_[slot].column, slots_[slot].value);
      slots_[slot].column = kEmpty;
    }
    used_.clear();
  }

  bool empty() const { return used_.empty(); }

 private:
  static constexpr std::uint32_t kEmpty = ~0u;

  std::size_t find(std::uint32_t column) const {
    std::size_t slot = (column * 2654435761u) & (slots_.size() - 1);
    while (slots_[slot].column != column && slots_[slot].column != kEmpty) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }

  void grow() {
    std::vector<Entry> entries;
    take([&](std::uint32_t column, const Value& value) { entries.push_back({column, value}); });
    slots_.assign(2 * slots_.size(), {kEmpty, zero_});
    for (const Entry& entry : entries) add(entry.column, entry.value);
  }

  Value zero_;
  std::vector<Entry> slots_;
  std::vector<std::uint32_t> used_;
};

// Makes a matrix row by row in parallel. make(i, sum) adds up row i.
SparseMatrix build_rows(Workers& workers, std::size_t rows,
                        const std::function<void(std::size_t, RowSum<float>&)>& make) {
  struct Part {
    std::vector<SparseMatrix::Entry> entries;
    std::vector<std::uint32_t> length;
  };
  std::vector<Part> parts((rows + kRangeSize - 1) / kRangeSize);
  for_ranges(workers, rows, [&](std::size_t first, std::size_t last) {
    Part& part = parts[first / kRangeSize];
    RowSum<float> sum(0.0f);
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t before = part.entries.size();
      make(i, sum);
      sum.take([&](std::uint32_t column, float value) { part.entries.push_back({column, value}); });
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

// Some of the coupled rows, in ascending order.
struct CoupledPart {
  std::vector<Index> rows;
  std::vector<Block> diagonal;
  std::vector<float> values;
  std::vector<std::uint32_t> length;

  // Row i of the scalar matrix with the correction added to it.
  void add(std::size_t i, const SymmetricMatrix& matrix, RowSum<Block>& correction) {
    const auto row = static_cast<Index>(i);
    const auto corrected = [&](std::uint32_t column, float value) {
      const Block* const block = correction.at(column);
      Eigen::Matrix3f result = Eigen::Matrix3f::Identity() * value;
      if (block) result += block->topRows<3>();
      return result;
    };
    rows.push_back(row);
    const Eigen::Matrix3f own = corrected(row, matrix.diagonal[i]);
    diagonal.push_back(Block::Zero());
    diagonal.back().topRows<3>() = 0.5f * (own + own.transpose());
    for (const auto& entry : matrix.off_diagonal.row(i)) {
      const Eigen::Matrix3f block = corrected(entry.column, entry.value);
      values.insert(values.end(), block.data(), block.data() + 9);
    }
    length.push_back(static_cast<std::uint32_t>(matrix.off_diagonal.row(i).size()));
    correction.take([](std::uint32_t, const Block&) {});
  }
};

CoupledRows joined(std::vector<CoupledPart>& parts, std::size_t count) {
  CoupledRows result;
  std::vector<Index> rows;
  std::uint64_t end = 0;
  for (CoupledPart& part : parts) {
    rows.insert(rows.end(), part.rows.begin(), part.rows.end());
    result.diagonal.insert(result.diagonal.end(), part.diagonal.begin(), part.diagonal.end());
    for (const std::uint32_t length : part.length) {
      result.start.push_back(end);
      end += length;
    }
  }
  result.values.reserve(9 * end + 1);
  for (CoupledPart& part : parts) {
    result.values.insert(result.values.end(), part.values.begin(), part.values.end());
    part = {};
  }
  result.values.push_back(0.0f);
  result.chosen = Chosen(rows, count);
  return result;
}

// What P (S (x) I) P is beyond S (x) I: the sum over i of w_i S_ij (P_i P_j - I), for weights w and
// every j, is G P_j + s (P_j - I) with G the sum of w_i S_ij (P_i - I) and s that of w_i S_ij.
struct ProjectionCorrection {
  const SymmetricMatrix& matrix;
  const Projections& projections;

  // Adds row i times a weight: to G, and to s, which is in the first place of G's spare row.
  void add_row(std::size_t i, float weight, RowSum<Block>& sum) const {
    const std::uint32_t k = projections.chosen[i];
    const bool moves_freely = k == Chosen::kNone;
    Block own = spare_one();
    if (!moves_freely) own += Block(identity_block()) * projections.of[k] - identity_block();
    const auto add = [&](std::uint32_t j, float value) {
      if (moves_freely && projections.chosen[j] == Chosen::kNone) return;
      sum.add(j, (weight * value) * own);
    };
    add(static_cast<std::uint32_t>(i), matrix.diagonal[i]);
    for (const auto& entry : matrix.off_diagonal.row(i)) add(entry.column, entry.value);
  }

  Block finished(std::size_t j, const Block& sum) const {
    const std::uint32_t k = projections.chosen[j];
    if (k == Chosen::kNone) return sum;
    const float s = sum(3, 0);
    return Block(sum + s * identity_block()) * projections.of[k] - s * identity_block();
  }
};

// What coupled rows have beyond the matrix of scalars.
struct CouplingCorrection {
  const SymmetricMatrix& matrix;
  const CoupledRows& rows;

  void add_row(std::size_t i, float weight, RowSum<Block>& sum) const {
    const std::uint32_t k = rows.chosen[i];
    if (k == Chosen::kNone) return;
    sum.add(static_cast<std::uint32_t>(i),
            weight * (rows.diagonal[k] - matrix.diagonal[i] * identity_block()));
    const float* values = rows.couplings(k);
    for (const auto& entry : matrix.off_diagonal.row(i)) {
      sum.add(entry.column, weight * (unpacked(values) - entry.value * identity_block()));
      values += 9;
    }
  }

  static const Block& finished(std::size_t, const Block& sum) { return sum; }
};

// p^T C p for the correction C of the finer level, row by row without storing p^T C, with p^T S p
// added to the rows in which there is any. Two rows that C couples are coupled by S, and so are
// those of the products.
template <class Correction>
CoupledRows correct_product(Workers& workers, const Correction& correction,
                            const SparseMatrix& interpolation, const SparseMatrix& restriction,
                            const SymmetricMatrix& coarse) {
  std::vector<CoupledPart> parts((coarse.rows() + kRangeSize - 1) / kRangeSize);
  for_ranges(workers, coarse.rows(), [&](std::size_t first, std::size_t last) {
    CoupledPart& part = parts[first / kRangeSize];
    RowSum<Block> left(Block::Zero());  // row i of p^T C
    RowSum<Block> sum(Block::Zero());
    for (std::size_t i = first; i < last; ++i) {
      for (const auto& r : restriction.row(i)) correction.add_row(r.column, r.value, left);
      if (left.empty()) continue;
      left.take([&](std::uint32_t column, const Block& unfinished) {
        const Block block = correction.finished(column, unfinished);
        for (const auto& p : interpolation.row(column)) sum.add(p.column, p.value * block);
      });
      part.add(i, coarse, sum);
    }
  });
  return joined(parts, coarse.rows());
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
  return build_rows(workers, matrix.rows(), [&](std::size_t i, RowSum<float>& sum) {
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
  const SparseMatrix product =
      build_rows(workers, matrix.rows(), [&](std::size_t i, RowSum<float>& sum) {
        for (const auto& p : interpolation.row(i)) sum.add(p.column, matrix.diagonal[i] * p.value);
        for (const auto& a : matrix.off_diagonal.row(i)) {
          for (const auto& p : interpolation.row(a.column)) sum.add(p.column, a.value * p.value);
        }
      });
  SymmetricMatrix coarse;
  coarse.diagonal.assign(restriction.rows(), 0.0f);
  coarse.off_diagonal =
      build_rows(workers, restriction.rows(), [&](std::size_t i, RowSum<float>& sum) {
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

CoupledRows galerkin_couplings(Workers& workers, const SymmetricMatrix& matrix,
                               const Projections& projections, const SparseMatrix& interpolation,
                               const SparseMatrix& restriction, const SymmetricMatrix& coarse) {
  return correct_product(workers, ProjectionCorrection{matrix, projections}, interpolation,
                         restriction, coarse);
}

CoupledRows galerkin_couplings(Workers& workers, const SymmetricMatrix& matrix,
                               const CoupledRows& rows, const SparseMatrix& interpolation,
                               const SparseMatrix& restriction, const SymmetricMatrix& coarse) {
  return correct_product(workers, CouplingCorrection{matrix, rows}, interpolation, restriction,
                         coarse);
}

}  // namespace evenmesh
