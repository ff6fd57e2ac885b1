// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "bench/support/case.h"
#include "evenmesh/mesh/ordering.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"

namespace evenmesh::bench {
namespace {

// What is found out about a mesh before it is smoothed: for vertices and cells row by row and in
// random order.

template <typename Work>
void on_case(benchmark::State& state, const char* name, Work work) {
  const Mesh mesh = make_case_mesh(name, static_cast<std::size_t>(state.range(0)));
  const Orientation orientation = find_orientation(mesh);
  for (auto _ : state) work(mesh, orientation);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.cells().size()));
}

void orientation(benchmark::State& state, const char* name) {
  on_case(state, name, [](const Mesh& mesh, const Orientation&) {
    benchmark::DoNotOptimize(find_orientation(mesh).against_majority);
  });
}

void topology(benchmark::State& state, const char* name) {
  on_case(state, name, [](const Mesh& mesh, const Orientation& found) {
    benchmark::DoNotOptimize(find_topology(mesh, found).components);
  });
}

void ordering(benchmark::State& state, const char* name) {
  on_case(state, name, [](const Mesh& mesh, const Orientation&) {
    benchmark::DoNotOptimize(breadth_first_order(mesh).vertices.data());
  });
}

#define EVENMESH_SIZES RangeMultiplier(10)->Range(10'000, 1'000'000)->Unit(benchmark::kMillisecond)
BENCHMARK_CAPTURE(orientation, rows, "triangles")->EVENMESH_SIZES;
BENCHMARK_CAPTURE(orientation, random, "triangles_shuffled")->EVENMESH_SIZES;
BENCHMARK_CAPTURE(topology, rows, "triangles")->EVENMESH_SIZES;
BENCHMARK_CAPTURE(topology, random, "triangles_shuffled")->EVENMESH_SIZES;
BENCHMARK_CAPTURE(ordering, random, "triangles_shuffled")->EVENMESH_SIZES;

}  // namespace
}  // namespace evenmesh::bench
