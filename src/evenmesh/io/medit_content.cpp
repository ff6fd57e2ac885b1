// SPDX-License-Identifier: MIT
#include "evenmesh/io/medit_content.h"

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/core.h>

namespace evenmesh {
namespace {

constexpr std::array kSections{
    MeditSection{"Edges", 5, MeditRole::edges, CellKind::triangle, 2},
    MeditSection{"Triangles", 6, MeditRole::cells, CellKind::triangle, 3},
    MeditSection{"Quadrilaterals", 7, MeditRole::cells, CellKind::quad, 4},
    MeditSection{"Tetrahedra", 8, MeditRole::cells, CellKind::tet, 4},
    MeditSection{"Prisms", 9, MeditRole::cells, CellKind::wedge, 6},
    MeditSection{"Pentahedra", 9, MeditRole::cells, CellKind::wedge, 6},
    MeditSection{"Hexahedra", 10, MeditRole::cells, CellKind::hex, 8},
    MeditSection{"Hexaedra", 10, MeditRole::cells, CellKind::hex, 8},
    MeditSection{"Pyramids", 49, MeditRole::cells, CellKind::pyramid, 5},
    MeditSection{"Corners", 13, MeditRole::vertices},
    MeditSection{"Ridges", 14, MeditRole::edge_list},
    MeditSection{"RequiredVertices", 15, MeditRole::vertices},
    MeditSection{"RequiredEdges", 16, MeditRole::edge_list},
    MeditSection{"RequiredTriangles", 17, MeditRole::cell_list, CellKind::triangle},
    MeditSection{"RequiredQuadrilaterals", 18, MeditRole::cell_list, CellKind::quad},
    MeditSection{"TrianglesP2", 24, MeditRole::too_high},
    MeditSection{"EdgesP2", 25, MeditRole::too_high},
    MeditSection{"QuadrilateralsQ2", 27, MeditRole::too_high},
    MeditSection{"TetrahedraP2", 30, MeditRole::too_high},
    MeditSection{"HexahedraQ2", 33, MeditRole::too_high},
    MeditSection{"PrismsP2", 86, MeditRole::too_high},
    MeditSection{"PyramidsP2", 87, MeditRole::too_high},
};

}  // namespace

const MeditSection* medit_section(std::string_view name) {
  const auto at = std::find_if(kSections.begin(), kSections.end(),
                               [name](const MeditSection& s) { return s.name == name; });
  return at == kSections.end() ? nullptr : &*at;
}

const MeditSection* medit_section(int code) {
  const auto at = std::find_if(kSections.begin(), kSections.end(),
                               [code](const MeditSection& s) { return s.code == code; });
  return at == kSections.end() ? nullptr : &*at;
}

void MeditContent::add_vertex(const Vec3& position, std::int64_t reference) {
  if (reference != 0) {
    vertices_by_reference_[reference].push_back(static_cast<Index>(points_.size()));
  }
  points_.push_back(position);
}

void MeditContent::add_cell(CellKind kind, std::span<const Index> corners, std::int64_t reference) {
  cells_of_[static_cast<std::size_t>(kind)].push_back(cells_.size());
  cells_.add(kind, corners);
  references_.push_back(reference);
}

void MeditContent::add_edge(std::span<const Index> ends, std::int64_t reference) {
  edges_.insert(edges_.end(), ends.begin(), ends.end());
  edge_references_.push_back(reference);
}

void MeditContent::hold_edge(std::size_t edge) {
  held_.push_back(edges_[2 * edge]);
  held_.push_back(edges_[2 * edge + 1]);
}

void MeditContent::hold_cell(CellKind kind, std::size_t number) {
  const auto corners = cells_.vertices(cells_of_[static_cast<std::size_t>(kind)][number]);
  held_.insert(held_.end(), corners.begin(), corners.end());
}

MeshFile MeditContent::take_file() {
  MeshFile file;
  const bool volume = std::any_of(cells_.kinds().begin(), cells_.kinds().end(),
                                  [](CellKind kind) { return traits(kind).dimension == 3; });
  // Surface cells of a volume are its sides, and their references conditions there; edges those of
  // a surface.
  std::map<std::int64_t, std::uint32_t> groups;
  std::map<std::int64_t, std::vector<std::size_t>> sides;
  file.group_names = {""};
  SideLabels labels;
  const auto label = [](std::int64_t reference) {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(reference, 0, 0x7fffffff)) + 1;
  };
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const bool is_side = volume && traits(cells_.kind(cell)).dimension == 2;
    if (is_side) {
      sides[references_[cell]].push_back(cell);
      labels.add(cells_.vertices(cell), label(references_[cell]));
    } else if (references_[cell] != 0) {
      const auto next = static_cast<std::uint32_t>(file.group_names.size());
      const auto [at, is_new] = groups.emplace(references_[cell], next);
      if (is_new) file.group_names.push_back(fmt::format("ref {}", references_[cell]));
      cells_.set_group(cell, at->second);
    }
  }
  for (auto& [reference, members] : sides) {
    const std::size_t count = members.size();
    file.sets.push_back({.kind = "marker",
                         .name = std::to_string(reference),
                         .members = count,
                         .unit = "sides",
                         .vertices = [list = std::make_shared<const std::vector<std::size_t>>(
                                          std::move(members))](const Cells& cells) {
                           std::vector<Index> vertices;
                           for (const std::size_t cell : *list) {
                             const auto corners = cells.vertices(cell);
                             vertices.insert(vertices.end(), corners.begin(), corners.end());
                           }
                           return vertices;
                         }});
  }
  std::map<std::int64_t, std::vector<Index>> edge_vertices;
  for (std::size_t e = 0; e < edges(); ++e) {
    const std::span<const Index> ends(&edges_[2 * e], 2);
    if (!volume) labels.add(ends, label(edge_references_[e]));
    auto& to = edge_vertices[edge_references_[e]];
    to.insert(to.end(), ends.begin(), ends.end());
  }
  const auto add_set = [&file](std::string kind, std::int64_t reference, std::string unit,
                               std::size_t members, std::vector<Index> vertices) {
    file.sets.push_back({.kind = std::move(kind),
                         .name = std::to_string(reference),
                         .members = members,
                         .unit = std::move(unit),
                         .vertices = [list = std::make_shared<const std::vector<Index>>(
                                          std::move(vertices))](const Cells&) { return *list; }});
  };
  for (auto& [reference, vertices] : edge_vertices) {
    if (volume) break;
    const std::size_t count = vertices.size() / 2;
    add_set("marker", reference, "sides", count, std::move(vertices));
  }
  for (auto& [reference, vertices] : vertices_by_reference_) {
    const std::size_t count = vertices.size();
    add_set("nset", reference, "vertices", count, std::move(vertices));
  }
  const std::vector<Index> between = labels.between();
  held_.insert(held_.end(), between.begin(), between.end());
  std::sort(held_.begin(), held_.end());
  held_.erase(std::unique(held_.begin(), held_.end()), held_.end());
  file.held = {std::move(held_), "required by the file, or between two references"};
  if (cells_.empty()) file.notes.push_back("The file has vertices but no cells.");
  file.mesh = Mesh(std::move(points_), std::move(cells_));
  return file;
}

}  // namespace evenmesh
