// SPDX-License-Identifier: MIT
#include "apps/evenmesh/preview.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/core.h>

#include "apps/evenmesh/console.h"
#include "apps/evenmesh/cost_text.h"

namespace evenmesh::app {

std::string in_one_line(const ConstraintSummary& constraint) {
  return fmt::format("{:<18} {:<10} {:>12} {:<8} {}{}", constraint.kind, name(constraint.entry),
                     with_commas(constraint.count), constraint.unit, constraint.text,
                     constraint.note.empty() ? "" : fmt::format(" ({})", constraint.note));
}

std::string freedoms(const Motion& motion, MeshType type) {
  std::size_t fixed = 0;
  std::size_t slide = 0;
  for (Index v = 0; v < motion.size(); ++v) {
    const bool bound = motion.slot(v) != Motion::kNone || type == MeshType::surface;
    if (motion.freedom(v) == Motion::Freedom::fixed) {
      ++fixed;
    } else if (bound) {
      ++slide;
    }
  }
  const std::size_t free = motion.size() - fixed - slide;
  return fmt::format("of {} {} {} fixed, {} {}, {} {} free",
                     count_of(motion.size(), "vertex", "vertices"), with_commas(fixed),
                     fixed == 1 ? "is" : "are", with_commas(slide), slide == 1 ? "slides" : "slide",
                     with_commas(free), free == 1 ? "is" : "are");
}

std::vector<std::pair<std::string, std::string>> chosen_options(const SmoothArguments& arguments,
                                                                const Problem& problem) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& [key, value] : arguments.effective) {
    constexpr std::string_view kWithoutEffect[] = {
        "quiet", "verbose", "json", "plot", "report", "report-max-mb", "keep-iterates", "cost"};
    if (std::ranges::find(kWithoutEffect, key) != std::end(kWithoutEffect)) continue;
    result.emplace_back(key, value);
  }
  if (!problem.terms.empty()) result.emplace_back("cost", '"' + cost_text(problem) + '"');
  return result;
}

std::string dry_run_text(const SmoothArguments& arguments,
                         const std::vector<ConstraintSummary>& constraints,
                         const Problem& problem) {
  std::string text = fmt::format("# {}\n#\n", arguments.command);
  text += fmt::format("# {:<18} {:<10} {:>12} {:<8} {}\n", "constraint", "how", "count", "",
                      "asked for by");
  for (const ConstraintSummary& constraint : constraints) {
    text += fmt::format("# {}\n", in_one_line(constraint));
  }
  text += '\n';
  for (const auto& [key, value] : chosen_options(arguments, problem)) {
    text += fmt::format("{} = {}\n", key, value);
  }
  return text;
}

}  // namespace evenmesh::app
