// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <unistd.h>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/exit_code.h"
#include "apps/evenmesh/expression.h"
#include "apps/evenmesh/holders.h"
#include "evenmesh/base/error.h"
#include "evenmesh/base/text.h"
#include "evenmesh/constraint/phrases.h"
#include "evenmesh/io/output_file.h"
#include "evenmesh/solver/guard.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh::app {
namespace {

constexpr std::size_t kWorstListed = 10;
constexpr std::size_t kInvertedListed = 1000;

// Thrown while writing to keep the output from replacing anything.
class Refused : public Error {
 public:
  using Error::Error;
};

// Whether anything was demanded that may turn out not to be met.
bool makes_demands(const ConstraintText& text) {
  return !(text.max_move.empty() && text.limit.empty() && text.min_area.empty() &&
           text.min_volume.empty() && text.min_jacobian.empty() && text.keep.empty());
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;  // one that is not there is not the other
  return a == b || std::filesystem::equivalent(a, b, ignored);
}

// Where the report goes must not be where a mesh is, and must be writable: better said before the
// work than after it.
void check_report_path(const std::string& json, const std::string& input,
                       const std::string& output) {
  if (json.empty() || json == "-") return;
  if (same_file(json, input) || same_file(json, output)) {
    throw InvalidOption(
        fmt::format("--json {} would overwrite the mesh; give it another name", json));
  }
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::path(json).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
    throw IoError(json + ": cannot be written; the folder is not there");
  }
  if (std::filesystem::is_directory(json, ignored)) {
    throw IoError(json + ": is a folder; give the name of a file in it");
  }
  std::filesystem::path target = json;
  if (!std::filesystem::exists(target, ignored)) target = folder.empty() ? "." : folder;
  if (::access(target.c_str(), W_OK) != 0) {
    throw IoError(fmt::format("{}: cannot be written: {}", json, std::strerror(errno)));
  }
}

std::string output_path(const SmoothArguments& arguments) {
  if (arguments.dry_run && !arguments.json.empty()) {
    throw InvalidOption("--dry-run writes nothing; leave --json out");
  }
  if (arguments.in_place) {
    if (!arguments.output.empty()) {
      throw InvalidOption("-o and --in-place exclude each other; choose one");
    }
    return arguments.input.path;
  }
  if (arguments.output.empty() && arguments.dry_run) return "";
  if (arguments.output.empty()) {
    throw InvalidOption(
        fmt::format("nowhere to write to; add -o OUT (or look first: evenmesh check {})",
                    arguments.input.path));
  }
  if (same_file(arguments.input.path, arguments.output)) {
    throw InvalidOption(fmt::format(
        "{} is the input itself; use --in-place instead of -o to replace it", arguments.output));
  }
  return arguments.output;
}

std::string cost_text(const Problem& problem) {
  std::string text;
  for (const Term& term : problem.terms) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", term.cost->name(), term.weight);
  }
  return text;
}

SolverKind solver_kind(const std::string& word) {
  if (word == "auto") return SolverKind::automatic;
  if (word == "multigrid") return SolverKind::multigrid;
  if (word == "newton") return SolverKind::newton;
  constexpr std::string_view kKnown[] = {"auto", "multigrid", "newton"};
  throw InvalidOption(fmt::format("there is no solver '{}'{}; known are auto, multigrid, newton",
                                  shown(word), suggestion(word, kKnown)));
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw IoError(path + ": cannot be read");
  return text;
}

// One parser for all vertices; a std::function must be copyable.
std::function<Vec3(const Vec3&)> displacement(const std::string& formulas) {
  const auto parsed = std::make_shared<const Displacement>(formulas);
  return [parsed](const Vec3& p) { return (*parsed)(p); };
}

void check_formulas(const std::vector<std::string>& phrases) {
  for (const std::string& text : phrases) {
    const std::string formulas = parse_prescribe(text).formulas;
    if (formulas.empty()) continue;
    try {
      Displacement{formulas};
    } catch (const InvalidOption& error) {
      throw InvalidOption(fmt::format("--prescribe '{}': {}", shown(text), error.what()));
    }
  }
}

// How many vertices may do what.
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

