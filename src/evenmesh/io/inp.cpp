// SPDX-License-Identifier: MIT
#include "evenmesh/io/inp.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/deck_lines.h"
#include "evenmesh/io/inp_elements.h"
#include "evenmesh/io/inp_holders.h"
#include "evenmesh/io/inp_sets.h"
#include "evenmesh/io/placed_patch.h"
#include "evenmesh/io/second_order.h"
#include "evenmesh/io/text_scan.h"

namespace evenmesh {
namespace {

/// As many characters of a number as Abaqus and CalculiX read.
constexpr std::size_t kWidestNumber = 20;

/// Keywords that make nodes or elements of others, whose places then depend on theirs.
constexpr std::array<std::string_view, 7> kGenerators = {"NGEN",  "NFILL",  "NCOPY", "NMAP",
                                                         "ELGEN", "ELCOPY", "SYSTEM"};

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), sets_(std::make_shared<InpSets>()) {}

  MeshFile read() {
    read_nodes();
    if (points_.empty()) {
      input_->fail(
          "has no *NODE; if the mesh is in a file that this one includes, smooth that file");
    }
    index_nodes();
    cells_.reserve(points_.size(), 0);
    read_rest(*input_, 0);
    index_elements();
    resolve_sets();
    group_cells();
    return take_file();
  }

 private:
  // ---- nodes ----
  void read_nodes() {
    for_each_block(*input_, [&](const DeckKeyword& keyword, DeckLines& lines, std::size_t scope) {
      if (keyword.name == "NODE") read_node_block(keyword, lines, scope);
    });
  }

  /// Calls read with each keyword, the lines at the first one behind it, and the scope they are in.
  template <typename Read>
  void for_each_block(const InputFile& file, const Read& read) {
    DeckLines lines(file);
    std::size_t scope = 0;
    lines.next();
    while (!lines.text().empty()) {
      if (!lines.is_keyword()) {
        lines.next();
        continue;
      }
      const DeckKeyword keyword = read_keyword(lines);
      scope = enter(keyword, scope);
      lines.next();
      read(keyword, lines, scope);
    }
  }

  /// Follows *PART, *INSTANCE and *ASSEMBLY. @return  the scope that the lines behind it are in
  std::size_t enter(const DeckKeyword& keyword, std::size_t scope) {
    if (keyword.name == "PART") {
      const std::string name = keyword.value("NAME");
      const std::size_t known = sets_->scope_of_part(name);
      return known != 0 ? known : sets_->add_scope(name);
    }
    if (keyword.name == "INSTANCE") {
      const std::string name = keyword.value("NAME");
      const std::string part = keyword.value("PART");
      if (!part.empty()) sets_->add_instance(name, part);
      return sets_->scope_of_part(part);
    }
    const bool ends = keyword.name == "END PART" || keyword.name == "END INSTANCE" ||
                      keyword.name == "ASSEMBLY" || keyword.name == "END ASSEMBLY";
    return ends ? 0 : scope;
  }

  void read_node_block(const DeckKeyword& keyword, DeckLines& lines, std::size_t scope) {
    if (keyword.find("INPUT") != nullptr) {
      input_->fail_at(keyword.place,
                      "the nodes are in another file; put them here, or smooth that "
                      "file if the elements are there too");
    }
    const std::string system = in_capitals(keyword.value("SYSTEM"));
    if (!system.empty() && system != "R") {
      input_->fail_at(keyword.place,
                      "the nodes are in cylindrical or spherical coordinates "
                      "(SYSTEM); write them in Cartesian ones");
    }
    for (; !lines.text().empty() && !lines.is_keyword(); lines.next()) read_node(lines, scope);
  }

