// SPDX-License-Identifier: MIT
//
// usage: solver_bench CASE VERTICES [THREADS [REPEATS [LEAST fixed|slide]]]
//
// Smooths one mesh of the benchmarks until the gradient has fallen to a millionth and prints one
// JSON object: iterations, seconds, memory. With LEAST no triangle may have less than that part of
// the mean area (none: no limit), and boundary vertices are fixed or slide on the unit circle. Peak
// memory belongs to the process, so tools/bench.py starts it afresh for every case. Times are
// medians over the repeats.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "bench/support/case.h"
#include "bench/support/contest.h"
#include "evenmesh/base/timer.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh::bench {
namespace {

constexpr double kSmall = 1e-6;  // the relative gradient to be reached

// CPU seconds of each part of one run, and when (since smooth() was called) each iterate was there.
struct Run {
  double orientation = 0.0, topology = 0.0, problem = 0.0, smooth = 0.0;
  double wall = 0.0;    // of smooth()
  double beyond = 0.0;  // part of smooth: iterations after the Euclidean gradient was small
  double beyond_wall = 0.0;
  std::vector<double> iterates;
  Report report;

  double total() const { return orientation + topology + problem + smooth - beyond; }
};

double cpu_of(const std::function<void()>& work) {
  const double before = cpu_seconds();
  work();
  return cpu_seconds() - before;
}

// smooth(), stopped as soon as the gradient is small both ways: Euclidean and preconditioned.
void smooth_and_watch(Mesh& mesh, const Problem& problem, int threads, Run& run) {
  const Timer timer;
  const double start = cpu_seconds();
  double small_at = -1.0;
  double small_at_wall = 0.0;
  Options options{.tolerance = 1e-9, .threads = threads};
  options.progress = [&](const Iteration& now) {
    const double used = cpu_seconds() - start;
    run.iterates.push_back(used);
    if (small_at < 0.0 && now.plain_gradient <= kSmall) {
      small_at = used;
      small_at_wall = timer.seconds();
    }
    run.beyond = small_at < 0.0 ? 0.0 : used - small_at;
    run.beyond_wall = small_at < 0.0 ? 0.0 : timer.seconds() - small_at_wall;
    return !(now.plain_gradient <= kSmall && now.gradient <= kSmall);
  };
  run.report = smooth(mesh, problem, options);
  run.smooth = cpu_seconds() - start;
  run.wall = timer.seconds() - run.beyond_wall;
}

// What is demanded besides a small gradient.
struct Demand {
  bool any = false;
  Limits limits;
};

Run run_limited(const Mesh& original, int threads, const Limits& limits) {
  Run run;
  Mesh mesh = original;
  Problem problem;
  run.problem = cpu_of([&] { problem = make_limited_problem(mesh, limits); });
  const Timer timer;
  run.smooth = cpu_of([&] {
    run.report = smooth(mesh, problem,
                        {.tolerance = kSmall,
                         .max_iterations = 500,
                         .threads = threads,
                         .judge = Judge::inversion});
  });
  run.wall = timer.seconds();
  return run;
}

Run run_once(const Mesh& original, int threads, const Demand& demand) {
  if (demand.any) return run_limited(original, threads, demand.limits);
  Run run;
  Mesh mesh = original;
  Orientation orientation;
  std::vector<char> fixed;
  Problem problem;
  run.orientation = cpu_of([&] { orientation = find_orientation(mesh); });
  run.topology = cpu_of([&] { fixed = boundary_of(mesh, orientation); });
  run.problem = cpu_of(
      [&] { problem = make_problem(mesh, std::move(orientation), fixed, case_options(mesh)); });
  smooth_and_watch(mesh, problem, threads, run);
  return run;
}

// Number of the first iterate of which something holds; -1 if there is none.
int first_iterate(const Report& report, const std::function<bool(const Iteration&)>& holds) {
  const auto found = std::find_if(report.history.begin(), report.history.end(), holds);
  return found == report.history.end() ? -1 : found->number;
}

// CPU seconds from the call of smooth() to the first iterate whose cost is within kSameCost of the
// last one's: what an optimiser is asked for in a contest.
double cpu_to_same_cost(const Run& run) {
  const double last = run.report.history.back().cost;
  const int there = first_iterate(
      run.report, [&](const Iteration& now) { return now.cost <= last * (1.0 + kSameCost); });
  const auto i = static_cast<std::size_t>(std::max(there, 0));
  return i < run.iterates.size() ? run.iterates[i] : run.smooth;
}

double median_of(const std::vector<Run>& runs, const std::function<double(const Run&)>& value) {
  std::vector<double> values;
  for (const Run& run : runs) values.push_back(value(run));
  return median(std::move(values));
}

nlohmann::json describe(const std::vector<Run>& runs) {
  const Report& report = runs.front().report;
  const Iteration& last = report.history.back();
  const auto seconds = [&](auto member) {
    return median_of(runs, [&](const Run& run) { return run.*member; });
  };
  return {{"vertices", report.vertices},
          {"moving", report.movable},
          {"cells", report.quality_before.cells},
          {"iterations", first_iterate(report, [](auto& i) { return i.plain_gradient <= kSmall; })},
          {"iterations_preconditioned",
           first_iterate(report, [](auto& i) { return i.gradient <= kSmall; })},
          {"evaluations", last.evaluations},
          {"stop", name(report.stop)},
          {"promise", name(report.promise)},
          {"held", report.held},
          {"pulled_back", report.pulled_back},
          {"inverted_before", report.quality_before.inverted},
          {"inverted_after", report.quality_after.inverted},
          {"shape_mean_before", report.quality_before.of(Metric::shape).mean},
          {"shape_mean_after", report.quality_after.of(Metric::shape).mean},
          {"cost_before", report.cost_before},
          {"cost", last.cost},
          {"multigrid_levels", report.multigrid_levels},
          {"cpu_seconds", median_of(runs, [](const Run& run) { return run.total(); })},
          {"cpu_to_same_cost_seconds", median_of(runs, cpu_to_same_cost)},
          {"wall_seconds", seconds(&Run::wall)},
          {"cpu_of_parts_seconds",
           {{"orientation", seconds(&Run::orientation)},
            {"topology", seconds(&Run::topology)},
            {"problem", seconds(&Run::problem)},
            {"smooth", median_of(runs, [](const Run& run) { return run.smooth - run.beyond; })},
            {"setup", median_of(runs, [](const Run& run) { return run.report.setup_cpu_seconds; })},
            {"beyond", seconds(&Run::beyond)}}},
          {"wall_of_smooth_seconds",
           {{"setup", median_of(runs, [](const Run& run) { return run.report.setup_seconds; })},
            {"solve", median_of(runs, [](const Run& run) { return run.report.solve_seconds; })},
            {"check", median_of(runs, [](const Run& run) { return run.report.check_seconds; })}}}};
}

// Seconds of one evaluation of cost and gradient and of copying 70 bytes per vertex, taken in turn
// so that whatever else disturbs the machine disturbs both.
nlohmann::json measure_evaluation(const Mesh& mesh) {
  constexpr std::size_t kBytesPerVertex = 70;
  constexpr int kRounds = 15;
  const Problem problem = make_case_problem(mesh);
  const Objective objective(mesh, problem);
  Workers workers(1);
  std::vector<Vec3> gradient(mesh.point_count());
  std::vector<char> from(kBytesPerVertex * mesh.point_count(), 1);
  std::vector<char> to(from.size(), 2);

  std::vector<double> evaluations, copies;
  double sum = 0.0;
  for (int i = 0; i < kRounds; ++i) {
    const Timer evaluation;
    sum += objective.evaluate(workers, mesh.points(), gradient);
    evaluations.push_back(evaluation.seconds());
    const Timer copy;
    std::memcpy(to.data(), from.data(), from.size());
    copies.push_back(copy.seconds());
    from[static_cast<std::size_t>(i)] = to[from.size() - 1];  // the copy must not be left out
  }
  return {{"seconds", median(std::move(evaluations))},
          {"copy_70_bytes_per_vertex_seconds", median(std::move(copies))},
          {"value", sum / kRounds}};
}

nlohmann::json measure(const std::string& name, std::size_t vertices, int threads, int repeats,
                       Demand demand) {
  const Mesh mesh = make_case_mesh(name, vertices);
  if (demand.limits.least_area > 0.0) {
    demand.limits.least_area *= mean_area(make_case_mesh(valid_case(name), vertices));
  }
  const std::uint64_t peak_before = peak_memory_bytes();
  std::vector<Run> runs{run_once(mesh, threads, demand)};
  const std::uint64_t peak = peak_memory_bytes();
  for (int i = 1; i < repeats; ++i) runs.push_back(run_once(mesh, threads, demand));

  nlohmann::json result = describe(runs);
  result["case"] = name;
  result["threads"] = threads;
  result["repeats"] = repeats;
  result["peak_memory_bytes"] = peak;
  result["peak_memory_before_bytes"] = peak_before;
  result["bytes_per_vertex"] = static_cast<double>(peak) / static_cast<double>(mesh.point_count());
  if (demand.any) {
    const Report& report = runs.front().report;
    result["iterations"] = report.history.back().number;
    result["iterations_until_valid"] =
        first_iterate(report, [](auto& i) { return i.inverted == 0; });
    result["cost"] = report.cost_after;
    result["solver"] = evenmesh::name(report.solver);
    result["unmet"] = report.unmet;
    return result;
  }
  if (threads == 1 && name != "triangles_shuffled") result["evaluation"] = measure_evaluation(mesh);
  return result;
}

}  // namespace
}  // namespace evenmesh::bench

int main(int argc, char** argv) {
  if (argc < 3 || argc == 6 || argc > 7) {
    std::fputs("usage: solver_bench CASE VERTICES [THREADS [REPEATS [LEAST fixed|slide]]]\n",
               stderr);
    return 2;
  }
  try {
    const int threads = argc > 3 ? std::atoi(argv[3]) : 1;
    const int repeats = argc > 4 ? std::max(1, std::atoi(argv[4])) : 1;
    const auto vertices = static_cast<std::size_t>(std::strtoull(argv[2], nullptr, 10));
    evenmesh::bench::Demand demand;
    if (argc == 7) {
      demand.any = true;
      demand.limits.least_area = std::atof(argv[5]);  // "none" is 0
      demand.limits.slide = std::strcmp(argv[6], "slide") == 0;
    }
    std::puts(evenmesh::bench::measure(argv[1], vertices, threads, repeats, demand).dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "solver_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