// One smoothing run from file to file; the steps of the command in their order.
class Run {
 public:
  Run(const SmoothArguments& arguments, Console& console, const std::function<bool()>& interrupted)
      : arguments_(arguments),
        console_(console),
        interrupted_(interrupted),
        output_(output_path(arguments)) {
    record_.command = arguments.command;
    record_.input = arguments.input.path;
    options_.tolerance = arguments.tolerance;
    options_.max_iterations = arguments.iterations;
    options_.time_limit_seconds = arguments.time_limit;
    options_.threads = arguments.threads;
    options_.solver = solver_kind(arguments.solver);
    options_.allow_worse = arguments.allow_worse;
    check_report_path(arguments.json, arguments.input.path, output_);
  }

  int perform() {
    try {
      prepare();
      if (arguments_.dry_run) {
        show();
        return kDone;
      }
      solve();
      finish();
    } catch (const std::exception& error) {
      record_.status = "failed";
      record_.message = error.what();
      record_.exit_code = dynamic_cast<const InvalidOption*>(&error) != nullptr ? kBadUsage
                          : dynamic_cast<const Error*>(&error) != nullptr       ? kBadFile
                                                                                : kInternalError;
      console_.end_progress();
      try {
        write_json();
      } catch (const std::exception&) {
        // That the report cannot be written either is not what went wrong first.
      }
      throw;
    }
    write_json();
    return record_.exit_code;
  }

 private:
  void prepare() {
    check(options_);
    check(arguments_.constraints);
    check_formulas(arguments_.constraints.prescribe);
    const std::vector<CostChoice> costs = parse_costs(arguments_.costs);
    if (!(arguments_.global_length >= 0.0) || std::isinf(arguments_.global_length)) {
      throw InvalidOption(fmt::format("--global-length must be a positive length, not {}",
                                      arguments_.global_length));
    }
    input_ = load(arguments_.input, console_);
    // Whether it can be written is found out before the work, not after it. Leaves nothing behind.
    if (!arguments_.dry_run) {
      const OutputFile probe{output_};
    }
    describe(input_, record_);
    constrain();
    add_costs(input_.file.mesh,
              {.costs = costs,
               .scaling = arguments_.scale_free ? Scaling::scale_free : Scaling::absolute,
               .global_length = arguments_.global_length},
              problem_);
    console_.say(fmt::format("{} mesh; {}", name(input_.orientation.type),
                             freedoms(problem_.motion, input_.orientation.type)));
    for (const ConstraintSummary& line : record_.constraints) console_.detail(in_one_line(line));
    note_deviation();
    for (const auto& [key, value] : effective()) record_.options.emplace_back(key, plain(value));
  }

  void constrain() {
    const MeshFile& file = input_.file;
    const ConstraintSetting setting{
        .mesh = file.mesh,
        .orientation = input_.orientation,
        .topology = input_.topology,
        .names = {.groups = file.group_names},
        .topology_options = {.feature_angle = arguments_.input.feature_angle},
        .vertex_name = [&file](Index v) { return file.patch->vertex_name(v); },
        .read_mesh = [](const std::string& path) { return read_mesh(path).mesh; },
        .read_text = read_text,
        .displacement = displacement};
    problem_.orientation = input_.orientation;
    record_.constraints =
        apply(file.mesh, input_.topology, understand(arguments_.constraints, setting), problem_);
  }

  // Who did not ask for it should know how far the surface may be left.
  void note_deviation() const {
    for (const ConstraintSummary& line : record_.constraints) {
      if (line.kind != "max_deviation" || line.text != "default") continue;
      console_.say(
          fmt::format("no vertex leaves the input's surface by more than {:.4g} "
                      "(--max-deviation)",
                      problem_.max_deviation));
    }
  }

  static std::string in_one_line(const ConstraintSummary& line) {
    return fmt::format("{:<18} {:<10} {:>12} {:<8} {}{}", line.kind, name(line.entry),
                       with_commas(line.count), line.unit, line.text,
                       line.note.empty() ? "" : fmt::format(" ({})", line.note));
  }

  // The options with what was chosen where they left it open, but for what does not matter here.
  std::vector<std::pair<std::string, std::string>> effective() const {
    std::vector<std::pair<std::string, std::string>> result;
    for (const auto& [key, value] : arguments_.effective) {
      if (key == "quiet" || key == "verbose" || key == "json" || key == "cost") continue;
      result.emplace_back(key, value);
    }
    if (!problem_.terms.empty()) result.emplace_back("cost", '"' + cost_text(problem_) + '"');
    return result;
  }