  void read_node(const DeckLines& lines, std::size_t scope) {
    std::int64_t number = 0;
    const char* p = scan_whole(lines.first(), lines.last(), number);
    if (p == nullptr || number <= 0) {
      input_->fail_at(lines.first(), fmt::format("{} is no number of a node",
                                                 quoted_word(lines.first(), lines.last())));
    }
    Vec3 position = Vec3::Zero();
    int dimension = 0;
    std::uint64_t place = 0;
    for (; dimension < 3; ++dimension) {
      while (p != lines.last() && is_blank(*p)) ++p;
      if (p == lines.last()) break;
      if (*p != ',') fail_coordinate(p, lines.last(), number);
      ++p;
      while (p != lines.last() && is_blank(*p)) ++p;
      if (p == lines.last()) break;
      const char* const stop = scan_value(p, lines.last(), position[dimension]);
      if (stop == nullptr) fail_coordinate(p, lines.last(), number);
      if (dimension == 0) place = offset(p);
      p = stop;
    }
    if (dimension < 2) {
      input_->fail_at(lines.first(), fmt::format("node {} has {} of 3 coordinates; write them all",
                                                 number, dimension));
    }
    if (dimension_ == 0) dimension_ = dimension;
    if (dimension != dimension_) {
      input_->fail_at(lines.first(), fmt::format("node {} has {} coordinates where others have {}; "
                                                 "write three everywhere",
                                                 number, dimension, dimension_));
    }
    InpSets::Scope& in = sets_->scope(scope);
    in.nodes.push_back(static_cast<std::uint64_t>(number));
    in.vertices.push_back(static_cast<Index>(points_.size()));
    numbers_.push_back(static_cast<std::uint64_t>(number));
    points_.push_back(position);
    places_.push_back(place);
  }

  [[noreturn]] void fail_coordinate(const char* p, const char* end, std::int64_t node) const {
    const bool empty = p != end && *p == ',';
    end = std::find(p, end, ',');
    input_->fail_at(p, fmt::format("{} (a coordinate of node {})",
                                   empty ? "a coordinate is left out, write 0 for it"
                                         : explain_bad_number(p, end),
                                   node));
  }

  void index_nodes() {
    if (points_.size() >= std::numeric_limits<Index>::max()) {
      input_->fail("has more nodes than 32-bit numbers can count");
    }
    for (std::size_t s = 0; s < sets_->scopes(); ++s) {
      InpSets::Scope& scope = sets_->scope(s);
      const std::size_t twice = scope.node_numbers.index(scope.nodes);
      if (twice == scope.nodes.size()) continue;
      input_->fail_at(places_[scope.vertices[twice]],
                      fmt::format("node {} is there twice; number the nodes anew or remove one",
                                  scope.nodes[twice]));
    }
  }

  // ---- everything else ----
  void read_rest(const InputFile& file, int depth) {
    for_each_block(file, [&](const DeckKeyword& keyword, DeckLines& lines, std::size_t scope) {
      read_block(file, keyword, lines, scope, depth);
    });
  }

  void read_block(const InputFile& file, const DeckKeyword& keyword, DeckLines& lines,
                  std::size_t scope, int depth) {
    const std::string& name = keyword.name;
    if (std::ranges::find(kGenerators, name) != kGenerators.end()) {
      file.fail_at(keyword.place, fmt::format("*{} makes nodes or elements that depend on others; "
                                              "write the deck with all of them listed",
                                              name));
    }
    if (depth > 0 && (name == "NODE" || name == "ELEMENT")) {
      file.fail_at(
          keyword.place,
          "the mesh is spread over several files; smooth it in a deck that holds all of it");
    }
    if (name == "NODE" && keyword.find("NSET") != nullptr) {
      read_numbers_only(lines, sets_->set(InpSets::Kind::nodes, scope, keyword.value("NSET")),
                        scope);
    } else if (name == "ELEMENT") {
      read_elements(keyword, lines, scope);
    } else if (name == "NSET") {
      read_set(file, keyword, lines, InpSets::Kind::nodes, scope);
    } else if (name == "ELSET") {
      read_set(file, keyword, lines, InpSets::Kind::elements, scope);
    } else if (name == "INCLUDE") {
      include(file, keyword, depth);
    } else if (name.ends_with("SECTION") && keyword.find("ELSET") != nullptr) {
      sections_.push_back({scope, keyword.value("ELSET")});
    } else {
      holders_.note(keyword, lines, scope);
    }
  }

