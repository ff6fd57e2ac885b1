// SPDX-License-Identifier: MIT
#include <cstddef>

#include <fmt/core.h>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/exit_code.h"
#include "apps/evenmesh/page.h"
#include "apps/evenmesh/paths.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh::app {

namespace {

void write_html(const CheckArguments& arguments, const Input& input, const CellQuality& quality,
                const QualitySummary& summary, std::size_t bad) {
  const ShownMesh shown = shown_mesh(input, quality);
  ReportPage page = page_of(input, summary);
  page.kind = PageKind::check;
  page.status = bad == 0 ? "ok" : "bad cells";
  page.message = fmt::format("{} as it is", arguments.input.path);
  page.command = arguments.command;
  page.verdicts = {
      {"no inverted cells", summary.inverted == 0, with_commas(summary.inverted) + " inverted"},
      {"every cell has a size", bad == 0,
       bad == 0 ? "and a positive shape"
                : count_of(bad, "cell is", "cells are") + " inverted or without a positive shape"}};
  add_changes(shown, page);
  list_worst(input, shown, page);
  write_page(arguments.html, page, shown);
}

}  // namespace

int check_command(const CheckArguments& arguments, const Console& console) {
  constexpr std::size_t kShown = 10;
  check(Options{.threads = arguments.threads});
  check_html_path("--report", arguments.html.path, {arguments.input.path});
  const Input input = load(arguments.input, console);
  Workers workers(arguments.threads);
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
  if (!arguments.html.path.empty()) {
    write_html(arguments, input, quality, summary, bad);
    console.say("wrote " + arguments.html.path);
  }
  if (bad == 0) return input.inverted_by_curves == 0 ? kDone : kBelowTarget;
  console.say(fmt::format("{} inverted or without a positive shape ({} inverted)",
                          bad == 1 ? "1 cell is" : with_commas(bad) + " cells are",
                          with_commas(summary.inverted)));
  return kBelowTarget;
}

}  // namespace evenmesh::app
