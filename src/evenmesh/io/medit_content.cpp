// SPDX-License-Identifier: MIT
#include "evenmesh/io/medit_content.h"

#include <algorithm>
#include <array>

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

std::uint32_t label_of(std::int64_t reference) {
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(reference, 0, 0x7fffffff)) + 1;
}

/// One set per reference, of the vertices in its list.
void add_sets(std::string_view kind, std::map<std::int64_t, std::vector<Index>> lists,
              std::vector<NamedSet>& sets) {
  for (auto& [reference, vertices] : lists) {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    sets.push_back(named_list(std::string(kind), std::to_string(reference), vertices.size(),
                              "vertices", std::move(vertices)));
  }
}

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

void MeditContent::reserve_entries(const MeditSection& section, std::size_t count) {
  if (section.role != MeditRole::cells) return;
  cells_.reserve(cells_.size() + count, cells_.corners().size() + count * section.corners);
  cells_of_[static_cast<std::size_t>(section.kind)].reserve(count);
  references_.reserve(references_.size() + count);
}

void MeditContent::add_cell_or_edge(const MeditSection& section, std::int64_t reference) {
  if (section.role == MeditRole::edges) {
    edges_.insert(edges_.end(), corners_.begin(), corners_.end());
    edge_references_.push_back(reference);
    return;
  }
  cells_of_[static_cast<std::size_t>(section.kind)].push_back(cells_.size());
  cells_.add(section.kind, corners_);
  references_.push_back(reference);
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
  file.group_names = {""};
  if (cells_.empty()) file.notes.push_back("The file has vertices but no cells.");
  const bool volume = std::any_of(cells_.kinds().begin(), cells_.kinds().end(),
                                  [](CellKind kind) { return traits(kind).dimension == 3; });
  std::map<std::int64_t, std::vector<Index>> sides;
  SideLabels labels;
  const auto add_side = [&](std::int64_t reference, std::span<const Index> vertices) {
    labels.add(vertices, label_of(reference));
    auto& list = sides[reference];
    list.insert(list.end(), vertices.begin(), vertices.end());
  };
  std::map<std::int64_t, std::uint32_t> groups;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const std::int64_t reference = references_[cell];
    if (volume && traits(cells_.kind(cell)).dimension == 2) {
      add_side(reference, cells_.vertices(cell));
    } else if (reference != 0) {
      const auto next = static_cast<std::uint32_t>(file.group_names.size());
      const auto [at, is_new] = groups.emplace(reference, next);
      if (is_new) file.group_names.push_back(fmt::format("ref {}", reference));
      cells_.set_group(cell, at->second);
    }
  }
  for (std::size_t e = 0; e < edges() && !volume; ++e) {
    add_side(edge_references_[e], std::span(edges_).subspan(2 * e, 2));
  }
  add_sets("marker", std::move(sides), file.sets);
  add_sets("nset", std::move(vertices_by_reference_), file.sets);

  const std::vector<Index> between = labels.rims();
  held_.insert(held_.end(), between.begin(), between.end());
  file.held = {std::move(held_), "required by the file, or at the rim of a reference"};
  file.mesh = Mesh(std::move(points_), std::move(cells_));
  return file;
}

}  // namespace evenmesh