  void include(const InputFile& file, const DeckKeyword& keyword, int depth) {
    constexpr int kDeepest = 8;
    const std::string name = keyword.value("INPUT");
    if (depth == kDeepest) file.fail_at(keyword.place, "files include each other too deeply");
    const std::filesystem::path path = std::filesystem::path(file.name()).parent_path() / name;
    std::shared_ptr<const InputFile> included;
    try {
      included = InputFile::open(path);
    } catch (const IoError& error) {
      file.fail_at(keyword.place,
                   fmt::format("an included file is needed, for it may hold elements "
                               "or sets: {}",
                               error.what()));
    }
    read_rest(*included, depth + 1);
  }

  void read_elements(const DeckKeyword& keyword, DeckLines& lines, std::size_t scope) {
    if (keyword.find("INPUT") != nullptr) {
      input_->fail_at(keyword.place, "the elements are in another file; put them here");
    }
    const std::string type_name = in_capitals(keyword.value("TYPE"));
    const auto type = inp_element_type(type_name);
    std::optional<std::size_t> set;
    if (keyword.find("ELSET") != nullptr) {
      set = sets_->set(InpSets::Kind::elements, scope, keyword.value("ELSET"));
    }
    block_of_cells_.push_back({cells_.size(), set});
    InpSets::Scope& in = sets_->scope(scope);
    while (!lines.text().empty() && !lines.is_keyword()) {
      const char* const place = lines.first();
      const std::int64_t number = read_element(lines, in, type ? type->nodes : 0);
      if (set) {
        const auto n = static_cast<std::uint64_t>(number);
        sets_->add_range(*set, scope, {n, n, 1});
      }
      in.elements.push_back(static_cast<std::uint64_t>(number));
      if (type) {
        in.cells.push_back(static_cast<Index>(cells_.size()));
        const std::size_t corners = static_cast<std::size_t>(traits(type->kind).vertices);
        cells_.add(type->kind, std::span(corners_).first(corners));
        add_followers(type->kind, EdgeOrder::levels, corners_, followers_);
        cell_places_.push_back(offset(place));
      } else {
        in.cells.push_back(NodeNumbers::kNone);
        held_.insert(held_.end(), corners_.begin(), corners_.end());
        ++without_cell_;
        if (without_cell_type_.empty()) without_cell_type_ = type_name;
      }
    }
  }

  /// Reads an element from the line at hand and those it goes on in, into corners_.
  /// @param nodes  how many; 0: as many as there are
  /// @return  its number
  std::int64_t read_element(DeckLines& lines, const InpSets::Scope& scope, std::size_t nodes) {
    corners_.clear();
    std::int64_t number = 0;
    NumberLine line(lines.first(), lines.last());
    if (!line.take(number) || number <= 0) {
      input_->fail_at(lines.first(), fmt::format("{} is no number of an element",
                                                 quoted_word(lines.first(), lines.last())));
    }
    for (;;) {
      while (!line.at_end()) corners_.push_back(read_corner(line, scope, number));
      const bool wants_more = nodes > 0 ? corners_.size() < nodes : line.goes_on();
      if (!lines.next() || !wants_more || lines.is_keyword()) break;
      line = NumberLine(lines.first(), lines.last());
    }
    if (nodes > 0 && corners_.size() != nodes) {
      input_->fail_at(lines.first(), fmt::format("element {} has {} nodes where its type has {}",
                                                 number, corners_.size(), nodes));
    }
    return number;
  }

  Index read_corner(NumberLine& line, const InpSets::Scope& scope, std::int64_t element) const {
    const char* const place = line.place();
    std::int64_t node = 0;
    if (!line.take(node)) {
      input_->fail_at(place, fmt::format("{} is no number of a node (in element {})",
                                         quoted_word(place, line.end()), element));
    }
    const Index found =
        node > 0 ? scope.node_numbers.find(static_cast<std::uint64_t>(node)) : NodeNumbers::kNone;
    if (found == NodeNumbers::kNone) {
      input_->fail_at(place,
                      fmt::format("element {} uses node {}, which is not there", element, node));
    }
    return scope.vertices[found];
  }

