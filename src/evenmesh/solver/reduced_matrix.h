// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/motion.h"

namespace evenmesh {

/// The unknowns y of a mesh's motion, x = x_0 + Z y, and a sparse symmetric matrix over them, such
/// as Z^T H Z for a Hessian H.
///
/// A vertex has as many unknowns, one after the other, as it has directions to move in; one that is
/// tied to another shares the other's. They are numbered so that a Cholesky factor of the matrix
/// is found in few operations: by approximate minimum degree or by nested dissection of space,
/// whichever takes fewer.
class ReducedMatrix {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Says which entries there are: those of every set of vertices that it visits, each with each.
  using Cliques = std::function<void(const std::function<void(std::span<const Index>)>& visit)>;

  /// @param x  where vertices are, about; decides on the numbers of the unknowns
  ReducedMatrix(const Motion& motion, Points x, const Cliques& cliques);

  std::size_t unknowns() const { return vertex_.size(); }
  /// Entries of the Cholesky factor, and multiplications (about) that it takes to find them.
  double factor_entries() const { return factor_entries_; }
  double factor_operations() const { return factor_operations_; }

  // ---- the unknowns -----------------------------------------------------------------------------

  /// Lets the unknowns be steps along axes that suit where vertices are. Vertices that are fixed
  /// by now keep their unknowns, with axes of length 0.
  void set_axes(const Motion& motion, const Motion::Places& places);
  /// The first unknown of a vertex, or kNone.
  std::uint32_t first(Index vertex) const { return first_[vertex]; }
  /// How many it has.
  int count(Index vertex) const { return count_[vertex]; }
  /// The greatest count.
  int most() const { return most_; }
  /// Unit, or zero.
  const Vec3& axis(std::uint32_t unknown) const { return axis_[unknown]; }
  Index vertex(std::uint32_t unknown) const { return vertex_[unknown]; }

  /// Z^T g
  Eigen::VectorXd reduced(Points g) const;
  /// Z y; 0 at vertices without unknowns and at those that are tied.
  void expand(const Eigen::VectorXd& y, std::span<Vec3> step) const;

  // ---- the matrix -------------------------------------------------------------------------------

  void set_zero();
  /// Adds a small dense matrix over the unknowns of some vertices. Calls for sets without a common
  /// vertex, ties included, may be made at the same time.
  /// @param block  the entry for the c-th unknown of vertices[k] and the d-th of vertices[l] is at
  ///               (s k + c, s l + d), s being rows over vertices
  /// @pre  the cliques had all pairs of these vertices
  void add(std::span<const Index> vertices, const Eigen::MatrixXd& block);
  /// Adds to the diagonal, times its mean; where an unknown has no entries at all sets it to the
  /// mean.
  void lift_diagonal(double relative);

  /// The upper triangle.
  const Eigen::SparseMatrix<double>& upper() const { return matrix_; }

 private:
  // A vertex coupled to another whose unknowns come later, and where in each of the other's columns
  // its own begin.
  struct Neighbour {
    std::uint32_t first;
    std::uint32_t place;
  };

  void number(const Motion& motion, Points x, const std::vector<std::vector<Index>>& coupled);
  void set_up_pattern(const std::vector<std::vector<Index>>& coupled);
  double* entries(std::uint32_t row_first, Index column_vertex, std::uint32_t column);

  int most_ = 0;
  double factor_entries_ = 0.0;
  double factor_operations_ = 0.0;
  std::vector<std::uint32_t> first_;      // per vertex
  std::vector<std::uint8_t> count_;       // per vertex
  std::vector<Index> leaders_;            // that have unknowns, in the order of these
  std::vector<Index> vertex_;             // per unknown
  std::vector<Vec3> axis_;                // per unknown
  std::vector<std::uint32_t> neighbour_;  // per vertex + 1: range of its neighbours
  std::vector<Neighbour> neighbours_;     // by first
  Eigen::SparseMatrix<double> matrix_;
};

}  // namespace evenmesh
