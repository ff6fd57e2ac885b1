// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/exit_code.h"

namespace evenmesh::app {
namespace {

std::size_t count(const std::vector<char>& flags) {
  return static_cast<std::size_t>(
      std::count_if(flags.begin(), flags.end(), [](char f) { return f; }));
}

void line(std::string_view title, const std::string& value) {
  print(fmt::format("{:<16}{}\n", title, value));
}

void print_curve(std::string_view title, std::size_t sides, const std::vector<char>& vertices,
                 std::string_view side) {
  line(title, fmt::format("{}, {}", count_of(sides, side, std::string(side) + "s"),
                          count_of(count(vertices), "vertex", "vertices")));
}

void print_groups(const MeshFile& file) {
  const Cells& cells = file.mesh.cells();
  if (!cells.has_groups()) return;
  std::vector<std::size_t> sizes(file.group_names.size(), 0);
  for (std::size_t c = 0; c < cells.size(); ++c) ++sizes[cells.group(c)];
  for (std::size_t g = 0; g < sizes.size(); ++g) {
    if (sizes[g] == 0) continue;
    line("group", fmt::format("{}: {}", g == 0 ? "(none)" : file.group_names[g],
                              count_of(sizes[g], "cell", "cells")));
  }
}

void print_sets(const MeshFile& file) {
  for (const NamedSet& set : file.sets) {
    std::string_view unit = set.unit;
    if (set.members == 1) unit = unit == "vertices" ? "vertex" : unit.substr(0, unit.size() - 1);
    line(set.kind, fmt::format("{}: {} {}", set.name, with_commas(set.members), unit));
  }
  if (!file.held.vertices.empty()) {
    line("held", fmt::format("{}, {}", count_of(file.held.vertices.size(), "vertex", "vertices"),
                             file.held.why));
  }
}

void print_arrays(const MeshFile& file) {
  for (const DataArray& array : file.arrays) {
    double least = std::nan("");
    double most = least;
    for (const double value : array.values()) {  // fmin() and fmax() pass over NaN
      least = std::fmin(least, value);
      most = std::fmax(most, value);
    }
    line("array", fmt::format("{}: {:.6g} to {:.6g} on {}", array.name, least, most,
                              array.on_cells ? "cells" : "vertices"));
  }
}

}  // namespace

int info_command(const InputArguments& arguments, const Console& console) {
  const Input input = load(arguments, console);
  const Mesh& mesh = input.file.mesh;
  const Topology& topology = input.topology;
  const std::string_view side = input.orientation.type == MeshType::volume ? "face" : "edge";

  line("file", arguments.path);
  line("format", std::string(input.file.patch->format()));
  line("bytes", with_commas(input.file.bytes));
  line("type", std::string(name(input.orientation.type)));
  const std::size_t middles = input.file.followers.size();
  line("vertices", fmt::format("{} ({} in no cell)", with_commas(mesh.point_count()),
                               with_commas(mesh.point_count() - count(topology.used) - middles)));
  if (middles > 0) {
    line("second order",
         fmt::format("{} of these are no corners and follow them", with_commas(middles)));
  }
  line("cells", cell_counts(mesh.cells()));
  if (mesh.point_count() > 0) {
    Vec3 low = mesh.points()[0];
    Vec3 high = low;
    for (const Vec3& p : mesh.points()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    line("box", fmt::format("({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g})", low.x(),
                            low.y(), low.z(), high.x(), high.y(), high.z()));
  }
  line("components", with_commas(topology.components));
  line("orientable", input.orientation.orientable ? "yes" : "no");
  line("wound against", count_of(input.orientation.against_majority, "cell", "cells"));
  print_curve("boundary", topology.boundary_sides, topology.boundary, side);
  print_curve("features", topology.feature_sides, topology.features, "edge");
  print_curve("non_manifold", topology.non_manifold_sides, topology.non_manifold, side);
  print_curve("interface", topology.interface_sides, topology.interface, side);
  line("corners", count_of(count(topology.corners), "vertex", "vertices"));
  print_groups(input.file);
  print_sets(input.file);
  print_arrays(input.file);
  return kDone;
}

}  // namespace evenmesh::app
