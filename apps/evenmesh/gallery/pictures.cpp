// SPDX-License-Identifier: MIT
#include "apps/evenmesh/gallery/pictures.h"

#include <cmath>

#include <fmt/core.h>

#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/plot/convergence.h"
#include "evenmesh/plot/mesh_picture.h"

namespace evenmesh::gallery {
namespace {

// Nobody can tell two meshes apart whose cells are this equal, in a mesh a few units across; free
// ones may have turned as a whole.
bool look_alike(const Mesh& mesh, Points a, Points b) {
  constexpr double kVisible = 0.01;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const auto vertices = mesh.cells().vertices(c);
    for (const Index u : vertices) {
      for (const Index v : vertices) {
        if (std::abs((a[u] - a[v]).norm() - (b[u] - b[v]).norm()) > kVisible) return false;
      }
    }
  }
  return true;
}

// The costs of a run above the least that it comes to. Where constraints change what is minimised,
// each function has a least value of its own.
Curve curve_of(const Result& result) {
  const std::vector<Iteration>& history = result.report.history;
  Curve curve{std::string(name(result.way)), {}, 0};
  for (std::size_t i = 0; i < history.size();) {
    std::vector<double> costs;
    const int function = history[i].function;
    for (; i < history.size() && history[i].function == function; ++i) {
      costs.push_back(history[i].cost);
    }
    const Curve part = above_least("", costs);
    curve.y.insert(curve.y.end(), part.y.begin(), part.y.end());
  }
  return curve;
}

}  // namespace

std::string picture_of(const Case& of, const std::vector<Result>& results) {
  const Mesh mesh = start_mesh(of);
  const Orientation orientation = find_orientation(mesh);
  std::vector<Panel> panels{{"start", mesh.points()}};
  std::vector<std::size_t> inverted{results.front().report.quality_before.inverted};
  for (const Result& result : results) {
    std::size_t alike = 1;
    while (alike < panels.size() && (inverted[alike] != result.inverted() ||
                                     !look_alike(mesh, panels[alike].points, result.points))) {
      ++alike;
    }
    if (alike == panels.size()) {
      panels.push_back({std::string(name(result.way)), result.points});
      inverted.push_back(result.inverted());
    } else {
      panels[alike].title += fmt::format(" = {}", name(result.way));
    }
  }
  if (panels.size() == 2 && results.size() > 2) panels[1].title = "all ways alike";
  MeshPictureOptions options;
  options.title = fmt::format("{}: {}", of.id, of.title);
  options.panel_width = 300.0;
  options.view = Vec3(0.35, -0.9, 1.1);
  options.up = Vec3(0.0, 0.0, 1.0);
  if (of.setup.held != Held::nothing) {
    options.fixed = find_topology(mesh, orientation).boundary;
  }
  return mesh_picture(mesh, orientation, panels, options);
}

std::string convergence_of(const Case& of, const std::vector<Result>& results) {
  std::vector<Curve> curves;
  for (const Result& result : results) curves.push_back(curve_of(result));
  ConvergenceOptions options;
  options.title = fmt::format("{}: {}", of.id, of.title);
  options.y_title = "f above its least value";
  options.width = 560.0;
  options.height = 340.0;
  if (of.paper_iterations > 0) {
    options.marks.push_back(
        {static_cast<double>(of.paper_iterations), fmt::format("paper {}", of.paper_iterations)});
  }
  return convergence_plot(curves, options);
}

}  // namespace evenmesh::gallery
