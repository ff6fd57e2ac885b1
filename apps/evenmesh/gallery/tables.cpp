// SPDX-License-Identifier: MIT
#include "apps/evenmesh/gallery/tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace evenmesh::gallery {
namespace {

// Of what is 0 up to rounding only that much can be said.
std::string cost_text(double cost) {
  return std::abs(cost) < 1e-6 ? "< 1e-6" : fmt::format("{:.5g}", cost);
}

// The power of ten that a number stays below.
std::string bound_text(double value) {
  constexpr double kLeast = 1e-9;
  return fmt::format("< 1e{:+d}",
                     static_cast<int>(std::floor(std::log10(std::max(value, 0.5 * kLeast)))) + 1);
}

std::string words_of(std::string_view key) {
  std::string words(key);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

// Why it ended, and what the promise took.
std::string end_of(const Result& result) {
  std::string end = words_of(name(result.report.stop));
  const Promise promise = result.report.promise;
  if (promise != Promise::kept && promise != Promise::lifted) end += ", " + words_of(name(promise));
  return end;
}

std::vector<std::string> row_of(std::string_view title, std::string iterations, double cost,
                                const QualitySummary& quality, double size, std::string end) {
  const Distribution& shape = quality.of(Metric::shape);
  return {std::string(title),
          std::move(iterations),
          cost_text(cost),
          fmt::format("{:.3f}", shape.worst),
          fmt::format("{:.3f}", shape.mean),
          std::to_string(quality.inverted),
          fmt::format("{:.0f} %", 100.0 * size),
          std::move(end)};
}

std::string figures_text(const Case& of) { return fmt::format("{}", fmt::join(of.figures, ", ")); }

}  // namespace

Table table_of(const Case& of, const std::vector<Result>& results) {
  Table table{{"", "iterations", "f", "worst shape", "mean shape", "inverted", "area", "ended"}};
  if (of.paper_iterations > 0) {
    table.push_back({"in the paper", std::to_string(of.paper_iterations), "", "", "", "", "", ""});
  }
  const Report& first = results.front().report;
  table.push_back(row_of("start", "", first.cost_before, first.quality_before, 1.0, ""));
  for (const Result& result : results) {
    table.push_back(row_of(name(result.way), std::to_string(result.iterations()), result.cost,
                           result.report.quality_after, result.size, end_of(result)));
  }
  return table;
}

Table starts_table(const std::vector<const Case*>& of, const std::vector<Medians>& medians) {
  Table table{{"costs", "eps", "in the paper", "median", "from", "to", "error where it stops",
               "error at the end", "inverted"}};
  for (std::size_t i = 0; i < of.size(); ++i) {
    const Medians& row = medians[i];
    table.push_back({cost_words(of[i]->setup), fmt::format("{:.0e}", of[i]->eps),
                     std::to_string(of[i]->paper_iterations), fmt::format("{:g}", row.median),
                     std::to_string(row.least), std::to_string(row.most),
                     bound_text(row.error_at_stop), bound_text(row.error_at_end),
                     std::to_string(row.inverted)});
  }
  return table;
}

Table list_of_cases() {
  Table table{{"name", "figures", "mesh", "minimised"}};
  for (const Case& each : cases()) {
    const Plate& plate = plate_of(each.start);
    table.push_back({std::string(each.id), figures_text(each),
                     fmt::format("{}{}{}", plate.title, plate.exact ? "" : " (look-alike)",
                                 each.tangled ? ", tangled" : ""),
                     fmt::format("{}{}", cost_words(each.setup),
                                 each.setup.held == Held::nothing ? ", boundary free" : "")});
  }
  return table;
}

std::string as_text(const Table& table) {
  std::vector<std::size_t> widths(table.front().size(), 0);
  for (const auto& row : table) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : table) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      // Words start below their heading, numbers end below it.
      const bool words = i == 0 || i + 1 == row.size() || table.front()[0] == "name";
      line += words ? fmt::format("{:<{}}  ", row[i], widths[i])
                    : fmt::format("{:>{}}  ", row[i], widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string as_markdown(const Table& table) {
  std::string text;
  for (std::size_t r = 0; r < table.size(); ++r) {
    text += fmt::format("| {} |\n", fmt::join(table[r], " | "));
    if (r > 0) continue;
    for (std::size_t i = 0; i < table[r].size(); ++i) {
      text += i == 0 || i + 1 == table[r].size() ? "|---" : "|---:";
    }
    text += "|\n";
  }
  return text;
}

}  // namespace evenmesh::gallery
