// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "evenmesh/io/format.h"
#include "evenmesh/io/input_file.h"

namespace evenmesh {
namespace {

/// A grid of n x n quads, each cut in two, on a wavy surface; all digits that a double has.
std::string wavy_grid(int n) {
  std::string text;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double x = static_cast<double>(i) / n;
      const double y = static_cast<double>(j) / n;
      fmt::format_to(std::back_inserter(text), "v {} {} {}\n", x, y, std::sin(6.0 * x) * y);
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 1; j <= n; ++j) {
      const int a = i * (n + 1) + j;
      const int b = a + n + 1;
      fmt::format_to(std::back_inserter(text), "f {0} {1} {2}\nf {0} {2} {3}\n", a, b, b + 1,
                     a + 1);
    }
  }
  return text;
}

void read_obj_text(benchmark::State& state) {
  const std::string text = wavy_grid(static_cast<int>(state.range(0)));
  const auto input = InputFile::borrow(text, "grid.obj");
  for (auto _ : state) benchmark::DoNotOptimize(read_mesh(input));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(read_obj_text)->RangeMultiplier(4)->Range(64, 1024)->Unit(benchmark::kMillisecond);

// Every vertex moves in y, so every line of a vertex gets one new number.
void write_obj_text(benchmark::State& state) {
  const std::string text = wavy_grid(static_cast<int>(state.range(0)));
  const MeshFile file = read_mesh(InputFile::borrow(text, "grid.obj"));
  std::vector<Vec3> points(file.mesh.points().begin(), file.mesh.points().end());
  for (Vec3& point : points) point.y() += 1.0 / 3.0;
  std::size_t bytes = 0;
  for (auto _ : state) {
    file.patch->write(points, [&](std::string_view piece) { bytes += piece.size(); });
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
}
BENCHMARK(write_obj_text)->RangeMultiplier(4)->Range(64, 1024)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace evenmesh
