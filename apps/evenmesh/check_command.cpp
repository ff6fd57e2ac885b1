// SPDX-License-Identifier: MIT
#include <cstddef>

#include <fmt/core.h>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/exit_code.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh::app {

int check_command(const InputArguments& arguments, int threads, const Console& console) {
  constexpr std::size_t kShown = 10;
  check(Options{.threads = threads});
  const Input input = load(arguments, console);
  Workers workers(threads);
  const Mesh& mesh = input.file.mesh;
  const CellQuality quality = measure_cells(workers, mesh, mesh.points(), input.orientation);
  const QualitySummary summary = summarize(workers, quality);
  print(quality_table(summary, nullptr));

  const std::vector<double>& shape = quality.of(Metric::shape);
  std::size_t bad = 0;
  for (std::size_t c = 0; c < shape.size(); ++c) bad += quality.inverted[c] || !(shape[c] > 0.0);
  const std::vector<char> none(mesh.point_count(), 0);
  print("\nworst cells          shape\n");
  for (const NamedCell& cell :
       name_cells(input, worst_cells(quality, kShown), quality, quality, none)) {
    print(fmt::format("{:<20} {:.4f}  {}{}\n", cell.name, cell.shape_after, traits(cell.kind).name,
                      cell.inverted ? ", inverted" : ""));
  }
  if (bad == 0) return input.inverted_by_curves == 0 ? kDone : kBelowTarget;
  console.say(fmt::format("{} inverted or without a positive shape ({} inverted)",
                          bad == 1 ? "1 cell is" : with_commas(bad) + " cells are",
                          with_commas(summary.inverted)));
  return kBelowTarget;
}

}  // namespace evenmesh::app
