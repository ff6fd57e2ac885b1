// SPDX-License-Identifier: MIT
#include "apps/evenmesh/page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>

#include "apps/evenmesh/console.h"
#include "evenmesh/io/output_file.h"
#include "evenmesh/mesh/measure.h"
#include "evenmesh/mesh/wall_layers.h"
#include "evenmesh/plot/metric_range.h"
#include "evenmesh/report/html_report.h"

namespace evenmesh::app {
namespace {

double total_size(const Mesh& mesh, const Orientation& orientation) {
  double sum = 0.0;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const bool counts =
        orientation.type != MeshType::volume || traits(mesh.cells().kind(c)).dimension == 3;
    if (counts) sum += oriented_size(mesh, orientation, c);
  }
  return sum;
}

std::string size_word(MeshType type) { return type == MeshType::volume ? "volume" : "area"; }

// "vertex" for "vertices".
std::string one_of(const std::string& unit) {
  if (unit == "vertices") return "vertex";
  return unit.ends_with('s') ? unit.substr(0, unit.size() - 1) : unit;
}

Verdict vertices_stayed(const RunRecord& record, const RunFacts& facts) {
  const std::string where = record.output.empty() ? "" : ", in the file as read back";
  if (facts.fixed_moved == 0) {
    return {"fixed vertices where they were", true,
            fmt::format("all {} bit for bit{}", with_commas(facts.fixed), where)};
  }
  return {"fixed vertices where they were", false,
          fmt::format("{} of {} would have moved", with_commas(facts.fixed_moved),
                      with_commas(facts.fixed))};
}

}  // namespace

ShownMesh shown_mesh(const Input& input, const CellQuality& quality) {
  const MeshFile& file = input.file;
  const FilePatch& patch = *file.patch;
  ShownMesh shown{.before = file.mesh,
                  .orientation = input.orientation,
                  .quality_before = quality,
                  .wall_layers = find_wall_layers(file.mesh, input.orientation),
                  .feature_edges = input.topology.curves,
                  .cell_number = [&patch](std::size_t cell) { return patch.cell_number(cell); }};
  if (file.mesh.cells().has_groups()) shown.group_names = file.group_names;
  shown.vertex_number = [&patch](Index v) {
    const auto numbers = patch.vertex_numbers();
    return numbers.empty() ? patch.first_vertex_number() + v : numbers[v];
  };
  return shown;
}

std::vector<Hold> holds_of(const Motion& motion, MeshType type) {
  std::vector<Hold> holds(motion.size(), Hold::free);
  for (Index v = 0; v < holds.size(); ++v) {
    const bool on_surface = motion.slot(v) != Motion::kNone || type == MeshType::surface;
    switch (motion.freedom(v)) {
      case Motion::Freedom::fixed:
        holds[v] = Hold::fixed;
        continue;
      case Motion::Freedom::line:
        holds[v] = Hold::line;
        break;
      case Motion::Freedom::plane:
        if (on_surface) holds[v] = Hold::plane;
        break;
      case Motion::Freedom::free:
        break;
    }
    if (motion.is_tied(v)) holds[v] = Hold::tied;
  }
  return holds;
}

ReportPage page_of(const Input& input, const QualitySummary& quality) {
  const Mesh& mesh = input.file.mesh;
  ReportPage page{.title = input.file.path.filename().string(), .before = quality};
  page.notes = input.file.notes;
  page.ledger.push_back(
      {"mesh", fmt::format("{}, {} in {}", name(input.orientation.type), cell_counts(mesh.cells()),
                           count_of(input.topology.components, "piece", "pieces"))});
  page.ledger.push_back({"vertices", with_commas(mesh.point_count())});
  if (input.file.followers.size() > 0) {
    page.ledger.push_back({"nodes between corners", with_commas(input.file.followers.size()) +
                                                        ", which are not shown: they move along"});
  }
  if (input.inverted_by_curves > 0) {
    page.notes.push_back(
        fmt::format("{} inverted by nodes between the corners, which are not shown.",
                    count_of(input.inverted_by_curves, "cell is", "cells are")));
  }
  return page;
}

void list_worst(const Input& input, const ShownMesh& mesh, ReportPage& page) {
  const std::vector<std::size_t> worst = worst_cells(mesh.quality(), kWorstInPage);
  const std::vector<char> none(mesh.before.point_count(), 0);
  const std::vector<NamedCell> named =
      name_cells(input, worst, mesh.quality_before, mesh.quality(), none);
  for (std::size_t i = 0; i < worst.size(); ++i) page.worst.push_back({named[i], worst[i]});
}

void add_changes(const ShownMesh& mesh, ReportPage& page) {
  const double size = total_size(mesh.before, mesh.orientation);
  const std::string word = size_word(mesh.orientation.type);
  if (!mesh.has_after()) {
    page.ledger.push_back({word, fmt::format("{:.6g}", size)});
    return;
  }
  const Points before = mesh.before.points();
  std::size_t moved = 0;
  double most = 0.0;
  double sum = 0.0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (before[v] == mesh.after[v]) continue;
    const double move = (mesh.after[v] - before[v]).stableNorm();
    ++moved;
    most = std::max(most, move);
    sum += move;
  }
  Mesh result = mesh.before;
  result.set_points({mesh.after.begin(), mesh.after.end()});
  const double size_after = total_size(result, mesh.orientation);
  page.ledger.push_back({"moved", fmt::format("{} of {}", with_commas(moved),
                                              count_of(before.size(), "vertex", "vertices"))});
  if (moved > 0) {
    page.ledger.push_back({"longest move", fmt::format("{:.4g}", most)});
    page.ledger.push_back(
        {"mean move", fmt::format("{:.4g} of those that moved", sum / static_cast<double>(moved))});
  }
  constexpr double kRounding = 1e-12;  // of a sum over many cells
  const double change = size != 0.0 ? (size_after - size) / std::abs(size) : 0.0;
  page.ledger.push_back({word, std::abs(change) < kRounding
                                   ? fmt::format("{:.6g} as before", size)
                                   : fmt::format("{:.6g} before, {:.6g} after ({:+.2g} %)", size,
                                                 size_after, 100.0 * change)});
}

