// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/exit_code.h"
#include "apps/evenmesh/page.h"
#include "apps/evenmesh/paths.h"
#include "evenmesh/base/error.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh::app {
namespace {

// What keeps two meshes from being two states of one; empty if nothing does.
std::string difference(const Input& before, const Input& after) {
  const Mesh& a = before.file.mesh;
  const Mesh& b = after.file.mesh;
  if (a.point_count() != b.point_count()) {
    return fmt::format("the one has {}, the other {}",
                       count_of(a.point_count(), "vertex", "vertices"),
                       count_of(b.point_count(), "vertex", "vertices"));
  }
  if (a.cells().size() != b.cells().size()) {
    return fmt::format("the one has {}, the other {}", cell_counts(a.cells()),
                       cell_counts(b.cells()));
  }
  for (std::size_t c = 0; c < a.cells().size(); ++c) {
    const auto cell = [&] { return before.file.patch->cell_name(c); };
    if (a.cells().kind(c) != b.cells().kind(c)) {
      return fmt::format("{} is a {} in the one and a {} in the other", cell(),
                         traits(a.cells().kind(c)).name, traits(b.cells().kind(c)).name);
    }
    if (!std::ranges::equal(a.cells().vertices(c), b.cells().vertices(c))) {
      return fmt::format("{} has other vertices", cell());
    }
  }
  return "";
}

}  // namespace

int compare_command(const CompareArguments& arguments, const Console& console) {
  check(Options{.threads = arguments.threads});
  check_html_path("--output", arguments.html.path, {arguments.before.path, arguments.after});
  const Input before = load(arguments.before, console);
  InputArguments of_after = arguments.before;
  of_after.path = arguments.after;
  const Input after = load(of_after, console);
  const std::string different = difference(before, after);
  if (!different.empty()) {
    throw InvalidOption(fmt::format("{} and {} do not have the same cells: {}",
                                    arguments.before.path, arguments.after, different));
  }

  Workers workers(arguments.threads);
  const Mesh& mesh = before.file.mesh;
  const Points points = after.file.mesh.points();
  const CellQuality from = measure_cells(workers, mesh, mesh.points(), before.orientation);
  const CellQuality to = measure_cells(workers, mesh, points, before.orientation);
  ShownMesh shown = shown_mesh(before, from);
  shown.after = points;
  shown.quality_after = &to;
  ReportPage page = page_of(before, summarize(workers, from));
  page.kind = PageKind::compare;
  page.title += " | " + after.file.path.filename().string();
  page.after = summarize(workers, to);
  page.status = "ok";
  page.message =
      fmt::format("{} and {}, which have the same cells", arguments.before.path, arguments.after);
  page.command = arguments.command;
  page.verdicts = {no_inverted_cells(page.before, *page.after),
                   worst_not_lower(page.before, *page.after, true)};
  add_changes(shown, page);
  list_worst(before, shown, page);
  write_page(arguments.html, page, shown);
  print(quality_table(page.before, &*page.after));
  console.say("wrote " + arguments.html.path);
  return kDone;
}

}  // namespace evenmesh::app
