// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "evenmesh/base/vec3.h"

namespace evenmesh {

/// Three coordinates and a spare lane, one SIMD register.
using Row = Eigen::Vector4f;

/// A 3x3 matrix that acts on a Row; its fourth row is 0.
using Block = Eigen::Matrix<float, 4, 3>;

/// The directions in which the unknown of a row may move: t t^T along a line, I - n n^T in a
/// plane.
struct Projector {
  Index row;
  Eigen::Matrix3f matrix;  // symmetric, its own square
};

/// Numbers for a few chosen rows. Takes no memory where none is chosen.
class Chosen {
 public:
  static constexpr std::uint32_t kNone = ~0u;

  Chosen() = default;
  /// @param rows   each once, < count; their positions here are their numbers
  /// @param count  of all rows
  Chosen(const std::vector<Index>& rows, std::size_t count) {
    if (rows.empty()) return;
    number_.assign(count, kNone);
    for (std::size_t k = 0; k < rows.size(); ++k) number_[rows[k]] = static_cast<std::uint32_t>(k);
  }

  bool empty() const { return number_.empty(); }
  /// kNone if the row is not chosen.
  std::uint32_t operator[](std::size_t row) const { return empty() ? kNone : number_[row]; }

 private:
  std::vector<std::uint32_t> number_;
};

/// The projectors of the rows that have one.
struct Projections {
  Chosen chosen;
  std::vector<Block> blocks;
};

/// The rows of a matrix in which the coordinates are coupled. Such a row has the couplings that
/// it has in the matrix of scalars beside it, in that order, but they are 3x3 matrices.
struct CoupledRows {
  Chosen chosen;
  std::vector<Block> diagonal;       // per chosen row
  std::vector<std::uint64_t> start;  // per chosen row: its first coupling
  std::vector<float> values;         // nine per coupling, column by column, and one spare float

  const float* couplings(std::uint32_t k) const { return values.data() + 9 * start[k]; }
};

/// block x, for nine packed numbers. Reads one float beyond them, into the result's spare lane.
inline Row packed_times(const float* block, const Row& x) {
  using Column = Eigen::Map<const Row>;
  return Column(block) * x[0] + Column(block + 3) * x[1] + Column(block + 6) * x[2];
}

}  // namespace evenmesh
