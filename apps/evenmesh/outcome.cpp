// SPDX-License-Identifier: MIT
#include "apps/evenmesh/outcome.h"

#include <algorithm>

#include <fmt/core.h>

#include "apps/evenmesh/console.h"

namespace evenmesh::app {
namespace {

bool asks_of_cells(const ConstraintText& asked) {
  return !(asked.min_area.empty() && asked.min_volume.empty() && asked.min_jacobian.empty());
}

bool asks_of_moves(const ConstraintText& asked) {
  return !(asked.max_move.empty() && asked.limit.empty());
}

// The first demand of a kind that is not met; null if all are.
template <typename Active>
const Active* first_unmet(const std::vector<Active>& demands) {
  const auto found = std::find_if(demands.begin(), demands.end(),
                                  [](const Active& active) { return active.excess > 0.0; });
  return found == demands.end() ? nullptr : &*found;
}

// How far from its end it was.
std::string where_it_stopped(const Report& report) {
  const double gradient = report.history.back().gradient;
  return report.method == Method::lagrange_newton
             ? fmt::format("gradient at {:.1e} of its start", gradient)
             : fmt::format("vertices still moving by up to {:.1e} of their edges", gradient);
}

// The solver's part of the outcome.
std::string how_it_stopped(const Report& report) {
  const Iteration& last = report.history.back();
  const std::string count =
      count_of(static_cast<std::size_t>(last.number), "iteration", "iterations");
  if (report.promise == Promise::earlier_iterate) {
    return fmt::format("kept what was reached after {}, since the mean shape falls from there on",
                       count);
  }
  switch (report.stop) {
    case Stop::converged:
      return last.number == 0 ? "the mesh is as even as its cost can make it already"
                              : "converged in " + count;
    case Stop::no_descent:
      return "as low as double precision resolves after " + count;
    case Stop::iteration_limit:
      return fmt::format("stopped at the limit of {}, {}", count, where_it_stopped(report));
    case Stop::time_limit:
      return fmt::format("stopped at the time limit after {}, {}", count, where_it_stopped(report));
    case Stop::interrupted:
      return "interrupted after " + count;
    case Stop::nothing_to_move:
      break;
  }
  return "nothing may move";
}

// What may be done about a cell, and what is known of its own vertices. Where vertices were pulled
// back, that may be the reason as well.
std::string advice_on(std::size_t cell, const Ending& ending) {
  std::string text = asks_of_cells(ending.arguments.constraints) ? "; lower the demand" : "";
  if (ending.report.pulled_back > 0) return text;
  const auto vertices = ending.input.file.mesh.cells().vertices(cell);
  const auto bound = std::count_if(vertices.begin(), vertices.end(), [&](Index v) {
    const Motion::Freedom freedom = ending.problem.motion.freedom(v);
    return freedom == Motion::Freedom::fixed || freedom == Motion::Freedom::line;
  });
  if (bound == 0) return text;
  return text +
         fmt::format(" ({} of its {} vertices {})", bound, vertices.size(),
                     bound == 1 ? "is fixed or slides on a line" : "are fixed or slide on a line");
}

// One demand of each kind that is not met, those that were asked for first.
std::vector<std::string> examples(const Ending& ending) {
  const Holding& holding = ending.report.holding;
  const FilePatch& patch = *ending.input.file.patch;
  std::vector<std::string> found;
  if (const ActiveBound* active = first_unmet(holding.moves)) {
    found.push_back(fmt::format("{} is {:.3g} too far from where it was",
                                patch.vertex_name(static_cast<Index>(active->number)),
                                active->excess));
  }
  if (const ActiveBound* active = first_unmet(holding.bounds)) {
    found.push_back(fmt::format("{} is off by {:.3g}",
                                ending.problem.bounds[active->number].function->name(),
                                active->excess));
  }
  if (const ActiveCell* active = first_unmet(holding.cells)) {
    const bool asked = asks_of_cells(ending.arguments.constraints);
    found.insert(asked ? found.begin() : found.end(), patch.cell_name(active->cell) +
                                                          " is too small or inverted" +
                                                          advice_on(active->cell, ending));
  }
  return found;
}

std::string unmet_demands(const Ending& ending) {
  const std::size_t unmet = ending.report.unmet;
  if (unmet == 0) return "";
  const std::string first = examples(ending).front();
  if (unmet == 1) return "; 1 demand is not met: " + first;
  return fmt::format("; {} demands are not met, the first: {}", with_commas(unmet), first);
}

}  // namespace

std::string outcome(const Ending& ending) {
  const Report& report = ending.report;
  const SmoothArguments& arguments = ending.arguments;
  if (ending.input.file.mesh.cells().empty()) {
    return "the mesh has no cells, so there is nothing to do";
  }
  if (report.stop == Stop::nothing_to_move && arguments.only_failing) {
    return fmt::format("nothing may move: no vertex that may is near a cell below {}",
                       arguments.target);
  }
  if (report.stop == Stop::nothing_to_move) {
    return fmt::format(
        "nothing may move: every vertex is fixed (--fix {}) or has no area around it; to see what "
        "keeps it: evenmesh {} --dry-run",
        arguments.constraints.fix, arguments.input.path);
  }
  if (report.promise == Promise::unimproved) {
    const bool costs = report.method == Method::lagrange_newton;
    return fmt::format(
        "no vertex can follow the {} without making the worst cell or the mean shape worse; try "
        "other {}, fewer fixed vertices (--fix), or --allow-worse",
        costs ? "cost" : "method", costs ? "costs (--cost)" : "methods (--method)");
  }
  std::string text = how_it_stopped(report);
  if (report.milder_cost)
    text += " with a milder cost, since with shape the mean would have fallen";
  if (report.held > 0) {
    const bool surface = ending.input.orientation.type == MeshType::surface;
    text += fmt::format("; {} stopped early so that no cell gets too bad{}",
                        count_of(report.held, "vertex", "vertices"),
                        surface ? " and none goes too far" : "");
  }
  if (report.lifting.cells > 0) {
    text += fmt::format("; {} then made better on purpose",
                        report.lifting.cells == 1
                            ? "1 bad cell was"
                            : with_commas(report.lifting.cells) + " bad cells were");
  }
  if (report.pulled_back > 0) {
    text += fmt::format("; {} pulled back so that nothing is worse than before",
                        count_of(report.pulled_back, "vertex", "vertices"));
  }
  if (report.deviation > 0.0) {
    text += fmt::format("; the shape is within {:.3g} of the input's", report.deviation);
  }
  return text + unmet_demands(ending);
}

bool fails_a_demand(const ConstraintText& asked, const Holding& holding) {
  return (asks_of_cells(asked) && first_unmet(holding.cells) != nullptr) ||
         (asks_of_moves(asked) && first_unmet(holding.moves) != nullptr) ||
         (!asked.keep.empty() && first_unmet(holding.bounds) != nullptr);
}

}  // namespace evenmesh::app
