// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/constraint/function.h"
#include "evenmesh/constraint/motion.h"
#include "evenmesh/constraint/prescribe.h"
#include "evenmesh/constraint/validity.h"
#include "evenmesh/cost/cost.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// A cost and how much it counts. Weights are raw factors; they need not add up to 1.
struct Term {
  double weight = 1.0;  // > 0 and finite
  std::shared_ptr<const Cost> cost;
};

/// What to minimise and under which constraints:  f(x) = sum over terms of weight * cost(x)  over
/// the positions that `motion` allows and at which all demands are met.
struct Problem {
  std::vector<Term> terms;
  Motion motion;
  Orientation orientation;  // which way is up in the input; judges inverted cells

  // Demands, each of which the result meets or is reported not to meet.
  Validity validity;
  std::vector<Bound> bounds;     // functions kept equal to a value or within an interval
  std::vector<double> max_move;  // per vertex, mesh length unit, may be infinite; empty: no limits
  /// How far vertices on curves and surfaces of the input, and the edges and faces between them,
  /// may be from these; mesh length unit. Where there are targets: from what the vertices that
  /// were brought there make of these.
  double max_deviation = std::numeric_limits<double>::infinity();
  /// Where vertices are to be brought before the rest is optimised, by increasing vertex, each
  /// once: they were prescribed, or slide on something that they are not on yet. Motion says
  /// whether they stay there.
  std::vector<Target> targets;
};

/// A cost by name with its weight, as in `--cost local=0.3,barycenter=0.3`.
struct CostChoice {
  std::string name;
  double weight = 1.0;
};

struct ProblemOptions {
  /// Costs and weights; empty: shape=1.
  std::vector<CostChoice> costs;
  Scaling scaling = Scaling::absolute;
  /// L of the cost global; 0: the mean edge length of the input, or, if cells are inverted there,
  /// the length its area (or volume) has room for.
  double global_length = 0.0;
};

/// Puts the costs into a problem that is otherwise complete: see apply() in constraints.h.
/// @throws InvalidOption  as make_problem()
void add_costs(const Mesh& mesh, const ProblemOptions& options, Problem& problem);

/// Costs that untangle a mesh: of edge lengths, which do not know which way a cell is turned, so
/// that the demand for valid cells meets no resistance. local=1 for triangles and tets, and 0.3
/// barycenter beside 0.3 local as soon as there are cells that edge lengths alone let shear.
std::vector<Term> untangling_terms(const Mesh& mesh, const Problem& problem);

/// The problem for a mesh in which the given vertices stay and nothing else is demanded: the others
/// move in the plane of a planar mesh, freely in a volume mesh, and on the input's surface, edges
/// along themselves, on a surface mesh.
/// @param fixed  per vertex: may not move
/// @throws InvalidOption  an unknown cost (the message has the known ones), a weight that is not
///                        positive and finite, or nothing keeps the mesh from collapsing.
/// @pre  fixed has one entry per vertex
Problem make_problem(const Mesh& mesh, Orientation orientation, std::span<const char> fixed,
                     const ProblemOptions& options = {});

/// The names make_problem() knows.
std::vector<std::string> cost_names();

/// A vertex of a piece of the mesh whose vertices may all move to a single place: fewer than two
/// are fixed, and no lines or planes hold the others apart. Nothing if there is none, or the mesh
/// is a surface, which tangent planes hold.
std::optional<Index> find_loose_vertex(const Mesh& mesh, const Problem& problem);

/// Throws InvalidOption, with the remedy, if the costs are least when a piece of the mesh shrinks
/// to a point: all of them can collapse, no demand keeps cells above a size, and there is a loose
/// vertex.
void check_for_collapse(const Mesh& mesh, const Problem& problem);

}  // namespace evenmesh
