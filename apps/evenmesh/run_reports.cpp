// SPDX-License-Identifier: MIT
#include "apps/evenmesh/run_reports.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <utility>

#include "apps/evenmesh/holders.h"
#include "apps/evenmesh/outcome.h"
#include "apps/evenmesh/page.h"
#include "apps/evenmesh/target.h"
#include "apps/evenmesh/written.h"
#include "evenmesh/base/error.h"

namespace evenmesh::app {
namespace {

constexpr std::size_t kWorstListed = 10;  // in JSON
constexpr std::size_t kInvertedListed = 1000;

class RunReports {
 public:
  RunReports(const RunState& state, RunRecord& record, const Console& console)
      : state_(state), record_(record), console_(console) {}

  void write() {
    if (state_.input != nullptr) measure();
    if (state_.result != nullptr) list_worst();
    if (!state_.arguments.json.empty()) write_json();
    if (!state_.arguments.html.path.empty() && state_.input != nullptr) write_html();
  }

 private:
  void measure() {
    Workers workers(state_.arguments.threads);
    const Mesh& mesh = state_.input->file.mesh;
    const Orientation& orientation = state_.input->orientation;
    before_ = measure_cells(workers, mesh, mesh.points(), orientation);
    if (state_.result == nullptr) return;
    after_ = measure_cells(workers, mesh, state_.result->points(), orientation);
  }

  // With what holds them.
  void list_worst() {
    const Input& input = *state_.input;
    const Cells& cells = input.file.mesh.cells();
    const Holders holders(state_.problem, record_.report.holding, *input.file.patch);
    const std::vector<std::size_t> worst = worst_cells(after_, kWorstInPage);
    const std::vector<NamedCell> named =
        name_cells(input, worst, before_, after_, staying_vertices(state_.problem));
    for (std::size_t i = 0; i < worst.size(); ++i) {
      worst_.push_back({named[i], worst[i]});
      worst_[i].cell.held_by = holders.of_cell(worst[i], cells.vertices(worst[i]));
      if (i < kWorstListed) record_.worst.push_back(worst_[i].cell);
    }
    for (std::size_t c = 0; c < after_.inverted.size(); ++c) {
      if (after_.inverted[c] == 0) continue;
      if (record_.still_inverted.size() == kInvertedListed) break;
      record_.still_inverted.push_back(
          {input.file.patch->cell_name(c), holders.of_cell(c, cells.vertices(c))});
    }
    record_.holding = holders.ranked();
  }

  void write_json() const {
    const std::string& path = state_.arguments.json;
    const std::string text = to_json(record_);
    if (path == "-") {
      print(text);
      return;
    }
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw IoError(path + ": cannot be written; is the folder there?");
  }

  // Of a run that failed, what there was by then.
  void write_html() {
    const Input& input = *state_.input;
    Workers workers(state_.arguments.threads);
    ShownMesh shown = shown_mesh(input, before_);
    const Motion& motion = state_.problem.motion;
    if (motion.size() > 0) shown.hold = holds_of(motion, input.orientation.type);
    ReportPage page = page_of(input, summarize(workers, before_));
    page.status = record_.status;
    page.message = record_.message;
    page.command = record_.command;
    page.notes = record_.notes;
    page.run = &record_;
    if (state_.result != nullptr) {
      shown.after = state_.result->points();
      shown.quality_after = &after_;
      shown.iterates = state_.iterates;
      page.after = summarize(workers, after_);
      page.worst = worst_;
    } else {
      app::list_worst(input, shown, page);
    }
    add_changes(shown, page);
    if (state_.result != nullptr) add_run(record_, facts(), page);
    if (record_.output.empty() && record_.report.moved > 0) {
      page.notes.emplace_back("\"After\" is what the run came to; it was not written.");
    }
    write_page(state_.arguments.html, page, shown);
    console_.say("wrote " + state_.arguments.html.path);
  }

  RunFacts facts() const {
    const SmoothArguments& arguments = state_.arguments;
    const Problem& problem = state_.problem;
    RunFacts facts{.target = arguments.target,
                   .max_deviation = problem.max_deviation,
                   .fails_demand = fails_a_demand(arguments.constraints, record_.report.holding),
                   .same_shape = problem.targets.empty(),
                   .allows_worse = arguments.allow_worse};
    const Points before = state_.input->file.mesh.points();
    const Points after = state_.result->points();
    const std::vector<char> stays = staying_vertices(problem, *state_.input);
    for (std::size_t v = 0; v < before.size(); ++v) {
      if (!stays[v]) continue;
      ++facts.fixed;
      facts.fixed_moved += std::memcmp(&before[v], &after[v], sizeof(Vec3)) != 0;
    }
    if (state_.target) {
      facts.below_target = cells_below(*state_.target, *state_.result, after,
                                       state_.input->orientation, arguments.threads)
                               .size();
    }
    return facts;
  }

  const RunState& state_;
  RunRecord& record_;
  const Console& console_;
  CellQuality before_;
  CellQuality after_;
  std::vector<ListedCell> worst_;
};

}  // namespace

void write_reports(const RunState& state, RunRecord& record, const Console& console) {
  if (state.arguments.json.empty() && state.arguments.html.path.empty()) return;
  RunReports(state, record, console).write();
}

}  // namespace evenmesh::app
