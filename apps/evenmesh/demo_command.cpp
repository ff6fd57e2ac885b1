// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/exit_code.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh::app {
namespace {

// A mesh of the paper whose best positions are known, and the same mesh disturbed.
struct Figure {
  std::string name;
  std::string what;
  Mesh disturbed;
  std::vector<Vec3> optimum;
  std::vector<char> fixed;
  int paper_local, paper_global;  // iterations the paper reports
};

Figure square_of_four_triangles() {
  Cells cells;
  for (Index i = 0; i < 4; ++i) {
    cells.add(CellKind::triangle, std::array<Index, 3>{i, (i + 1) % 4, 4});
  }
  const std::vector<Vec3> optimum{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  std::vector<Vec3> start = optimum;
  start[4] += Vec3(0.32, -0.24, 0);
  return {"fig5",
          "a square of four triangles",
          Mesh(start, std::move(cells)),
          optimum,
          {1, 1, 1, 1, 0},
          5,
          4};
}

Figure grid_of_quads(std::string name, int n, int paper_local, int paper_global) {
  Figure figure{std::move(name), fmt::format("{0} x {0} quads", n), {}, {}, {}, paper_local,
                paper_global};
  std::vector<Vec3> start;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const bool fixed = i == 0 || j == 0 || i == n || j == n;
      const Vec3 p(static_cast<double>(i) / n, static_cast<double>(j) / n, 0);
      figure.optimum.push_back(p);
      figure.fixed.push_back(fixed);
      // A disturbance without order, the same every time.
      const Vec3 shift(std::sin(12.9898 * i + 4.1414 * j), std::sin(3.425 * i + 11.135 * j), 0);
      start.push_back(fixed ? p : Vec3(p + 0.3 / n * shift));
    }
  }
  Cells cells;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int a, int b) { return static_cast<Index>((j + b) * (n + 1) + i + a); };
      cells.add(CellKind::quad, std::array<Index, 4>{at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
    }
  }
  figure.disturbed = Mesh(std::move(start), std::move(cells));
  return figure;
}

std::string run(const Figure& figure, const std::string& cost, int paper_iterations) {
  Mesh mesh = figure.disturbed;
  const Problem problem =
      make_problem(mesh, find_orientation(mesh), figure.fixed, {.costs = {{cost, 1.0}}});
  const Report report = smooth(mesh, problem, {.tolerance = 1e-9});
  double error = 0.0;
  for (std::size_t v = 0; v < mesh.point_count(); ++v) {
    error = std::max(error, (mesh.points()[v] - figure.optimum[v]).norm());
  }
  return fmt::format("{:<6} {:<28} {:<8} {:>6} {:>6} {:>11.2e} {:>12.1e} {:>9.4f} -> {:.4f}\n",
                     figure.name, figure.what, cost, paper_iterations, report.history.back().number,
                     report.cost_after, error, report.quality_before.of(Metric::shape).worst,
                     report.quality_after.of(Metric::shape).worst);
}

}  // namespace

int demo_command(const Console& console) {
  console.say(
      "Meshes of Kulovec, Kos and Duhovnik (2011) whose best positions are known. 'paper' counts "
      "the\niterations of its dense method, 'ours' those of conjugate gradients with multigrid.");
  print(fmt::format("{:<6} {:<28} {:<8} {:>6} {:>6} {:>11} {:>12} {:>9}\n", "figure", "mesh",
                    "cost", "paper", "ours", "final cost", "error", "worst shape"));
  for (const Figure& figure : {square_of_four_triangles(), grid_of_quads("fig7", 2, 4, 3),
                               grid_of_quads("fig9", 6, 30, 30)}) {
    print(run(figure, "local", figure.paper_local));
    print(run(figure, "global", figure.paper_global));
  }
  return kDone;
}

}  // namespace evenmesh::app
