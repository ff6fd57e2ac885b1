// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/base/timer.h"
#include "evenmesh/quality/quality.h"
#include "evenmesh/solver/report.h"

namespace evenmesh::app {

/// Results go to stdout, narration to stderr and only if not quiet.
enum class Verbosity { quiet, normal, verbose };

class Console {
 public:
  explicit Console(Verbosity verbosity) : verbosity_(verbosity) {}

  /// What went wrong: said even to those who want it quiet.
  void complain(std::string_view line) const;
  /// A line of narration.
  void say(std::string_view line) const;
  /// A line of narration for those who asked for more.
  void detail(std::string_view line) const;
  /// Shows where the solver is: one line that is overwritten, and only on a terminal.
  void progress(const Iteration& iteration, double tolerance);
  /// Takes the progress line away.
  void end_progress();

  bool verbose() const { return verbosity_ == Verbosity::verbose; }

 private:
  Verbosity verbosity_;
  bool line_is_open_ = false;
  double last_seconds_ = -1.0;
};

/// Writes text to stdout. Whether it arrived is asked once, at the end: ferror(stdout).
void print(std::string_view text);

/// Worst and mean of every metric that applies, of one mesh or before and after.
std::string quality_table(const QualitySummary& before, const QualitySummary* after);

/// "1,234,567".
std::string with_commas(std::size_t number);
/// "1 vertex", "2 vertices", "3 cells".
std::string count_of(std::size_t number, std::string_view one, std::string_view many);

}  // namespace evenmesh::app