  // A string of TOML without its quotation marks.
  static std::string plain(const std::string& value) {
    return value.size() > 1 && value.front() == '"' ? value.substr(1, value.size() - 2) : value;
  }

  // A configuration file that repeats the run, with what holds in its comments.
  void show() const {
    print(fmt::format("# {}\n#\n", arguments_.command));
    print(fmt::format("# {:<18} {:<10} {:>12} {:<8} {}\n", "constraint", "how", "count", "",
                      "asked for by"));
    for (const ConstraintSummary& line : record_.constraints) {
      print(fmt::format("# {}\n", in_one_line(line)));
    }
    print("\n");
    for (const auto& [key, value] : effective()) print(fmt::format("{} = {}\n", key, value));
    console_.say("dry run: nothing was written");
  }

  void solve() {
    result_ = input_.file.mesh;
    options_.representable = [this](Points points) {
      return input_.file.patch->representable(points);
    };
    options_.progress = [this](const Iteration& iteration) {
      console_.progress(iteration, arguments_.tolerance);
      return !interrupted_();
    };
    try {
      record_.report = smooth(result_, problem_, options_);
    } catch (const InvalidOption& error) {  // the options are right, so it is about the mesh
      throw InvalidOption(fmt::format("{}: {}", arguments_.input.path, error.what()));
    }
    solved_ = true;
    console_.end_progress();
    if (!std::isfinite(record_.report.cost_before)) {
      throw InvalidOption(
          fmt::format("the cost of {} as it is exceeds double precision; choose smaller weights in "
                      "--cost or a smaller --global-length",
                      arguments_.input.path));
    }
    if (console_.verbose()) print_history();
  }

  void finish() {
    const Report& report = record_.report;
    record_.message = outcome();
    record_.status = "ok";
    if (report.stop == Stop::interrupted) {
      record_.status = "interrupted";
      record_.exit_code = kInterrupted;
      if (!arguments_.keep_partial) {
        console_.say(record_.message +
                     "; nothing was written (--keep-partial keeps what there is)");
        return;
      }
      if (report.promise == Promise::unimproved) {
        console_.say("interrupted before anything was better; nothing was written");
        return;
      }
    }
    if (report.promise == Promise::unimproved) {
      refuse();
      return;
    }
    try {
      write();
    } catch (const Refused& error) {
      record_.message = error.what();
      refuse();
      return;
    }
    if (report.unmet > 0 && makes_demands(arguments_.constraints)) {
      record_.exit_code = kBelowTarget;
      console_.complain(record_.message);
    } else {
      console_.say(record_.message);
    }
    if (report.moved > 0) {
      console_.say(fmt::format("moved {}, by {:.4g} at most and {:.4g} on average",
                               count_of(report.moved, "vertex", "vertices"), report.max_move,
                               report.mean_move));
    }
    if (arguments_.json != "-") print(quality_table(report.quality_before, &report.quality_after));
    console_.say("wrote " + output_);
  }

  void refuse() {
    record_.status = "refused";
    record_.exit_code = kRefused;
    console_.complain(fmt::format("refused: {}: {}; nothing was written", arguments_.input.path,
                                  record_.message));
  }

  // The solver's part of outcome().
  std::string how_it_stopped() const {
    const Report& report = record_.report;
    const Iteration& last = report.history.back();
    const std::string count =
        count_of(static_cast<std::size_t>(last.number), "iteration", "iterations");
    if (report.promise == Promise::earlier_iterate) {
      return fmt::format("kept what was reached after {}, since the mean shape falls from there on",
                         count);
    }
    switch (report.stop) {
      case Stop::converged:
        return last.number == 0 ? "the mesh is as even as its cost can make it already"
                                : "converged in " + count;
      case Stop::no_descent:
        return "as low as double precision resolves after " + count;
      case Stop::iteration_limit:
        return fmt::format("stopped at the limit of {}, gradient at {:.1e} of its start", count,
                           last.gradient);
      case Stop::time_limit:
        return fmt::format("stopped at the time limit after {}, gradient at {:.1e} of its start",
                           count, last.gradient);
      case Stop::interrupted:
        return "interrupted after " + count;
      case Stop::nothing_to_move:
        break;
    }
    return "nothing may move";
  }

