// SPDX-License-Identifier: MIT
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/support/case.h"
#include "evenmesh/base/parallel.h"
#include "evenmesh/solver/multigrid.h"
#include "evenmesh/solver/objective.h"

namespace evenmesh::bench {
namespace {

// All on one thread, on irregular triangles with the boundary fixed.
struct Setting {
  explicit Setting(const benchmark::State& state)
      : mesh(make_case_mesh("triangles", static_cast<std::size_t>(state.range(0)))),
        problem(make_case_problem(mesh)),
        objective(mesh, problem) {}

  Mesh mesh;
  Problem problem;
  Objective objective;
  Workers workers{1};
};

void count_vertices(benchmark::State& state, const Setting& in) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(in.mesh.point_count()));
}

void layout(benchmark::State& state) {
  const Setting in(state);
  for (auto _ : state) benchmark::DoNotOptimize(Objective(in.mesh, in.problem).size());
  count_vertices(state, in);
}

void majoriser(benchmark::State& state) {
  Setting in(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(in.objective.majoriser(in.workers, in.mesh.points()).rows());
  }
  count_vertices(state, in);
}

void multigrid_setup(benchmark::State& state) {
  Setting in(state);
  const SymmetricMatrix matrix = in.objective.majoriser(in.workers, in.mesh.points());
  for (auto _ : state) benchmark::DoNotOptimize(Multigrid(in.workers, matrix).levels());
  count_vertices(state, in);
}

// Applying the preconditioner to a gradient: one V(1,1) cycle.
void multigrid_cycle(benchmark::State& state) {
  Setting in(state);
  Multigrid multigrid(in.workers, in.objective.majoriser(in.workers, in.mesh.points()));
  std::vector<Vec3> gradient(in.mesh.point_count());
  std::vector<Vec3> direction(in.mesh.point_count());
  in.objective.evaluate(in.workers, in.mesh.points(), gradient);
  for (auto _ : state) {
    multigrid.apply(in.workers, gradient, direction);
    benchmark::DoNotOptimize(direction.data());
  }
  count_vertices(state, in);
}

#define EVENMESH_SIZES RangeMultiplier(10)->Range(10'000, 1'000'000)->Unit(benchmark::kMillisecond)
BENCHMARK(layout)->EVENMESH_SIZES;
BENCHMARK(majoriser)->EVENMESH_SIZES;
BENCHMARK(multigrid_setup)->EVENMESH_SIZES;
BENCHMARK(multigrid_cycle)->EVENMESH_SIZES;

}  // namespace
}  // namespace evenmesh::bench
