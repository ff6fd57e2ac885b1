// SPDX-License-Identifier: MIT
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/support/case.h"
#include "evenmesh/base/parallel.h"
#include "evenmesh/solver/objective.h"

namespace evenmesh::bench {
namespace {

enum class Wanted { value, value_and_gradient };

// One evaluation on one thread, as the solver does it: laid out in chunks, projected.
void evaluate(benchmark::State& state, const char* name, std::vector<CostChoice> costs,
              Wanted wanted) {
  const Mesh mesh = make_case_mesh(name, static_cast<std::size_t>(state.range(0)));
  Orientation orientation = find_orientation(mesh);
  const std::vector<char> fixed = boundary_of(mesh, orientation);
  const Problem problem =
      make_problem(mesh, std::move(orientation), fixed, {.costs = std::move(costs)});
  const Objective objective(mesh, problem);
  Workers workers(1);
  std::vector<Vec3> gradient(wanted == Wanted::value ? 0 : mesh.point_count());
  for (auto _ : state) {
    benchmark::DoNotOptimize(objective.evaluate(workers, mesh.points(), gradient));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.cells().size()));
}

void local_value(benchmark::State& state) {
  evaluate(state, "triangles", {{"local", 1.0}}, Wanted::value);
}
void local_gradient(benchmark::State& state) {
  evaluate(state, "triangles", {{"local", 1.0}}, Wanted::value_and_gradient);
}
void global_gradient(benchmark::State& state) {
  evaluate(state, "triangles", {{"global", 1.0}}, Wanted::value_and_gradient);
}
void local_gradient_quads(benchmark::State& state) {
  evaluate(state, "quads", {{"local", 1.0}}, Wanted::value_and_gradient);
}
void barycenter_gradient_quads(benchmark::State& state) {
  evaluate(state, "quads", {{"barycenter", 1.0}}, Wanted::value_and_gradient);
}

#define EVENMESH_SIZES RangeMultiplier(10)->Range(10'000, 1'000'000)->Unit(benchmark::kMillisecond)
BENCHMARK(local_value)->EVENMESH_SIZES;
BENCHMARK(local_gradient)->EVENMESH_SIZES;
BENCHMARK(global_gradient)->EVENMESH_SIZES;
BENCHMARK(local_gradient_quads)->EVENMESH_SIZES;
BENCHMARK(barycenter_gradient_quads)->EVENMESH_SIZES;

}  // namespace
}  // namespace evenmesh::bench