  void read_numbers_only(DeckLines& lines, std::size_t set, std::size_t scope) {
    for (; !lines.text().empty() && !lines.is_keyword(); lines.next()) {
      std::int64_t number = 0;
      if (scan_whole(lines.first(), lines.last(), number) == nullptr) continue;
      const auto n = static_cast<std::uint64_t>(number);
      sets_->add_range(set, scope, {n, n, 1});
    }
  }

  void read_set(const InputFile& file, const DeckKeyword& keyword, DeckLines& lines,
                InpSets::Kind kind, std::size_t scope) {
    const std::string name = keyword.value(kind == InpSets::Kind::nodes ? "NSET" : "ELSET");
    const std::size_t set = sets_->set(kind, scope, name);
    std::size_t from = scope;  // where its numbers are from
    if (keyword.find("INSTANCE") != nullptr) {
      from = sets_->scope_of_instance(keyword.value("INSTANCE"));
    }
    if (kind == InpSets::Kind::nodes && keyword.find("ELSET") != nullptr) {
      wanted_.push_back({set, InpSets::Kind::elements, from, keyword.value("ELSET")});
    }
    const bool generate = keyword.find("GENERATE") != nullptr;
    for (; !lines.text().empty() && !lines.is_keyword(); lines.next()) {
      if (generate) {
        sets_->add_range(set, from, read_range(file, lines));
      } else {
        read_set_line(lines, set, kind, from);
      }
    }
  }

  NumberRange read_range(const InputFile& file, const DeckLines& lines) const {
    NumberLine line(lines.first(), lines.last());
    std::int64_t first = 0;
    std::int64_t last = 0;
    std::int64_t step = 1;
    bool good = line.take(first);
    last = first;
    if (good && !line.at_end()) good = line.take(last);
    if (good && !line.at_end()) good = line.take(step);
    if (!good || first < 0 || last < first || step < 1) {
      file.fail_at(lines.first(), "GENERATE takes the first number, the last and the step");
    }
    return {static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(last),
            static_cast<std::uint64_t>(step)};
  }

  void read_set_line(const DeckLines& lines, std::size_t set, InpSets::Kind kind,
                     std::size_t scope) {
    NumberLine line(lines.first(), lines.last());
    while (!line.at_end()) {
      std::int64_t number = 0;
      const char* const place = line.place();
      if (line.take(number)) {
        const auto n = static_cast<std::uint64_t>(std::max<std::int64_t>(number, 0));
        sets_->add_range(set, scope, {n, n, 1});
        continue;
      }
      const std::string_view word = line.take_word();
      if (!word.empty()) wanted_.push_back({set, kind, scope, std::string(word)});
      if (line.place() == place) break;
    }
  }

  // ---- putting it together ----
  void index_elements() {
    for (std::size_t s = 0; s < sets_->scopes(); ++s) {
      InpSets::Scope& scope = sets_->scope(s);
      const std::size_t twice = scope.element_numbers.index(scope.elements);
      if (twice == scope.elements.size()) continue;
      const Index cell = scope.cells[twice];
      const std::string what =
          fmt::format("element {} is there twice; number the elements anew or remove one",
                      scope.elements[twice]);
      if (cell == NodeNumbers::kNone) input_->fail(what);
      input_->fail_at(cell_places_[cell], what);
    }
  }

  /// Sets may name others that come behind them.
  void resolve_sets() {
    for (const WantedSet& wanted : wanted_) {
      std::size_t scope = wanted.scope;
      std::string_view name = wanted.name;
      const std::size_t dot = name.rfind('.');
      if (dot != std::string_view::npos) {
        scope = sets_->scope_of_instance(name.substr(0, dot));
        name.remove_prefix(dot + 1);
      }
      if (const auto other = sets_->find(wanted.kind, scope, name)) {
        sets_->add_set(wanted.set, *other);
      }
    }
  }

