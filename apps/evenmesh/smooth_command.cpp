// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/cost_text.h"
#include "apps/evenmesh/exit_code.h"
#include "apps/evenmesh/expression.h"
#include "apps/evenmesh/iterates.h"
#include "apps/evenmesh/outcome.h"
#include "apps/evenmesh/paths.h"
#include "apps/evenmesh/plots.h"
#include "apps/evenmesh/preview.h"
#include "apps/evenmesh/run_reports.h"
#include "apps/evenmesh/target.h"
#include "apps/evenmesh/written.h"
#include "evenmesh/base/error.h"
#include "evenmesh/base/text.h"
#include "evenmesh/constraint/phrases.h"
#include "evenmesh/mesh/curved_cells.h"
#include "evenmesh/mesh/wall_layers.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh::app {
namespace {

SolverKind solver_kind(const std::string& word) {
  if (word == "auto") return SolverKind::automatic;
  if (word == "multigrid") return SolverKind::multigrid;
  if (word == "newton") return SolverKind::newton;
  if (word == "dense") return SolverKind::dense;
  constexpr std::string_view kKnown[] = {"auto", "multigrid", "newton", "dense"};
  throw InvalidOption(
      fmt::format("there is no solver '{}'{}; known are auto, multigrid, newton and "
                  "dense",
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
    options_.eta = arguments.eta;
    options_.max_iterations = arguments.iterations;
    options_.time_limit_seconds = arguments.time_limit;
    options_.threads = arguments.threads;
    options_.solver = solver_kind(arguments.solver);
    options_.method = method_of(arguments.method);
    if (options_.eta > 0.0 && options_.solver != SolverKind::dense) {
      throw InvalidOption("--eta is where --solver dense stops; give both, or --tolerance");
    }
    if (is_classic() && options_.solver != SolverKind::automatic) {
      throw InvalidOption(fmt::format(
          "--solver {} is how lagrange_newton finds the minimum; --method {} has no use for it",
          arguments.solver, arguments.method));
    }
    if (arguments.allow_worse) options_.judge = Judge::inversion;
    target_ = parse_target(arguments.target);
    if (target_) options_.lift_below = *target_;
    check_words();
    check_report_paths(arguments, output_);
  }

  int perform() {
    try {
      prepare();
      if (arguments_.dry_run) {
        print(dry_run_text(arguments_, record_.constraints, problem_));
        console_.say("dry run: nothing was written");
        return kDone;
      }
      solve();
      finish();
      plot();
    } catch (const std::exception& error) {
      record_.status = "failed";
      record_.message = error.what();
      record_.exit_code = dynamic_cast<const InvalidOption*>(&error) != nullptr ? kBadUsage
                          : dynamic_cast<const Error*>(&error) != nullptr       ? kBadFile
                                                                                : kInternalError;
      console_.end_progress();
      try {
        report();
      } catch (const std::exception&) {
        // That the report cannot be written either is not what went wrong first.
      }
      throw;
    }
    report();
    return record_.exit_code;
  }

 private:
  bool is_classic() const { return options_.method != Method::lagrange_newton; }

  void check_words() const {
    if (arguments_.wall_layers != "hold" && arguments_.wall_layers != "smooth") {
      throw InvalidOption(fmt::format("--wall-layers '{}': known are hold and smooth",
                                      shown(arguments_.wall_layers)));
    }
    if (target_ && (is_classic() || options_.solver == SolverKind::dense)) {
      throw InvalidOption(
          "--target needs --method lagrange_newton with a --solver other than dense");
    }
    if (arguments_.only_failing && !target_) {
      throw InvalidOption(
          "--only-failing needs a --target that says which cells fail, as in shape>=0.3");
    }
    if (arguments_.layers < 0) {
      throw InvalidOption(fmt::format("--layers must not be negative, not {}", arguments_.layers));
    }
  }

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
    loaded_ = true;
    // Whether it can be written is found out before the work, not after it. Leaves nothing behind.
    if (!arguments_.dry_run) {
      check_output(input_.file, output_);
      check_plot_folder(arguments_.plot,
                        {arguments_.input.path, output_, arguments_.json, arguments_.html.path});
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
    if (is_classic() && !arguments_.costs.empty()) {
      console_.say(fmt::format("--method {} does not minimise --cost; the report says what it is",
                               arguments_.method));
    }
    for (const auto& [key, value] : chosen_options(arguments_, problem_)) {
      record_.options.emplace_back(key, plain(value));
    }
  }

  void constrain() {
    const MeshFile& file = input_.file;
    const ConstraintSetting setting{
        .mesh = file.mesh,
        .orientation = input_.orientation,
        .topology = input_.topology,
        .names = {.first_id = file.patch->first_vertex_number(),
                  .ids = file.patch->vertex_numbers(),
                  .groups = file.group_names,
                  .sets = file.sets,
                  .arrays = file.arrays,
                  .followers = &file.followers},
        .held = held(),
        .layers = wall_layers(),
        .vertex_name = [&file](Index v) { return file.patch->vertex_name(v); },
        .read_mesh = [](const std::string& path) { return read_mesh(path).mesh; },
        .read_text = read_text,
        .displacement = displacement};
    problem_.orientation = input_.orientation;
    record_.constraints =
        apply(file.mesh, input_.topology, understand(arguments_.constraints, setting), problem_);
    if (arguments_.only_failing) fix_far_from_failing();
  }

  // Smoothing would make them as thick as they are wide.
  Selection wall_layers() const {
    const Mesh& mesh = input_.file.mesh;
    if (arguments_.wall_layers != "hold") return {};
    const std::vector<char> layer = find_wall_layers(mesh, input_.orientation);
    const auto cells = static_cast<std::size_t>(std::count(layer.begin(), layer.end(), 1));
    if (cells == 0) return {};
    Selection selection{.text = fmt::format("wall layers, {}", count_of(cells, "cell", "cells")),
                        .vertices = std::vector<char>(mesh.point_count(), 0)};
    for (std::size_t c = 0; c < layer.size(); ++c) {
      if (layer[c] == 0) continue;
      for (const Index v : mesh.cells().vertices(c)) selection.vertices[v] = 1;
    }
    const bool holds = arguments_.constraints.fix == "auto";
    console_.say(
        fmt::format("found {}{}", selection.text,
                    holds ? "; they stay as they are (--wall-layers smooth lets them move)" : ""));
    return selection;
  }

  void fix_far_from_failing() {
    const Mesh& mesh = input_.file.mesh;
    const std::vector<std::size_t> failing =
        cells_below(*target_, mesh, mesh.points(), input_.orientation, arguments_.threads);
    const std::vector<char> far = vertices_far_from(failing, mesh, arguments_.layers);
    std::size_t fixed = 0;
    for (Index v = 0; v < far.size(); ++v) {
      if (!far[v] || problem_.motion.freedom(v) == Motion::Freedom::fixed) continue;
      problem_.motion.fix(v);
      ++fixed;
    }
    record_.constraints.push_back(
        {"fixed", "--only-failing", Entry::eliminated, fixed, "vertices",
         fmt::format("farther than {} from {} below the target",
                     count_of(static_cast<std::size_t>(arguments_.layers), "layer", "layers"),
                     count_of(failing.size(), "cell", "cells"))});
  }

  Selection held() const {
    const HeldVertices& held = input_.file.held;
    if (held.vertices.empty()) return {};
    Selection selection{.text = held.why,
                        .vertices = std::vector<char>(input_.file.mesh.point_count(), 0)};
    for (const Index v : held.vertices) selection.vertices[v] = 1;
    // An edge may not take its middle along.
    const Followers& followers = input_.file.followers;
    for (std::size_t i = 0; i < followers.size(); ++i) {
      if (!selection.vertices[followers.vertex(i)]) continue;
      for (const Index v : followers.leaders(i)) selection.vertices[v] = 1;
    }
    return selection;
  }

  // Who did not ask for it should know how far the surface may be left.
  void note_deviation() const {
    for (const ConstraintSummary& line : record_.constraints) {
      if (line.kind != "max_deviation" || line.text != "default") continue;
      console_.say(fmt::format("--max-deviation, by default: {}", line.note));
    }
  }

  // A string of TOML without its quotation marks.
  static std::string plain(const std::string& value) {
    return value.size() > 1 && value.front() == '"' ? value.substr(1, value.size() - 2) : value;
  }

  void solve() {
    result_ = input_.file.mesh;
    options_.representable = [this](Points points) { return input_.file.representable(points); };
    const CurvedCells curved(input_.file.mesh, input_.file.followers, input_.orientation);
    if (curved.size() > 0) {
      options_.spoilt = [this, &curved](Points points) {
        std::vector<Index> vertices;
        for (const std::size_t cell : curved.spoilt(points)) {
          const auto corners = input_.file.mesh.cells().vertices(cell);
          vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
        return vertices;
      };
    }
    options_.progress = [this](const Iteration& iteration) {
      console_.progress(iteration, arguments_.tolerance);
      return !interrupted_();
    };
    options_.interrupted = interrupted_;
    keep_iterates();
    try {
      record_.report = smooth(result_, problem_, options_);
    } catch (const InvalidOption& error) {  // the options are right, so it is about the mesh
      throw InvalidOption(fmt::format("{}: {}", arguments_.input.path, error.what()));
    }
    solved_ = true;
    if (record_.report.milder_cost) iterates_ = Iterates();  // they are of the way not taken
    if (!record_.report.history.empty()) iterates_.end_at(record_.report.history.back().number);
    console_.end_progress();
    if (!std::isfinite(record_.report.cost_before)) {
      throw InvalidOption(
          fmt::format("the cost of {} as it is exceeds double precision; choose smaller weights in "
                      "--cost or a smaller --global-length",
                      arguments_.input.path));
    }
    if (console_.verbose()) print_history();
  }

  // Of large meshes they would take more memory than the mesh and not fit into the report.
  void keep_iterates() {
    constexpr std::size_t kMostNumbers = 4'000'000;
    if (arguments_.keep_iterates == 0 || arguments_.html.path.empty()) return;
    const auto count = static_cast<std::size_t>(arguments_.keep_iterates);
    if (count * input_.file.mesh.point_count() > kMostNumbers) {
      record_.notes.push_back(
          fmt::format("Iterates were not kept: {} of {} are more than a report can hold.", count,
                      count_of(input_.file.mesh.point_count(), "vertex", "vertices")));
      console_.say("note: " + record_.notes.back());
      return;
    }
    iterates_ = Iterates(count);
    options_.watch = [this](const Iteration& iteration, Points points) {
      iterates_.add(iteration.number, points);
    };
  }

  void finish() {
    const Report& report = record_.report;
    record_.message = outcome({arguments_, input_, problem_, record_.report});
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
    const std::string missed = missed_target();
    if (!missed.empty()) record_.message += "; " + missed;
    if (!missed.empty() || fails_a_demand(arguments_.constraints, report.holding)) {
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

  // Which cells do not reach the target, or nothing.
  std::string missed_target() const {
    if (!target_) return "";
    const std::vector<std::size_t> below =
        cells_below(*target_, result_, result_.points(), input_.orientation, arguments_.threads);
    if (below.empty()) return "";
    return fmt::format("{} below the target {}, the first: {}",
                       below.size() == 1 ? "1 cell is" : with_commas(below.size()) + " cells are",
                       arguments_.target, input_.file.patch->cell_name(below[0]));
  }

  void refuse() {
    record_.status = "refused";
    record_.exit_code = kRefused;
    console_.complain(fmt::format("refused: {}: {}; nothing was written", arguments_.input.path,
                                  record_.message));
  }

  // The promise is judged once more on what can be read from the new file.
  void write() {
    const Timer timer;
    const MeshFile& file = input_.file;
    write_mesh(file, result_.points(), output_, {.weld_tolerance = arguments_.input.weld_tolerance},
               [this](const Mesh& written) {
                 check_written(input_, problem_, written, arguments_.allow_worse,
                               arguments_.threads);
               });
    record_.write_seconds = timer.seconds();
    record_.output = output_;
  }

  // A result that was not written is not shown.
  void plot() const {
    if (arguments_.plot.empty()) return;
    write_plots(arguments_.plot, {.title = std::filesystem::path(record_.input).filename().string(),
                                  .before = input_.file.mesh,
                                  .after = record_.output.empty() ? nullptr : &result_,
                                  .orientation = input_.orientation,
                                  .report = record_.report,
                                  .threads = arguments_.threads});
    console_.say("wrote pictures into " + arguments_.plot);
  }

  void print_history() const {
    // Costs compare only where the function is the same.
    console_.detail(
        "iteration function        cost   gradient      step  max move  limited inverted");
    for (const Iteration& i : record_.report.history) {
      console_.detail(fmt::format("{:>9} {:>8} {:>11.5g} {:>10.2e} {:>9.3g} {:>9.2e} {:>8} {:>8}",
                                  i.number, i.function, i.cost, i.gradient, i.step, i.max_move,
                                  i.limited, i.inverted));
    }
  }

  void report() {
    record_.total_seconds = total_.seconds();
    record_.cpu_seconds = cpu_seconds();
    record_.peak_memory_bytes = peak_memory_bytes();
    write_reports({.arguments = arguments_,
                   .input = loaded_ ? &input_ : nullptr,
                   .problem = problem_,
                   .result = solved_ ? &result_ : nullptr,
                   .target = target_,
                   .iterates = iterates_.kept()},
                  record_, console_);
  }

  const SmoothArguments& arguments_;
  Console& console_;
  const std::function<bool()>& interrupted_;
  const std::string output_;
  Options options_;
  std::optional<double> target_;  // of every cell's shape
  const Timer total_;
  RunRecord record_;
  Input input_;
  Problem problem_;
  Mesh result_;
  Iterates iterates_;
  bool loaded_ = false;
  bool solved_ = false;
};

}  // namespace

int smooth_command(const SmoothArguments& arguments, Console& console,
                   const std::function<bool()>& interrupted) {
  return Run(arguments, console, interrupted).perform();
}

}  // namespace evenmesh::app
