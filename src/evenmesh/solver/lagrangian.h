// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/solver/layout.h"
#include "evenmesh/solver/report.h"

namespace evenmesh {

/// What constraints add to the cost so that its minimiser meets them.
///
/// Every demand is a row v(x) >= 0 (or = 0), measured in units in which a cell's size counts as 1,
/// with a weight w: the energy it takes to deform the cells there as much. Rows add w psi(v):
///
/// - exact L1, smoothed:  psi = mu/2 (sqrt(v^2 + 4 delta^2) - v). For delta -> 0 this is the
///   penalty mu |min(0, v)| of the paper's Eq. (4); it is smooth, and finite for inverted cells, so
///   that a tangled mesh is untangled by minimising it. Used in stages of smaller and smaller
///   delta, and only if the start violates a row.
/// - augmented Lagrangian:  psi = (max(0, lambda - rho v)^2 - lambda^2) / (2 rho). After each
///   minimisation lambda <- max(0, lambda - rho v) (equations: without the max). Where no row is
///   active it adds nothing. (Nocedal and Wright, 2006, section 17.3)
class Lagrangian {
 public:
  enum class Mode : std::uint8_t { exact_penalty, multipliers };

  /// @param input   whose cells tell what is demanded of each
  /// @param origin  where moves are measured from: the input's points, or where these came from
  /// All arguments must outlive the object.
  Lagrangian(Workers& workers, const Mesh& input, Points origin, const Problem& problem,
             const Layout& layout);

  /// Begins anew at x, with multipliers 0.
  void reset(Workers& workers, Points x);

  // ---- the function -----------------------------------------------------------------------------

  /// The rows of a block's cells.
  /// @param gradient  added to; or empty
  double evaluate(const Layout::Block& block, Points x, std::span<Vec3> gradient) const;
  /// All other rows.
  double evaluate_others(Points x, std::span<Vec3> gradient) const;

  // ---- second derivatives of the rows that are no cell's ----------------------------------------

  /// What a bound on a function c of Problem::bounds adds, as a function of the positions `own` of
  /// the vertices of c, in their order.
  /// @param[out] gradient  one vector per vertex of c; or empty
  double evaluate_bound(std::size_t bound, Points own, std::span<Vec3> gradient) const;
  /// The greater part of the second derivatives of that: factor * slope slope^T.
  /// @param[out] slope  of c, one vector per vertex of c
  double curvature_of_bound(std::size_t bound, Points own, std::span<Vec3> slope) const;
  /// The second derivatives of what a limited move adds are a matrix over its vertex: calls
  /// body(vertex, matrix) for each.
  void for_leashes(Points x, const std::function<void(Index, const Eigen::Matrix3d&)>& body) const;

  // ---- rows one by one, for methods that have multipliers of their own --------------------------

  /// A demand by itself: v >= 0, or v = 0.
  struct Row {
    double value;  // v, less what is aimed at beyond the demand so that it is met strictly
    bool is_equation;
    std::span<const Index> vertices;  // that it depends on
    std::span<const Vec3> slope;      // derivative of v with respect to each of these
  };
  /// Calls body with every row, always in the same order. Serial.
  void for_each_row(Points x, const std::function<void(const Row&)>& body) const;
  /// Takes multipliers found elsewhere, of v as Row has it, in the order of for_each_row(), in the
  /// unit of the costs.
  void set_multipliers(std::span<const double> multipliers);

  // ---- the schedule -----------------------------------------------------------------------------

  /// To be called now and then: sees to stages and multipliers.
  /// @param steps      since the function has changed last
  /// @param minimised  the function as it is has been minimised
  /// @return  true if the function has changed
  bool advance(Workers& workers, Points x, int steps, bool minimised);
  /// True while no row has been violated: the function is the cost alone, and rows are only looked
  /// at by advance().
  bool dormant() const { return dormant_; }
  Mode mode() const { return mode_; }

  // ---- what came of it --------------------------------------------------------------------------

  /// How far x is from meeting the demands.
  struct Violation {
    double greatest = 0.0;     // of -v over rows (|v| for equations); 0: all are met
    std::size_t cells = 0;     // whose demand is not met
    std::size_t inverted = 0;  // of these: with a determinant of 0 or less
  };
  Violation violation(Workers& workers, Points x) const;

  /// What is active or not met at x, with its multiplier.
  std::vector<ActiveCell> active_cells(Workers& workers, Points x) const;
  std::vector<ActiveBound> active_bounds(Points x) const;
  std::vector<ActiveBound> active_moves(Points x) const;

 private:
  // What is demanded of one cell.
  struct Demand {
    float scale = 0.0f;   // v = scale / size_unit_ * determinant - least; 0: nothing is demanded
    float least = 0.0f;   // eps over the determinant of the ideal cell
    float weight = 0.0f;  // over weight_unit_
    std::uint32_t row = 0;
  };
  // One side of a bound on a function.
  struct FunctionRow {
    std::uint32_t bound;
    double sign;   // 1: c >= value, -1: c <= value
    double value;  // of the bound
    bool equation;
    double unit = 1.0;  // of c: v = sign * (c - value) / unit
    double lambda = 0.0;
  };
  // A vertex that must not go too far: v = 1 - |x - x_0|^2 / length^2.
  struct Leash {
    Index vertex;
    double length;
    double lambda = 0.0;
  };
  struct Slope {
    double value;
    double derivative;
    double curvature;  // second derivative
  };

  void set_up_scales(Workers& workers);
  void set_up_cells(Workers& workers);
  void set_up_functions();
  double typical_stiffness(CellBlock cells) const;

  Slope psi(double v, double lambda) const;
  Slope psi_of_equation(double v, double lambda) const;
  /// Of the function of a bound.
  double value(std::size_t bound, Points x, std::span<Vec3> gradient) const;
  Slope psi_of(const FunctionRow& row, double c) const;
  double weight_of_functions() const {
    return other_stiffness_ * typical_length_ * typical_length_;
  }
  double value_of(const FunctionRow& row, double c) const {
    return row.sign * (c - row.value) / row.unit;
  }
  double value_of(const Leash& leash, Points x) const;
  /// Calls body(place, row, v, corner) for every row of a block's cells.
  template <typename Body>
  void for_rows(const Layout::Block& block, Points x, const Body& body) const;
  double weight_of(const Leash& leash) const {
    return other_stiffness_ * leash.length * leash.length;
  }

  void enter_stage(int stage);
  void take_multipliers_from_penalty(Workers& workers, Points x);
  /// Returns the greatest |min(v, lambda / rho)|: 0 where demands are met and multipliers belong.
  double residual(Workers& workers, Points x) const;
  void update_multipliers(Workers& workers, Points x);

  const Mesh& input_;
  const Points origin_;
  const Problem& problem_;
  const Layout& layout_;
  double dimension_ = 2.0;
  std::vector<double> sizes_;        // per cell, while setting up
  std::vector<double> stiffnesses_;  // per chunk
  double size_unit_ = 1.0;
  double weight_unit_ = 1.0;
  double other_stiffness_ = 1.0;
  double typical_length_ = 1.0;
  std::vector<Demand> demands_;  // per cell in the layout's order; empty: none
  std::vector<float> lambda_;    // per row of a cell
  std::vector<FunctionRow> functions_;
  std::vector<Leash> leashes_;

  Mode mode_ = Mode::multipliers;
  int stage_ = 0;
  int rounds_ = 0;  // of multipliers
  double delta_ = 0.0;
  double mu_ = 0.0;
  double rho_ = 0.0;
  double last_residual_ = 0.0;
  bool dormant_ = false;
};

}  // namespace evenmesh
