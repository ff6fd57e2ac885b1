// SPDX-License-Identifier: MIT
#include "evenmesh/io/ucd.h"

#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "evenmesh/base/text.h"
#include "evenmesh/io/node_numbers.h"
#include "evenmesh/io/placed_patch.h"
#include "evenmesh/io/side_labels.h"
#include "evenmesh/io/text_scanner.h"

namespace evenmesh {
namespace {

struct CellType {
  std::string_view name;
  std::size_t nodes;
  bool is_cell;
  CellKind kind;
  std::array<std::uint8_t, 8> order;  // where our corners stand: the top comes first there
};
constexpr std::array kCellTypes{
    CellType{"pt", 1, false, CellKind::triangle, {}},
    CellType{"line", 2, false, CellKind::triangle, {}},
    CellType{"tri", 3, true, CellKind::triangle, {0, 1, 2}},
    CellType{"quad", 4, true, CellKind::quad, {0, 1, 2, 3}},
    CellType{"tet", 4, true, CellKind::tet, {0, 1, 3, 2}},
    CellType{"hex", 8, true, CellKind::hex, {4, 5, 6, 7, 0, 1, 2, 3}},
    CellType{"prism", 6, true, CellKind::wedge, {3, 4, 5, 0, 1, 2}},
    CellType{"pyr", 5, true, CellKind::pyramid, {1, 2, 3, 4, 0}},
};

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), scanner_(*input_, '#') {}

  MeshFile read() {
    const std::uint64_t nodes = scanner_.count("the number of nodes");
    const std::uint64_t cells = scanner_.count("the number of cells");
    scanner_.skip_line();  // how many data follow
    if (nodes == 0) input_->fail("has no nodes; export the mesh again");
    constexpr std::size_t kLeastNode = 8;  // "1 0 0 0" and the end of its line
    constexpr std::size_t kLeastCell = 8;  // "1 0 pt 1"
    scanner_.check_room(nodes, kLeastNode, "nodes");
    for (std::uint64_t i = 0; i < nodes; ++i) read_node();
    const std::size_t twice = numbers_.index(tags_);
    if (twice < tags_.size()) {
      input_->fail_at(places_[twice],
                      fmt::format("node {} is there twice; number the nodes anew", tags_[twice]));
    }
    scanner_.check_room(cells, kLeastCell, "cells");
    for (std::uint64_t i = 0; i < cells; ++i) read_cell();
    return take_file();
  }

 private:
  void read_node() {
    tags_.push_back(scanner_.count("the number of a node"));
    places_.push_back(0);
    points_.push_back(scanner_.position(3, tags_.back(), places_.back()));
  }

  void read_cell() {
    const std::uint64_t number = scanner_.count("the number of a cell");
    const std::uint64_t place = scanner_.offset();
    const std::int64_t material = scanner_.integer("the material of a cell");
    scanner_.next();
    const char* const type_place = scanner_.place();
    const std::string_view word = scanner_.word();
    const auto* const type =
        std::find_if(kCellTypes.begin(), kCellTypes.end(),
                     [word](const CellType& t) { return equal_but_for_case(t.name, word); });
    if (type == kCellTypes.end()) {
      scanner_.fail(type_place, fmt::format("{} is no type of cell; pt, line, tri, quad, tet, hex, "
                                            "prism and pyr are read",
                                            quoted_word(type_place, scanner_.end())));
    }
    corners_.clear();
    for (std::size_t i = 0; i < type->nodes; ++i) read_corner(number);
    if (!type->is_cell) {
      if (type->nodes != 2) return;
      lines_.insert(lines_.end(), corners_.begin(), corners_.end());
      labels_.push_back(label_of(material));
      return;
    }
    std::array<Index, 8> ordered{};
    for (std::size_t i = 0; i < type->nodes; ++i) ordered[i] = corners_[type->order[i]];
    cells_.add(type->kind, std::span(ordered).first(type->nodes), group_of(material));
    cell_numbers_.push_back(number);
    cell_places_.push_back(place);
  }

  void read_corner(std::uint64_t cell) {
    scanner_.next();
    const char* const place = scanner_.place();
    const std::uint64_t node = scanner_.count("the number of a node");
    const Index vertex = numbers_.find(node);
    if (vertex == NodeNumbers::kNone) {
      scanner_.fail(place,
                    fmt::format("cell {} uses node {}, which the file does not have", cell, node));
    }
    corners_.push_back(vertex);
  }

  std::uint32_t group_of(std::int64_t material) {
    if (material == 0) return 0;
    const auto next = static_cast<std::uint32_t>(names_.size());
    const auto [at, is_new] = groups_.emplace(material, next);
    if (is_new) names_.push_back(fmt::format("material {}", material));
    return at->second;
  }

  /// Boundaries have numbers of their own, 0 as well.
  std::uint32_t label_of(std::int64_t material) {
    const auto next = static_cast<std::uint32_t>(boundaries_.size() + 1);
    return boundaries_.emplace(material, next).first->second;
  }

  MeshFile take_file() {
    MeshFile file;
    if (cells_.empty()) {
      file.notes.push_back("The file has nodes but no cells that make a surface or a volume.");
    }
    file.group_names = std::move(names_);
    file.held = {held_by_groups(cells_, lines_, labels_),
                 "on lines of the file, or at the rims of its groups"};
    file.mesh = Mesh(std::move(points_), std::move(cells_));
    file.patch = std::make_unique<PlacedPatch>("ucd", input_, CoordinateCode{}, std::move(places_),
                                               FileNumbers{.vertex = "node",
                                                           .cell = "cell",
                                                           .vertices = std::move(tags_),
                                                           .cells = std::move(cell_numbers_),
                                                           .cell_places = std::move(cell_places_)});
    return file;
  }

  std::shared_ptr<const InputFile> input_;
  TextScanner scanner_;
  std::vector<Vec3> points_;
  std::vector<std::uint64_t> tags_;
  std::vector<std::uint64_t> places_;
  NodeNumbers numbers_;
  Cells cells_;
  std::vector<std::uint64_t> cell_numbers_;
  std::vector<std::uint64_t> cell_places_;
  std::vector<std::string> names_{""};
  std::map<std::int64_t, std::uint32_t> groups_;
  std::map<std::int64_t, std::uint32_t> boundaries_;
  std::vector<Index> lines_;  // pairs
  std::vector<std::uint32_t> labels_;
  std::vector<Index> corners_;  // of the cell at hand
};

}  // namespace

bool looks_like_ucd(std::string_view text) {
  while (!text.empty() && (is_space(text.front()) || text.front() == '#')) {
    if (text.front() == '#') {
      text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    } else {
      text.remove_prefix(1);
    }
  }
  constexpr int kCounts = 5;
  std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  for (int i = 0; i < kCounts; ++i) {
    line = trimmed(line);
    const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
    if (digits == 0 || (digits < line.size() && !is_space(line[digits]))) return false;
    line.remove_prefix(digits);
  }
  return trimmed(line).empty();
}

MeshFile read_ucd(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
