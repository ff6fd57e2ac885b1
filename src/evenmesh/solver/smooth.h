// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/solver/report.h"

namespace evenmesh {

struct Options {
  /// What moves the vertices. The classic methods leave the problem's costs alone (which are
  /// reported), and of its demands they know the freedom of vertices, limits of moves and the
  /// deviation; others are refused.
  Method method = Method::lagrange_newton;
  /// How lagrange_newton finds the minimiser.
  SolverKind solver = SolverKind::automatic;
  /// Stop when the gradient, in the preconditioner's norm and relative to the start, is at most
  /// this. 1e-4 is final to the eye. Classic methods: when in one sweep no vertex moves farther
  /// than this times the mean length of its edges in the input. In (0, 1).
  double tolerance = 1e-6;
  /// dense: stop when eta of the paper's Eq. (12) is below this, in the unit of the costs. 0: below
  /// tolerance^2 (at least 1e-12) times the cost at the start, which asks for about as much as
  /// tolerance does. >= 0.
  double eta = 0.0;
  int max_iterations = 200;         // >= 0
  double time_limit_seconds = 0.0;  // wall-clock for the iterations; 0: none
  int threads = 1;  // 0: one per core, at most 1024; the result has the same bits for any number
  /// Cells whose metric `shape` is less than this are made better after the iterations, at some
  /// expense of those around them (lift_worst()). 0: less than half the mean, and only if the costs
  /// have `shape` among them and quality is judged; below 0: none. At most 1. Not for classic
  /// methods and the dense solver.
  double lift_below = 0.0;
  /// What must not get worse. `nothing` is for comparisons and for teaching: the bare method, whose
  /// result may be folded (Report::quality_after counts the cells). Its demand for valid cells is
  /// then the problem's alone: see Validity::demanded.
  Judge judge = Judge::quality_and_inversion;
  /// What the output can hold of positions (single precision, fixed columns): what moved is rounded
  /// with this before it is judged. Must leave positions of the input as they are.
  std::function<std::vector<Vec3>(Points)> representable = {};
  /// Vertices of cells that would be spoilt at positions in a way that the mesh does not know, such
  /// as cells of second order with curved edges (CurvedCells): they go back towards where they
  /// were. Must be empty for the positions of the input.
  std::function<std::vector<Index>(Points)> spoilt = {};
  /// Called after every iteration from the calling thread; return false to stop there.
  std::function<bool(const Iteration&)> progress = {};
  /// Called for every iterate of the history, just before progress, with where vertices are there:
  /// as the solver goes, before the promise is kept. Not for steps that bring vertices to targets.
  std::function<void(const Iteration&, Points)> watch = {};
  /// dense: asked often during an iteration, which may take long; return true to stop where it
  /// began.
  std::function<bool()> interrupted = {};
};

/// @throws InvalidOption  an option is outside its range. For those who want to know before they
///                        read a large mesh; smooth() asks too.
void check(const Options& options);

/// Moves the vertices of a mesh to where the problem's cost is least, by a nonlinear conjugate
/// gradient method preconditioned with multigrid, by Newton's method, or by the dense method of the
/// paper (Options::solver); or as a classic method has it (Options::method). Where a cost wants
/// valid cells (Cost::wants_valid_cells()) and the mesh has inverted ones, it is untangled with
/// untangling_terms() first, as a part of the run.
///
/// Afterwards, in comparison with the input:
/// - vertices that the problem fixes have the same bits,
/// - no cell is inverted that was not, and none that was is worse,
/// - for every metric the worst value over the mesh is at least as good (unless cells were inverted
///   before: getting rid of them comes first), and the mean of `shape` is at least as high (unless
///   inverted cells have all become valid). If options.judge leaves quality out that does not
///   count, and with `nothing` cells may be inverted too.
/// With targets this is in comparison with the mesh after vertices were brought to them, which the
/// caller may find to have cells that are inverted and were not.
/// Where the minimiser would break this, vertices around the offending cells are pulled back
/// towards where they were; where its mean of `shape` is lower than the input's, an earlier iterate
/// may be kept instead. Report::promise says so. In the latter case milder_terms() may be minimised
/// as well, and what comes of that kept if it is better (Report::milder_cost).
///
/// The result does not depend on the number of threads, bit for bit. About 500 bytes per vertex.
/// @throws InvalidOption  an option is outside its range, a bound names a vertex that is not there
///                        or has its limits the wrong way round, the method cannot do what the
///                        problem asks, or the mesh is so small or large that squares of its
///                        lengths leave the range of doubles (1e-100, 1e100)
/// @pre  the problem was made for this mesh (or one with the same connectivity)
Report smooth(Mesh& mesh, const Problem& problem, const Options& options = {});

}  // namespace evenmesh
