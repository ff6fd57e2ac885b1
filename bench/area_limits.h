// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "bench/local_hessian.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh::bench {

/// What boundary vertices may do.
enum class Rim { fixed, on_circle };

/// Least cost with no triangle too small, as a general nonlinear program: what evenmesh's answers
/// to constrained problems are checked against. Shares no code with its solvers and costs.
///
///   minimise  f(y)                    the cost `local`
///   such that a_e >= least            for every triangle e; a_e its signed area
///             |x_v|^2 / (2 R) = R / 2  for every boundary vertex v, if Rim::on_circle
///
/// Unknowns are x and y of the vertices that move. Interior point methods do best when steps, costs
/// and constraints are all of the order of one: give a mesh whose mean area is one.
class AreaLimits {
 public:
  /// @param mesh   triangles in the xy plane; must outlive this
  /// @param least  area that every triangle must have
  /// @pre  if Rim::on_circle, boundary vertices lie on a circle around the origin, whose radius is
  /// R
  AreaLimits(const Mesh& mesh, double least, Rim rim);
  AreaLimits(const AreaLimits&) = delete;
  AreaLimits& operator=(const AreaLimits&) = delete;

  std::size_t unknowns() const { return 2 * moving_.size(); }
  std::size_t constraints() const { return mesh_.cells().size() + on_circle_.size(); }
  /// R; 0 if Rim::fixed.
  double radius() const { return radius_; }
  /// Least and greatest value of every constraint.
  void bounds(std::span<double> lower, std::span<double> upper) const;
  std::vector<double> start() const;

  /// The cost at y; fills in the gradient unless it is empty.
  double cost(std::span<const double> y, std::span<double> gradient) const;
  /// a_e of every cell, then |x_v|^2 / (2 R) of every vertex on the circle.
  void evaluate(std::span<const double> y, std::span<double> values) const;

  /// The entries of the constraints' first derivatives, by constraint.
  const std::vector<int>& jacobian_rows() const { return jacobian_rows_; }
  const std::vector<int>& jacobian_columns() const { return jacobian_columns_; }
  void jacobian(std::span<const double> y, std::span<double> values) const;

  /// The entries of  factor f'' + sum multiplier_i c_i'': lower triangle, every entry once.
  const LocalHessian& hessian() const { return hessian_; }
  void hessian(std::span<const double> y, double factor, std::span<const double> multipliers,
               std::span<double> values) const;

 private:
  Eigen::Vector2d position(Index vertex, std::span<const double> y) const;
  std::array<Eigen::Vector2d, 3> corners(std::size_t cell, std::span<const double> y) const;

  const Mesh& mesh_;
  double least_;
  std::vector<Index> moving_;
  std::vector<Index> on_circle_;
  std::vector<std::ptrdiff_t> first_unknown_;  // per vertex; -1 if it is fixed
  double radius_ = 0.0;
  LocalHessian hessian_;
  std::vector<int> jacobian_rows_, jacobian_columns_;
};

}  // namespace evenmesh::bench
