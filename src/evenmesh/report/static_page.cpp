// SPDX-License-Identifier: MIT
#include "evenmesh/report/static_page.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "evenmesh/plot/convergence.h"
#include "evenmesh/plot/histogram.h"
#include "evenmesh/plot/mesh_picture.h"
#include "evenmesh/plot/metric_range.h"
#include "evenmesh/report/html_text.h"

namespace evenmesh {
namespace {

constexpr std::size_t kWorstListed = 12;    // in print
constexpr std::size_t kMostJson = 200'000;  // bytes of the run's record to be read by people

std::string section(std::string_view id, std::string_view title, const std::string& content) {
  if (content.empty()) return "";
  return fmt::format("<section id=\"static-{}\"><h2>{}</h2>\n{}</section>\n", id, title, content);
}

std::string headline(const ReportPage& page) {
  std::string text = fmt::format("<header><h1>{}</h1>\n", html_escaped(page.title));
  text += fmt::format("<p class=\"status {0}\"><strong>{0}</strong> {1}</p></header>\n",
                      html_escaped(page.status), html_escaped(page.message));
  return text;
}

std::string verdict_list(const ReportPage& page) {
  std::string text;
  for (const Verdict& verdict : page.verdicts) {
    const char* word = !verdict.pass ? "note" : *verdict.pass ? "pass" : "fail";
    text += fmt::format("<li class=\"{0}\"><strong>{0}</strong> {1}: {2}</li>\n", word,
                        html_escaped(verdict.name), html_escaped(verdict.text));
  }
  return text.empty() ? text : "<ul class=\"verdicts\">\n" + text + "</ul>\n";
}

std::string ledger_table(const ReportPage& page) {
  std::string text;
  for (const LedgerLine& line : page.ledger) {
    text += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", html_escaped(line.name),
                        html_escaped(line.value));
  }
  return text.empty() ? text : "<table class=\"ledger\">\n" + text + "</table>\n";
}

std::string quality_columns(const Distribution& d, Metric metric) {
  std::string text;
  for (const double value : {d.worst, d.p1, d.p5, d.median, d.mean}) {
    text += fmt::format("<td>{}</td>", std::isfinite(value) ? shown_value(metric, value) : "∞");
  }
  return text;
}

std::string quality_table(const ReportPage& page) {
  constexpr const char* kHeads =
      "<th scope=\"col\">worst</th><th scope=\"col\">1 %</th><th scope=\"col\">5 %</th>"
      "<th scope=\"col\">median</th><th scope=\"col\">mean</th>";
  std::string text = "<table class=\"quality\">\n<thead>\n";
  if (page.after) {
    text +=
        "<tr><td></td><th colspan=\"5\" scope=\"colgroup\">before</th>"
        "<th colspan=\"5\" scope=\"colgroup\">after</th></tr>\n";
  }
  text +=
      fmt::format("<tr><td></td>{}{}</tr>\n</thead>\n<tbody>\n", kHeads, page.after ? kHeads : "");
  for (const Metric metric : kMetrics) {
    if (page.before.of(metric).count == 0) continue;
    text += fmt::format("<tr><th scope=\"row\">{}</th>{}{}</tr>\n", axis_title(metric),
                        quality_columns(page.before.of(metric), metric),
                        page.after ? quality_columns(page.after->of(metric), metric) : "");
  }
  text += fmt::format("</tbody></table>\n<p>Inverted cells: {}{}</p>\n", page.before.inverted,
                      page.after ? fmt::format(" before, {} after", page.after->inverted) : "");
  return text;
}

std::string worst_table(const ReportPage& page) {
  if (page.worst.empty()) return "";
  std::string text = fmt::format(
      "<table class=\"worst\">\n<thead><tr><th scope=\"col\">cell</th><th scope=\"col\">kind</th>"
      "{}<th scope=\"col\">held by</th></tr></thead>\n<tbody>\n",
      page.after ? "<th scope=\"col\">shape before</th><th scope=\"col\">shape after</th>"
                 : "<th scope=\"col\">shape</th>");
  const std::size_t count = std::min(page.worst.size(), kWorstListed);
  for (const auto& [cell, number] : std::span(page.worst).first(count)) {
    std::string holders;
    for (const std::string& holder : cell.held_by) {
      holders += (holders.empty() ? "" : "<br>") + html_escaped(holder);
    }
    text += fmt::format(
        "<tr><td>{}</td><td>{}{}</td><td>{:.4f}</td>{}<td>{}</td></tr>\n", html_escaped(cell.name),
        traits(cell.kind).name, cell.inverted ? ", inverted" : "", cell.shape_before,
        page.after ? fmt::format("<td>{:.4f}</td>", cell.shape_after) : "", holders);
  }
  return text + "</tbody></table>\n";
}

std::string note_list(const ReportPage& page, const std::vector<std::string>& more) {
  std::string text;
  for (const auto& notes : {page.notes, more}) {
    for (const std::string& note : notes) text += fmt::format("<li>{}</li>\n", html_escaped(note));
  }
  return text.empty() ? text : "<ul>\n" + text + "</ul>\n";
}

std::string run_record(const ReportPage& page) {
  if (page.run == nullptr) return "";
  const std::string json = to_json(*page.run);
  if (json.size() > kMostJson) return "";  // there it is anyway, for programs
  return fmt::format("<details><summary>The run in JSON</summary>\n<pre>{}</pre></details>\n",
                     html_escaped(json));
}

std::string figure(const std::string& picture, std::string_view caption) {
  if (picture.empty()) return "";
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption></figure>\n", picture, caption);
}

// Smaller and smaller until it is small. Pixels of a mesh with far more cells than these take about
// six bytes each: what would be too large is not tried, as drawing takes its time.
std::string mesh_figure(const ShownMesh& mesh, std::size_t most_bytes) {
  constexpr double kWidest = 420.0;
  constexpr double kNarrowest = 100.0;
  constexpr double kBytesPerPixel = 6.0;
  std::vector<Panel> panels{{mesh.has_after() ? "before" : "", mesh.before.points()}};
  if (mesh.has_after()) panels.push_back({"after", mesh.after});
  MeshPictureOptions options{.edge_budget = 4'000, .cell_budget = 8'000};
  double width = kWidest;
  if (mesh.before.cells().size() > 20 * options.cell_budget) {
    const auto pixels = static_cast<double>(most_bytes) / kBytesPerPixel;
    width = std::min(width, std::sqrt(pixels / static_cast<double>(panels.size())));
  }
  for (; width >= kNarrowest; width *= 0.7) {
    options.panel_width = width;
    std::string picture = mesh_picture(mesh.before, mesh.orientation, panels, options);
    if (picture.size() <= most_bytes) return picture;
  }
  return "";
}

}  // namespace

