// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "evenmesh/classic/method.h"
#include "evenmesh/quality/quality.h"

namespace evenmesh {

/// Why the solver stopped.
enum class Stop : std::uint8_t {
  converged,        // the gradient fell below the tolerance
  iteration_limit,  // Options::max_iterations steps were taken
  time_limit,       // Options::time_limit_seconds passed
  interrupted,      // the progress callback asked to stop
  no_descent,      // no step along the descent direction lowers the cost: as low as doubles resolve
  nothing_to_move  // every vertex is fixed
};

/// The word for it in reports: "iteration_limit".
constexpr std::string_view name(Stop stop) {
  constexpr std::string_view kNames[] = {"converged",   "iteration_limit", "time_limit",
                                         "interrupted", "no_descent",      "nothing_to_move"};
  return kNames[static_cast<int>(stop)];
}

/// What of a result is judged in comparison with the input.
enum class Judge : std::uint8_t {
  quality_and_inversion,
  inversion,  // quality may get worse where the costs ask for it
  nothing     // cells may turn over: no step is shortened and no vertex pulled back for them
};

/// Whether the result keeps the promise that nothing got worse, and what it took.
enum class Promise : std::uint8_t {
  kept,             // the minimiser itself keeps it
  pulled_back,      // some vertices were pulled back towards where they were
  earlier_iterate,  // from a certain iterate on the mean of shape falls: that one was kept
                    // (and vertices may have been pulled back from there)
  unimproved,       // only the input itself keeps it: the mesh was left as it was
  lifted  // Options::judge says so: quality was not judged, or nothing but fixed vertices was
};

constexpr std::string_view name(Promise promise) {
  constexpr std::string_view kNames[] = {"kept", "pulled_back", "earlier_iterate", "unimproved",
                                         "lifted"};
  return kNames[static_cast<int>(promise)];
}

/// How the minimiser is found.
enum class SolverKind : std::uint8_t {
  automatic,  // multigrid; and where that gets slow and Newton's equations are affordable, newton
  multigrid,  // conjugate gradients preconditioned with multigrid: any size
  newton,     // Newton's method with sparse Cholesky: for small meshes, last digits, soft costs
  dense       // the paper's Lagrange-Newton method with dense curvature: the reference
};

constexpr std::string_view name(SolverKind kind) {
  constexpr std::string_view kNames[] = {"automatic", "multigrid", "newton", "dense"};
  return kNames[static_cast<int>(kind)];
}

/// The stop criterion of the paper's method, Eq. (12), at x = x_old + alpha h with the multipliers
/// lambda found at x_old.
struct StopMeasure {
  double model = 0.0;     // |q(alpha h)|, the change of the quadratic model of the cost
  double active = 0.0;    // sum of |lambda_i c_i(x)| over active constraints and equations
  double inactive = 0.0;  // sum of |min(0, c_i(x))| over the other inequalities
  double sum() const { return model + active + inactive; }
};

/// One iterate of the solver.
struct Iteration {
  int number = 0;               // 0: the input
  double cost = 0.0;            // f and what constraints add to it, in the units of the costs
  double gradient = 0.0;        // |g| in the norm sqrt(g^T M g) of the preconditioner M, over the
                                // same at the start; does not depend on the size of the mesh.
                                // Classic methods: longest move of a vertex in this step over the
                                // mean length of its edges in the input; 1 for the input. dense:
                                // the root of eta over the same at the first step
  double plain_gradient = 0.0;  // Euclidean |g| over the same at the start; or as gradient
  double step = 0.0;            // step length along the search direction; 0 for the input
  double max_move = 0.0;        // longest move of a vertex in this step, mesh length unit
  std::size_t limited = 0;      // vertices whose step was shortened so that no cell turns over
  std::size_t inverted = 0;     // cells with a vertex that may move; by their corners alone, but
                                // for classic methods
  int function = 0;             // costs only compare between iterates with the same number: it
                                // rises when a penalty or multiplier has changed
  int evaluations = 0;          // of cost and gradient so far
  double seconds = 0.0;         // wall-clock since the solver began
  StopMeasure eta = {};         // dense only
};

/// A demand on a cell that is active or not met.
struct ActiveCell {
  std::uint32_t cell = 0;   // number in the mesh
  double multiplier = 0.0;  // cost gained per unit by which the demand is relaxed, a cell's size
                            // counting as 1
  double excess = 0.0;      // how far from being met, in the same units; 0: met
};

/// A limit on a vertex's move, or a bound on a function, that is active or not met.
struct ActiveBound {
  std::size_t number = 0;   // of the vertex, or of the bound in Problem::bounds
  double multiplier = 0.0;  // derivative of the cost with respect to the bound; of a move's limit
                            // what the cost gains per length by which it is relaxed
  double excess = 0.0;      // how far beyond the limit, in its own unit; 0: met
};

/// What keeps vertices back from lowering the cost further.
struct Holding {
  /// Per vertex: the derivative of the cost with respect to a move that what was eliminated forbids
  /// (being fixed, sliding on a line or surface): the length of that constraint's multiplier. Of a
  /// tied vertex what the others take from it. 0 where the vertex is free.
  std::vector<float> of_vertex;
  std::vector<ActiveCell> cells;   // by cell
  std::vector<ActiveBound> moves;  // by vertex
  std::vector<ActiveBound> bounds;
};

/// What was done for the worst cells after the iterations.
struct Lifting {
  std::size_t cells = 0;  // that became better
  int iterations = 0;     // in addition to those of the history
};

/// What happened to a mesh, in numbers.
struct Report {
  Stop stop = Stop::nothing_to_move;
  Promise promise = Promise::kept;
  Method method = Method::lagrange_newton;
  std::vector<Iteration> history;  // history[0] is the input

  double cost_before = 0.0;
  double cost_after = 0.0;  // of the mesh handed back
  QualitySummary quality_before;
  QualitySummary quality_after;

  std::size_t vertices = 0;
  std::size_t movable = 0;      // vertices that were allowed to move
  std::size_t moved = 0;        // vertices whose position is not what it was, bit for bit
  std::size_t held = 0;         // vertices stopped on the way so that no cell turns over
  std::size_t pulled_back = 0;  // vertices pulled back so that nothing is worse than before
  /// Cells inverted where the method wanted the vertices, before any was pulled back.
  std::size_t inverted_unguarded = 0;
  double max_move = 0.0;   // longest move, mesh length unit
  double mean_move = 0.0;  // over the vertices that moved

  /// That did it, or finished it: not automatic. Without meaning for classic methods.
  SolverKind solver = SolverKind::multigrid;
  int newton_steps = 0;  // of the iterations

  double deviation = 0.0;  // of the shape from the input's, both ways, where it was measured
  std::size_t unmet = 0;   // demands on cells, moves and functions that are not met
  Lifting lifting;
  /// The history and costs are those of a cost that counts the worst cells less than `shape` does,
  /// since the mean of shape fell with that.
  bool milder_cost = false;
  int target_steps = 0;  // in which vertices were brought to their targets
  Holding holding;

  int multigrid_levels = 0;
  double setup_seconds = 0.0;      // ordering, layout, preconditioner
  double setup_cpu_seconds = 0.0;  // layout and preconditioner alone, CPU time of all threads
  double solve_seconds = 0.0;      // iterations
  double check_seconds = 0.0;      // measuring and keeping the promise
};

}  // namespace evenmesh
