// SPDX-License-Identifier: MIT
#include "apps/evenmesh/console.h"

#include <cstdio>

#include <fmt/core.h>
#include <unistd.h>

namespace evenmesh::app {
namespace {

// Narration that nobody can receive, because stderr is closed or full, is no reason to stop.
void write_line(std::string_view line) {
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fputc('\n', stderr);
}

// As many digits as help to tell two values apart, in ten columns.
std::string number(Metric metric, double value) {
  if (metric == Metric::min_angle || metric == Metric::max_angle)
    return fmt::format("{:.2f}", value);
  if (value != 0.0 && std::abs(value) < 1e-4) return fmt::format("{:.3e}", value);
  return value >= 1e5 ? fmt::format("{:.4g}", value) : fmt::format("{:.4f}", value);
}

}  // namespace

void Console::complain(std::string_view line) const { write_line(line); }

void Console::say(std::string_view line) const {
  if (verbosity_ != Verbosity::quiet) write_line(line);
}

void Console::detail(std::string_view line) const {
  if (verbosity_ == Verbosity::verbose) write_line(line);
}

void Console::progress(const Iteration& iteration, double tolerance) {
  if (verbosity_ == Verbosity::quiet || isatty(STDERR_FILENO) == 0) return;
  if (line_is_open_ && iteration.seconds - last_seconds_ < 0.1) return;
  last_seconds_ = iteration.seconds;
  line_is_open_ = true;
  // The gradient falls by about the same factor every time, so its logarithm is the way gone.
  const double gone =
      iteration.gradient > 0.0 ? std::log(iteration.gradient) / std::log(tolerance) : 1.0;
  const int filled = static_cast<int>(20.0 * std::min(1.0, std::max(0.0, gone)));
  fmt::print(stderr, "\r[{:<20}] iteration {:<4} gradient {:.1e} of {:.0e}  {:.1f} s ",
             std::string(static_cast<std::size_t>(filled), '#'), iteration.number,
             iteration.gradient, tolerance, iteration.seconds);
  std::fflush(stderr);
}

void Console::end_progress() {
  if (!line_is_open_) return;
  fmt::print(stderr, "\r{:78}\r", "");
  line_is_open_ = false;
}

void print(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

std::string quality_table(const QualitySummary& before, const QualitySummary* after) {
  std::string table;
  const auto row = [&](std::string_view title, const auto& cells) {
    table += fmt::format("{:<18}", title);
    for (const std::string& cell : cells) table += fmt::format("{:>12}", cell);
    table += '\n';
  };
  using Row = std::vector<std::string>;
  if (after != nullptr) row("", Row{"before", "", "after", ""});
  row("", after != nullptr ? Row{"worst", "mean", "worst", "mean"}
                           : Row{"worst", "5 %", "median", "mean"});
  for (const Metric metric : kMetrics) {
    const Distribution& b = before.of(metric);
    if (b.count == 0) continue;
    if (after == nullptr) {
      row(name(metric), Row{number(metric, b.worst), number(metric, b.p5), number(metric, b.median),
                            number(metric, b.mean)});
      continue;
    }
    const Distribution& a = after->of(metric);
    row(name(metric), Row{number(metric, b.worst), number(metric, b.mean), number(metric, a.worst),
                          number(metric, a.mean)});
  }
  row("inverted cells",
      after == nullptr ? Row{with_commas(before.inverted)}
                       : Row{with_commas(before.inverted), "", with_commas(after->inverted), ""});
  return table;
}

std::string with_commas(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, ",");
  return digits;
}

std::string count_of(std::size_t number, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", with_commas(number), number == 1 ? one : many);
}

}  // namespace evenmesh::app
