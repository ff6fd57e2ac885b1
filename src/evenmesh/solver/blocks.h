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

/// A 3x3 matrix whose columns are Rows. Its spare lanes hold anything.
using Block = Eigen::Matrix<float, 4, 3>;

// Constants to add and multiply by whole registers: to write a single number of a register and to
// read the register next stalls.
namespace registers {
alignas(16) inline constexpr float kIdentity[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
alignas(16) inline constexpr float kSpareOne[12] = {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0};
alignas(16) inline constexpr float kNoSpareLane[4] = {1, 1, 1, 0};
}  // namespace registers

/// The identity, its spare lanes 0.
inline auto identity_block() {
  return Eigen::Map<const Block, Eigen::Aligned16>(registers::kIdentity);
}

/// 1 in the spare lane of the first column, else 0.
inline auto spare_one() { return Eigen::Map<const Block, Eigen::Aligned16>(registers::kSpareOne); }

/// The row with 0 in its spare lane.
inline Row without_spare_lane(const Row& row) {
  return row.cwiseProduct(Eigen::Map<const Row, Eigen::Aligned16>(registers::kNoSpareLane));
}

/// The directions in which the unknown of a row may move: t t^T along a line, I - n n^T in a
/// plane.
struct Projector {
  Index row;
  Eigen::Matrix3f matrix;  // symmetric, its own square, whatever its rank
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

/// A projector in short: its line's unit vector, or its plane's.
class Projection {
 public:
  /// @param projector  of rank 0 to 3
  explicit Projection(const Eigen::Matrix3f& projector) {
    const float rank = projector.trace();
    const bool plane = rank > 1.5f;
    const Eigen::Matrix3f square = plane ? Eigen::Matrix3f::Identity() - projector : projector;
    Eigen::Index column = 0;
    const bool none = square.diagonal().maxCoeff(&column) < 0.1f;  // a third at least otherwise
    const Eigen::Vector3f vector = square.col(column).normalized();
    vector_ << (none ? Eigen::Vector3f::Zero() : vector), (plane ? 1.0f : 0.0f);
  }

  /// P x
  Row operator*(const Row& x) const {
    const float along = vector_[0] * x[0] + vector_[1] * x[1] + vector_[2] * x[2];
    return is_plane() ? Row(x - along * vector()) : Row(along * vector());
  }

  /// block P
  friend Block operator*(const Block& block, const Projection& p) {
    const Row v = p.vector();
    const Row along = block.col(0) * v[0] + block.col(1) * v[1] + block.col(2) * v[2];
    if (!p.is_plane()) return along * v.head<3>().transpose();
    return block - along * v.head<3>().transpose();
  }

 private:
  bool is_plane() const { return vector_[3] > 0.0f; }
  Row vector() const { return without_spare_lane(vector_); }

  Row vector_;  // in the spare lane 1 for a plane, 0 for a line
};

/// The projections of the rows that have one.
struct Projections {
  Chosen chosen;
  std::vector<Projection> of;
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

/// Nine packed numbers as a block. Reads one float beyond them.
inline Block unpacked(const float* values) {
  using Column = Eigen::Map<const Row>;
  Block result;
  for (int k = 0; k < 3; ++k) result.col(k) = Column(values + 3 * k);
  return result;
}

/// block x, with 0 in its spare lane
inline Row times(const Block& block, const Row& x) {
  return without_spare_lane(block.col(0) * x[0] + block.col(1) * x[1] + block.col(2) * x[2]);
}

}  // namespace evenmesh
