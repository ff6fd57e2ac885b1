// SPDX-License-Identifier: MIT
#include "apps/evenmesh/loading.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/curved_cells.h"
#include "evenmesh/quality/metric.h"

namespace evenmesh::app {
namespace {

std::array<std::size_t, kCellKinds> count_kinds(const Cells& cells) {
  std::array<std::size_t, kCellKinds> counts{};
  for (const CellKind kind : cells.kinds()) ++counts[static_cast<std::size_t>(kind)];
  return counts;
}

std::string plural(CellKind kind) {
  if (kind == CellKind::hex) return "hexes";
  return std::string(traits(kind).name) + "s";
}

/// Their edges or faces fold them although their corners do not.
void find_inverted_by_curves(Input& input, const Console& console) {
  const Mesh& mesh = input.file.mesh;
  const CurvedCells curved(mesh, input.file.followers, input.orientation);
  std::string first;
  for (const std::size_t cell : curved.inverted(mesh.points())) {
    std::vector<Vec3> corners;
    for (const Index v : mesh.cells().vertices(cell)) corners.push_back(mesh.points()[v]);
    if (is_inverted(mesh.cells().kind(cell), corners, input.orientation.up(cell),
                    input.orientation.sign(cell))) {
      continue;  // counted as such
    }
    if (input.inverted_by_curves++ == 0) first = input.file.patch->cell_name(cell);
  }
  if (input.inverted_by_curves == 0) return;
  console.say(fmt::format(
      "note: {} of second order {} inverted by the nodes between the corners, {} first; straighten "
      "the edges there in the program that made the mesh",
      count_of(input.inverted_by_curves, "cell", "cells"),
      input.inverted_by_curves == 1 ? "is" : "are", first));
}

}  // namespace

Input load(const InputArguments& arguments, const Console& console) {
  if (!(arguments.weld_tolerance >= 0.0) || std::isinf(arguments.weld_tolerance)) {
    throw InvalidOption(fmt::format("the distance in --weld must be a length of 0 or more, not {}",
                                    arguments.weld_tolerance));
  }
  Input input;
  const Timer timer;
  input.file = read_mesh(arguments.path, {.weld_tolerance = arguments.weld_tolerance});
  input.read_seconds = timer.seconds();
  const Mesh& mesh = input.file.mesh;
  console.say(fmt::format("{}: {}, {}", arguments.path,
                          count_of(mesh.point_count(), "vertex", "vertices"),
                          cell_counts(mesh.cells())));
  for (const std::string& note : input.file.notes) console.say("note: " + note);

  const Followers& followers = input.file.followers;
  if (!followers.empty()) {
    const std::size_t curved = followers.curved(mesh.points());
    console.say(
        fmt::format("note: cells of second order are judged by their corners{}; {} between "
                    "them move along{}",
                    curved == 0 ? "" : ", curved ones also by all their nodes",
                    count_of(followers.size(), "node", "nodes"),
                    curved == 0 ? std::string()
                                : fmt::format(", of which {} off the middle keep{} {} place "
                                              "relative to it",
                                              with_commas(curved), curved == 1 ? "s" : "",
                                              curved == 1 ? "its" : "their")));
  }
  input.orientation = find_orientation(mesh);
  input.topology =
      find_topology(mesh, input.orientation, {.feature_angle = arguments.feature_angle});
  find_inverted_by_curves(input, console);
  if (input.orientation.against_majority > 0) {
    console.say(fmt::format(
        "note: {} wound against the others; the file keeps that, and it does not count as inverted",
        input.orientation.against_majority == 1
            ? "1 cell is"
            : with_commas(input.orientation.against_majority) + " cells are"));
  }
  return input;
}

void describe(const Input& input, RunRecord& record) {
  const Mesh& mesh = input.file.mesh;
  record.format = input.file.patch->format();
  record.input_bytes = input.file.bytes;
  record.vertices = mesh.point_count();
  record.cells = count_kinds(mesh.cells());
  record.type = input.orientation.type;
  record.components = input.topology.components;
  record.cells_against_majority = input.orientation.against_majority;
  record.notes = input.file.notes;
  record.read_seconds = input.read_seconds;
}

std::string cell_counts(const Cells& cells) {
  const auto counts = count_kinds(cells);
  std::string text;
  for (int k = 0; k < kCellKinds; ++k) {
    const std::size_t count = counts[static_cast<std::size_t>(k)];
    if (count == 0) continue;
    const auto kind = static_cast<CellKind>(k);
    if (!text.empty()) text += ", ";
    text += count_of(count, traits(kind).name, plural(kind));
  }
  return text.empty() ? "no cells" : text;
}

std::vector<NamedCell> name_cells(const Input& input, const std::vector<std::size_t>& cells,
                                  const CellQuality& before, const CellQuality& after,
                                  const std::vector<char>& fixed) {
  std::vector<NamedCell> named;
  for (const std::size_t cell : cells) {
    const auto vertices = input.file.mesh.cells().vertices(cell);
    named.push_back({.name = input.file.patch->cell_name(cell),
                     .kind = input.file.mesh.cells().kind(cell),
                     .shape_before = before.of(Metric::shape)[cell],
                     .shape_after = after.of(Metric::shape)[cell],
                     .inverted = after.inverted[cell] != 0,
                     .fixed_vertices = static_cast<std::size_t>(std::count_if(
                         vertices.begin(), vertices.end(), [&](Index v) { return fixed[v]; }))});
  }
  return named;
}

}  // namespace evenmesh::app