  /// A cell is in the group of its section; without one, in that of its *ELEMENT.
  void group_cells() {
    std::vector<std::uint32_t> of(cells_.size(), 0);
    for (const Section& section : sections_) {
      const auto set = sets_->find_anywhere(InpSets::Kind::elements, section.scope, section.elset);
      if (!set) continue;
      const std::uint32_t group = group_of(*set, section.elset);
      for (const Index cell : sets_->members(*set)) of[cell] = group;
    }
    for (std::size_t b = 0; b < block_of_cells_.size(); ++b) {
      const auto& [first, set] = block_of_cells_[b];
      const std::size_t last =
          b + 1 < block_of_cells_.size() ? block_of_cells_[b + 1].first : cells_.size();
      for (std::size_t cell = first; set && cell < last; ++cell) {
        if (of[cell] == 0) of[cell] = group_of(*set, sets_->name(*set));
      }
    }
    for (std::size_t cell = 0; cell < of.size(); ++cell) cells_.set_group(cell, of[cell]);
  }

  std::uint32_t group_of(std::size_t set, const std::string& name) {
    const auto next = static_cast<std::uint32_t>(group_names_.size());
    const auto [at, is_new] = groups_.emplace(set, next);
    if (is_new) group_names_.push_back("elset " + name);
    return at->second;
  }

  MeshFile take_file() {
    MeshFile file;
    const std::vector<Index> named = holders_.vertices(*sets_, cells_, points_.size());
    held_.insert(held_.end(), named.begin(), named.end());
    if (const auto v = torn_vertex(followers_, cells_, points_.size())) {
      input_->fail_at(places_[*v], torn_message(fmt::format("node {}", numbers_[*v]), "element"));
    }
    if (cells_.empty()) {
      file.notes.push_back("The deck has nodes but no elements that make a surface or a volume.");
    }
    if (without_cell_ > 0) {
      file.notes.push_back(
          fmt::format("Elements that are no cells are not judged and their nodes stay: {}, the "
                      "first of type {}.",
                      without_cell_, without_cell_type_.empty() ? "none" : without_cell_type_));
    }
    file.held = {std::move(held_), "in loads, supports, couplings, beams or springs"};
    file.sets = InpSets::named(sets_);
    file.followers = std::move(followers_);
    file.group_names = std::move(group_names_);
    file.mesh = Mesh(std::move(points_), std::move(cells_));
    file.patch = std::make_unique<PlacedPatch>(
        "inp", input_, CoordinateCode{.dimension = dimension_, .widest = kWidestNumber},
        std::move(places_),
        FileNumbers{.vertex = "node",
                    .cell = "element",
                    .vertices = std::move(numbers_),
                    .cell_places = std::move(cell_places_),
                    .number_at_place = true});
    return file;
  }

  std::uint64_t offset(const char* p) const {
    return static_cast<std::uint64_t>(p - input_->bytes().data());
  }

  struct WantedSet {
    std::size_t set;
    InpSets::Kind kind;
    std::size_t scope;
    std::string name;
  };
  struct Section {
    std::size_t scope;
    std::string elset;
  };

  std::shared_ptr<const InputFile> input_;
  std::shared_ptr<InpSets> sets_;

  std::vector<Vec3> points_;
  std::vector<std::uint64_t> numbers_;  // of the nodes
  std::vector<std::uint64_t> places_;
  int dimension_ = 0;

  Cells cells_;
  std::vector<std::uint64_t> cell_places_;
  std::vector<Index> corners_;  // of the element at hand
  Followers followers_;
  std::size_t without_cell_ = 0;
  std::string without_cell_type_;

  std::vector<std::pair<std::size_t, std::optional<std::size_t>>> block_of_cells_;  // first, ELSET
  std::vector<Section> sections_;
  std::vector<WantedSet> wanted_;
  InpHolders holders_;
  std::vector<Index> held_;
  std::map<std::size_t, std::uint32_t> groups_;  // by set
  std::vector<std::string> group_names_{""};
};

}  // namespace

MeshFile read_inp(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
