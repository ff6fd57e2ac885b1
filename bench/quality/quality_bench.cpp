// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "bench/support/case.h"
#include "evenmesh/base/parallel.h"
#include "evenmesh/quality/quality.h"

namespace evenmesh::bench {
namespace {

// Every measure of every cell, on one thread.
void measure(benchmark::State& state, const char* name) {
  const Mesh mesh = make_case_mesh(name, static_cast<std::size_t>(state.range(0)));
  const Orientation orientation = find_orientation(mesh);
  Workers workers(1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(measure_cells(workers, mesh, mesh.points(), orientation));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.cells().size()));
}

void measure_triangles(benchmark::State& state) { measure(state, "triangles"); }
void measure_quads(benchmark::State& state) { measure(state, "quads"); }

// Extremes, percentiles and means of what was measured.
void summarize_triangles(benchmark::State& state) {
  const Mesh mesh = make_case_mesh("triangles", static_cast<std::size_t>(state.range(0)));
  Workers workers(1);
  const CellQuality quality = measure_cells(workers, mesh, mesh.points(), find_orientation(mesh));
  for (auto _ : state) benchmark::DoNotOptimize(summarize(workers, quality));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.cells().size()));
}

#define EVENMESH_SIZES RangeMultiplier(10)->Range(10'000, 1'000'000)->Unit(benchmark::kMillisecond)
BENCHMARK(measure_triangles)->EVENMESH_SIZES;
BENCHMARK(measure_quads)->EVENMESH_SIZES;
BENCHMARK(summarize_triangles)->EVENMESH_SIZES;

}  // namespace
}  // namespace evenmesh::bench