  // Why the run ended as it did, in one sentence.
  std::string outcome() const {
    const Report& report = record_.report;
    if (input_.file.mesh.cells().empty()) return "the mesh has no cells, so there is nothing to do";
    if (report.stop == Stop::nothing_to_move) {
      return fmt::format(
          "nothing may move: every vertex is fixed (--fix {}) or has no area around it; to see "
          "what "
          "keeps it: evenmesh {} --dry-run",
          arguments_.constraints.fix, arguments_.input.path);
    }
    if (report.promise == Promise::unimproved) {
      return "no vertex can follow the cost without making the worst cell or the mean shape worse; "
             "try other costs (--cost), fewer fixed vertices (--fix), or --allow-worse";
    }
    std::string text = how_it_stopped();
    if (report.held > 0) {
      text +=
          fmt::format("; {} stopped early so that no cell gets too bad{}",
                      count_of(report.held, "vertex", "vertices"),
                      input_.orientation.type == MeshType::surface ? " and none goes too far" : "");
    }
    if (report.pulled_back > 0) {
      text += fmt::format("; {} pulled back so that nothing is worse than before",
                          count_of(report.pulled_back, "vertex", "vertices"));
    }
    if (report.deviation > 0.0) {
      text += fmt::format("; the shape is within {:.3g} of the input's", report.deviation);
    }
    return text + unmet_demands();
  }

  std::string unmet_demands() const {
    const Report& report = record_.report;
    if (report.unmet == 0) return "";
    const FilePatch& patch = *input_.file.patch;
    std::string first;
    for (const ActiveCell& active : report.holding.cells) {
      if (active.excess > 0.0 && first.empty()) {
        first = patch.cell_name(active.cell) + " is too small or inverted" + reason_of(active.cell);
      }
    }
    for (const ActiveBound& active : report.holding.moves) {
      if (active.excess > 0.0 && first.empty()) {
        first = fmt::format("{} is {:.3g} too far from where it was",
                            patch.vertex_name(static_cast<Index>(active.number)), active.excess);
      }
    }
    for (const ActiveBound& active : report.holding.bounds) {
      if (active.excess > 0.0 && first.empty()) {
        first = fmt::format("{} is off by {:.3g}", problem_.bounds[active.number].function->name(),
                            active.excess);
      }
    }
    if (report.unmet == 1) return "; 1 demand is not met: " + first;
    return fmt::format("; {} demands are not met, the first: {}", with_commas(report.unmet), first);
  }

  // Why a cell cannot be had, as far as its own vertices say.
  std::string reason_of(std::size_t cell) const {
    const auto vertices = input_.file.mesh.cells().vertices(cell);
    const auto bound = std::count_if(vertices.begin(), vertices.end(), [&](Index v) {
      const Motion::Freedom freedom = problem_.motion.freedom(v);
      return freedom == Motion::Freedom::fixed || freedom == Motion::Freedom::line;
    });
    if (bound == 0) return "; lower the demand";
    return fmt::format(
        " ({} of its {} vertices are fixed or on a line; is the boundary folded "
        "there?)",
        bound, vertices.size());
  }

  // The promise is judged once more on what can be read from the new file.
  void write() {
    const Timer timer;
    const MeshFile& file = input_.file;
    write_mesh(file, result_.points(), output_, {.weld_tolerance = arguments_.input.weld_tolerance},
               [this](const Mesh& written) { check_written(written); });
    record_.write_seconds = timer.seconds();
    record_.output = output_;
  }

  bool stays(Index v) const {
    if (problem_.motion.freedom(v) != Motion::Freedom::fixed) return false;
    const auto target =
        std::lower_bound(problem_.targets.begin(), problem_.targets.end(), v,
                         [](const Target& t, Index vertex) { return t.vertex < vertex; });
    return target == problem_.targets.end() || target->vertex != v;
  }

  void check_written(const Mesh& written) {
    const Mesh& before = input_.file.mesh;
    for (std::size_t v = 0; v < before.point_count(); ++v) {
      if (!stays(static_cast<Index>(v))) continue;
      // Bit for bit: a zero that loses its sign has changed too.
      if (std::memcmp(&before.points()[v], &written.points()[v], sizeof(Vec3)) == 0) continue;
      throw Refused(fmt::format("{} is fixed but would have moved",
                                input_.file.patch->vertex_name(static_cast<Index>(v))));
    }
    Workers workers(arguments_.threads);
    Guard guard(workers, before, problem_.orientation);
    // Prescribed moves change the shape, and with it what quality can be had.
    const bool same_shape = problem_.targets.empty();
    std::optional<DeviationLimit> limit;
    if (same_shape && std::isfinite(problem_.max_deviation)) {
      limit.emplace(before, problem_.orientation.type, problem_.max_deviation);
      guard.set_limit(&*limit);
    }
    const bool judge_quality = same_shape && !arguments_.allow_worse;
    const std::string breach = guard.find_breach(
        workers, written.points(), judge_quality ? Judge::quality_and_inversion : Judge::inversion);
    if (!breach.empty()) throw Refused("in the file as read back, " + breach);
  }