std::string static_page(const ReportPage& page, const std::vector<std::string>& notes,
                        const std::string& pictures) {
  std::string text = headline(page);
  text += section("verdicts", "Checks", verdict_list(page));
  text += section("ledger", "What changed", ledger_table(page));
  text += section("quality", "Quality", quality_table(page));
  text += section("worst", "Worst cells", worst_table(page));
  text += section("pictures", "Pictures", pictures);
  if (!page.command.empty()) {
    text += section("command", "Command",
                    fmt::format("<pre><code>{}</code></pre>\n", html_escaped(page.command)));
  }
  text += section("notes", "Notes", note_list(page, notes));
  return text + run_record(page);
}

std::string report_pictures(const ReportPage& page, const ShownMesh& mesh, std::size_t most_bytes) {
  std::vector<HistogramMesh> states{{mesh.has_after() ? "before" : "cells", mesh.quality_before}};
  if (mesh.has_after()) states.push_back({"after", *mesh.quality_after});
  std::string text = figure(quality_histogram(states), "How many cells have which shape");
  if (page.run != nullptr && page.run->report.history.size() > 1) {
    text += figure(convergence_plot(page.run->report), "Convergence");
  }
  if (!mesh.before.cells().empty()) text += figure(mesh_figure(mesh, most_bytes), "The mesh");
  return text;
}

}  // namespace evenmesh