Verdict no_inverted_cells(const QualitySummary& before, const QualitySummary& after) {
  return {"no inverted cells", after.inverted == 0,
          fmt::format("{} before, {} after", with_commas(before.inverted),
                      with_commas(after.inverted))};
}

Verdict worst_not_lower(const QualitySummary& before, const QualitySummary& after, bool judged) {
  Verdict verdict{"worst quality not lower", true, ""};
  const Distribution& from = before.of(Metric::shape);
  const Distribution& to = after.of(Metric::shape);
  verdict.text =
      fmt::format("worst shape {} before, {} after", shown_value(Metric::shape, from.worst),
                  shown_value(Metric::shape, to.worst));
  std::string lower;
  for (const Metric metric : kMetrics) {
    if (before.of(metric).count == 0) continue;
    if (!worse(metric, after.of(metric).worst, before.of(metric).worst)) continue;
    lower += fmt::format("{}{}", lower.empty() ? "" : ", ", name(metric));
  }
  if (!lower.empty()) verdict.text += "; worse in " + lower;
  if (!judged) {
    verdict.pass.reset();
    verdict.text += "; it was allowed to be";
  } else if (before.inverted > 0 && !lower.empty()) {
    verdict.pass.reset();
    verdict.text += "; not judged, as cells were inverted";
  } else {
    verdict.pass = lower.empty();
  }
  return verdict;
}

void add_run(const RunRecord& record, const RunFacts& facts, ReportPage& page) {
  const Report& report = record.report;
  const QualitySummary& after = *page.after;
  page.verdicts.push_back(no_inverted_cells(page.before, after));
  page.verdicts.push_back(
      worst_not_lower(page.before, after, facts.same_shape && !facts.allows_worse));
  page.verdicts.push_back(vertices_stayed(record, facts));
  if (!facts.target.empty()) {
    page.verdicts.push_back(
        {"target met", facts.below_target == 0,
         fmt::format("{}: {} below", facts.target, count_of(facts.below_target, "cell", "cells"))});
  }
  if (facts.same_shape && std::isfinite(facts.max_deviation)) {
    page.verdicts.push_back({"shape within the limit", report.deviation <= facts.max_deviation,
                             fmt::format("{:.3g} from the input's, at most {:.3g} allowed",
                                         report.deviation, facts.max_deviation)});
  }
  if (report.unmet > 0) {
    page.verdicts.push_back({"demands met",
                             facts.fails_demand ? std::optional(false) : std::nullopt,
                             count_of(report.unmet, "demand is not", "demands are not")});
  }
  if (record.output.empty()) {
    page.verdicts.push_back({"file written", std::nullopt, "nothing was written"});
  } else {
    page.verdicts.push_back(
        {"groups, numbers and bytes kept", true,
         "the file was read back: same cells in the same order, positions as they should be; all "
         "but coordinates is copied from the input"});
  }

  const auto add = [&page](std::string title, std::string text) {
    page.ledger.push_back({std::move(title), std::move(text)});
  };
  add("may move", fmt::format("{} of {}", with_commas(report.movable),
                              count_of(report.vertices, "vertex", "vertices")));
  for (const ConstraintSummary& c : record.constraints) {
    std::string kind = c.kind;
    std::replace(kind.begin(), kind.end(), '_', ' ');
    add(std::move(kind), fmt::format("{}, {}{}", count_of(c.count, one_of(c.unit), c.unit),
                                     c.text == "default" ? "by default" : c.text,
                                     c.note.empty() ? "" : " (" + c.note + ")"));
  }
  if (report.held > 0) add("stopped early", count_of(report.held, "vertex", "vertices"));
  if (report.pulled_back > 0)
    add("pulled back", count_of(report.pulled_back, "vertex", "vertices"));
  if (report.lifting.cells > 0) {
    add("made better on purpose", count_of(report.lifting.cells, "cell", "cells"));
  }
  if (report.deviation > 0.0) {
    add("deviation of the shape", fmt::format("{:.3g}", report.deviation));
  }
  add("cost", fmt::format("{:.6g} before, {:.6g} after", report.cost_before, report.cost_after));
  if (!report.history.empty()) {
    add("iterations",
        fmt::format("{}, in {:.3g} s", report.history.back().number, report.solve_seconds));
  }
}

void write_page(const HtmlArguments& arguments, const ReportPage& page, const ShownMesh& mesh) {
  const auto most = static_cast<std::size_t>(arguments.most_mb * 1e6);
  const std::string text = html_report(page, mesh, most);
  OutputFile file(arguments.path);
  file.append(text);
  file.close();
  file.commit();
}

}  // namespace evenmesh::app