  void print_history() const {
    console_.detail("iteration        cost   gradient      step  max move  limited");
    for (const Iteration& i : record_.report.history) {
      console_.detail(fmt::format("{:>9} {:>11.5g} {:>10.2e} {:>9.3g} {:>9.2e} {:>8}", i.number,
                                  i.cost, i.gradient, i.step, i.max_move, i.limited));
    }
  }

  void write_json() {
    if (arguments_.json.empty()) return;
    if (solved_) list_worst();
    record_.total_seconds = total_.seconds();
    record_.cpu_seconds = cpu_seconds();
    record_.peak_memory_bytes = peak_memory_bytes();
    const std::string text = to_json(record_);
    if (arguments_.json == "-") {
      print(text);
      return;
    }
    std::ofstream file(arguments_.json, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw IoError(arguments_.json + ": cannot be written; is the folder there?");
  }

  void list_worst() {
    Workers workers(arguments_.threads);
    const Mesh& mesh = input_.file.mesh;
    const CellQuality before = measure_cells(workers, mesh, mesh.points(), input_.orientation);
    const CellQuality after = measure_cells(workers, mesh, result_.points(), input_.orientation);
    std::vector<char> fixed(mesh.point_count());
    for (Index v = 0; v < fixed.size(); ++v) fixed[v] = stays(v);
    for (std::size_t c = 0; c < after.inverted.size(); ++c) {
      if (after.inverted[c] == 0) continue;
      if (record_.still_inverted.size() == kInvertedListed) break;
      record_.still_inverted.push_back(input_.file.patch->cell_name(c));
    }
    const std::vector<std::size_t> worst = worst_cells(after, kWorstListed);
    record_.worst = name_cells(input_, worst, before, after, fixed);
    if (record_.report.holding.of_vertex.empty()) return;
    const Holders holders(problem_, record_.report.holding, *input_.file.patch);
    for (std::size_t i = 0; i < worst.size(); ++i) {
      record_.worst[i].held_by = holders.of_cell(worst[i], mesh.cells().vertices(worst[i]));
    }
    record_.holding = holders.ranked();
  }

  const SmoothArguments& arguments_;
  Console& console_;
  const std::function<bool()>& interrupted_;
  const std::string output_;
  Options options_;
  const Timer total_;
  RunRecord record_;
  Input input_;
  Problem problem_;
  Mesh result_;
  bool solved_ = false;
};

}  // namespace

std::vector<CostChoice> parse_costs(const std::string& text) {
  std::vector<CostChoice> costs;
  std::size_t at = 0;
  while (!text.empty() && at <= text.size()) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    const std::size_t equals = std::min(part.find('='), part.size());
    CostChoice choice{.name = part.substr(0, equals), .weight = 1.0};
    if (equals < part.size()) {
      const char* first = part.data() + equals + 1;
      const char* last = part.data() + part.size();
      const auto [rest, error] = std::from_chars(first, last, choice.weight);
      if (error != std::errc() || rest != last) {
        throw InvalidOption(fmt::format(
            "'{}' is no weight in --cost {}; write for example local=0.3,barycenter=0.3",
            part.substr(equals + 1), text));
      }
    }
    // Beyond that, its product with a cost is soon beyond double precision.
    if (choice.weight > 0.0 && !(choice.weight >= 1e-100 && choice.weight <= 1e100)) {
      throw InvalidOption(fmt::format(
          "the weight {} in --cost {} must lie between 1e-100 and 1e100", choice.weight, text));
    }
    if (choice.name.empty()) {
      throw InvalidOption(fmt::format("a cost without a name in --cost {}", text));
    }
    costs.push_back(std::move(choice));
    at = end + 1;
  }
  return costs;
}

int smooth_command(const SmoothArguments& arguments, Console& console,
                   const std::function<bool()>& interrupted) {
  return Run(arguments, console, interrupted).perform();
}

}  // namespace evenmesh::app
