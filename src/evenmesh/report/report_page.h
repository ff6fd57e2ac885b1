// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/quality/quality.h"
#include "evenmesh/report/run_record.h"
#include "evenmesh/report/shown_mesh.h"

namespace evenmesh {

enum class PageKind : std::uint8_t { smooth, compare, check };

/// The word for it in the report.
constexpr std::string_view name(PageKind kind) {
  constexpr std::string_view kNames[] = {"smooth", "compare", "check"};
  return kNames[static_cast<int>(kind)];
}

/// Something that was checked, and what came of it.
struct Verdict {
  std::string name;          // "no inverted cells"
  std::optional<bool> pass;  // nothing: it is said, not judged
  std::string text;          // "12 before, 0 after"
};

/// A line of facts.
struct LedgerLine {
  std::string name;
  std::string value;
};

/// A cell in the list of the worst, and its number in the mesh.
struct ListedCell {
  NamedCell cell;
  std::size_t number = 0;
};

/// Everything that an HTML report says. Texts may hold any bytes.
struct ReportPage {
  std::string title = {};  // the file's name
  PageKind kind = PageKind::smooth;
  std::string status = {};         // a word: "ok", "refused"
  std::string message = {};        // one sentence
  std::string command = {};        // to repeat it
  const RunRecord* run = nullptr;  // of smoothing
  std::vector<Verdict> verdicts = {};
  std::vector<LedgerLine> ledger = {};
  QualitySummary before = {};
  std::optional<QualitySummary> after = {};
  std::vector<ListedCell> worst = {};  // the worst first
  std::vector<std::string> notes = {};
};

}  // namespace evenmesh
