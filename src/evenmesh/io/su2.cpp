// SPDX-License-Identifier: MIT
#include "evenmesh/io/su2.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/io/placed_patch.h"
#include "evenmesh/io/side_labels.h"
#include "evenmesh/io/text_scanner.h"

namespace evenmesh {
namespace {

constexpr std::size_t kLeastNode = 4;  // "0 0" and the end of its line

/// The kinds of cell go by VTK's numbers.
std::optional<CellKind> cell_kind(std::int64_t type) {
  switch (type) {
    case 5:
      return CellKind::triangle;
    case 9:
      return CellKind::quad;
    case 10:
      return CellKind::tet;
    case 12:
      return CellKind::hex;
    case 13:
      return CellKind::wedge;
    case 14:
      return CellKind::pyramid;
    default:
      return std::nullopt;
  }
}

std::size_t corners_of(CellKind kind) { return static_cast<std::size_t>(traits(kind).vertices); }

/// A side may also be a line, or a vertex that another zone shares. 0: it is none of these.
std::size_t corners_of_side(std::int64_t type) {
  constexpr std::int64_t kVertex = 1;
  constexpr std::int64_t kLine = 3;
  if (type == kVertex || type == kLine) return type == kLine ? 2 : 1;
  const auto kind = cell_kind(type);
  return kind ? corners_of(*kind) : 0;
}

/// Elements come before nodes as a rule, so their numbers are checked at the end.
class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), scanner_(*input_, '%') {}

  MeshFile read() {
    while (scanner_.next()) read_entry();
    if (points_.empty()) input_->fail("has no nodes (NPOIN=); export the mesh again");
    check_corners();
    return take_file();
  }

 private:
  void read_entry() {
    const char* const place = scanner_.place();
    const char* stop = place;
    while (stop != scanner_.end() && *stop != '=' && !is_blank(*stop) && !is_eol(*stop)) ++stop;
    const std::string_view key(place, static_cast<std::size_t>(stop - place));
    scanner_.set_place(stop);
    if (!scanner_.has_word() || *scanner_.place() != '=') {
      scanner_.fail(place, fmt::format("{} where an entry such as NELEM= is expected",
                                       quoted_word(place, scanner_.end())));
    }
    scanner_.set_place(scanner_.place() + 1);
    if (key == "NDIME") {
      read_dimension(place);
    } else if (key == "NZONE") {
      if (scanner_.count("the number of zones") > 1) {
        scanner_.fail(place, "several zones in one file are not read; smooth one file per zone");
      }
    } else if (key == "NELEM") {
      read_elements();
    } else if (key == "NPOIN") {
      read_nodes();
    } else if (key == "NMARK") {
    } else if (key == "MARKER_TAG") {
      read_marker();
    } else {
      skip_entry();
      return;
    }
    scanner_.skip_line();
  }

  /// Passes over the lines of an entry that is not known, up to the next.
  void skip_entry() {
    scanner_.skip_line();
    while (scanner_.next()) {
      const std::string_view word = scanner_.peek();
      if ((word[0] >= 'A' && word[0] <= 'Z') && word.find('=') != std::string_view::npos) return;
      scanner_.skip_line();
    }
  }

  void read_dimension(const char* place) {
    const std::uint64_t dimension = scanner_.count("the number of dimensions");
    if (dimension != 2 && dimension != 3) {
      scanner_.fail(place, fmt::format("NDIME is {}; meshes have 2 or 3 dimensions", dimension));
    }
    dimension_ = static_cast<int>(dimension);
  }

  void read_elements() {
    const std::uint64_t count = scanner_.count("the number of elements");
    scanner_.skip_line();
    constexpr std::size_t kLeast = 8;  // "5 0 1 2" and the end of its line
    scanner_.check_room(count, kLeast, "elements");
    cells_.reserve(count, 3 * count);
    cell_places_.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      const char* const place = next_line("elements", i, count);
      const std::int64_t number = scanner_.integer("the type of an element");
      const auto kind = cell_kind(number);
      if (!kind) {
        scanner_.fail(place,
                      fmt::format("element {} has type {}; SU2 has triangles (5), quads (9), "
                                  "tets (10), hexes (12), wedges (13) and pyramids (14)",
                                  i, number));
      }
      read_corners(corners_of(*kind), i);
      cells_.add(*kind, corners_);
      cell_places_.push_back(scanner_.offset(place));
      if (i + 1 < count) scanner_.skip_line();  // the number of the element, if it is there
    }
  }

  void read_corners(std::size_t count, std::uint64_t element) {
    corners_.clear();
    for (std::size_t k = 0; k < count; ++k) {
      const char* const place = scanner_.place();
      if (!scanner_.has_word()) {
        scanner_.fail(fmt::format("element {} has {} of {} nodes", element, k, count));
      }
      const std::int64_t node = scanner_.integer("the number of a node");
      if (node < 0 || node >= std::numeric_limits<Index>::max()) {
        scanner_.fail(place, fmt::format("element {} names node {}", element, node));
      }
      corners_.push_back(static_cast<Index>(node));
    }
  }

  /// Moves to the next line with words.
  const char* next_line(std::string_view what, std::uint64_t has, std::uint64_t count) {
    if (!scanner_.next()) {
      scanner_.fail(
          fmt::format("the file ends after {} of {} {}; it was cut off", has, count, what));
    }
    return scanner_.place();
  }

  void read_nodes() {
    if (dimension_ == 0) scanner_.fail("NPOIN= comes before NDIME=; put the dimension first");
    if (!points_.empty()) scanner_.fail("a second NPOIN=; several zones are not read");
    const std::uint64_t count = scanner_.count("the number of nodes");
    scanner_.skip_line();  // without ghost nodes there is only this one number
    scanner_.check_room(count, kLeastNode, "nodes");
    points_.reserve(count);
    places_.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      next_line("nodes", i, count);
      std::uint64_t offset = scanner_.offset();
      Vec3 position = Vec3::Zero();
      for (int k = 0; k < dimension_; ++k) {
        if (!scanner_.has_word()) {
          scanner_.fail(fmt::format("node {} has {} of {} coordinates", i, k, dimension_));
        }
        position[k] = scanner_.real("a coordinate");
      }
      points_.push_back(position);
      places_.push_back(offset);
      if (i + 1 < count) scanner_.skip_line();
    }
  }

  void read_marker() {
    const std::string name(scanner_.rest_of_line());
    const std::string_view key = next_key();
    if (key != "MARKER_ELEMS") {
      scanner_.fail(fmt::format("marker {} has no MARKER_ELEMS=", name));
    }
    const std::uint64_t count = scanner_.count("the number of sides of a marker");
    constexpr std::size_t kLeast = 4;
    scanner_.check_room(count, kLeast, "sides");
    std::vector<Index> vertices;
    for (std::uint64_t i = 0; i < count; ++i) {
      scanner_.skip_line();
      while (scanner_.next() && is_key(scanner_.peek())) scanner_.skip_line();  // SEND_RECV=
      next_line("sides", i, count);
      const char* const place = scanner_.place();
      const std::int64_t number = scanner_.integer("the type of a side");
      const std::size_t corners = corners_of_side(number);
      if (corners == 0) {
        scanner_.fail(place, fmt::format("a side has type {}; lines (3), triangles (5), quads (9) "
                                         "and vertices (1) are read",
                                         number));
      }
      read_corners(corners, i);
      vertices.insert(vertices.end(), corners_.begin(), corners_.end());
      highest_in_markers_ = std::max<std::uint64_t>(
          highest_in_markers_, *std::max_element(corners_.begin(), corners_.end()));
      if (highest_in_markers_ < most_nodes()) {
        labels_.add(corners_, static_cast<std::uint32_t>(sets_.size() + 1));
      }
    }
    sets_.push_back(named_list("marker", name, count, "sides", std::move(vertices)));
  }

  /// No file has more nodes than it has bytes.
  std::uint64_t most_nodes() const { return input_->bytes().size(); }

  static bool is_key(std::string_view word) {
    return !word.empty() && word[0] >= 'A' && word[0] <= 'Z' &&
           word.find('=') != std::string_view::npos;
  }

  /// The key of the next line, which is passed over with its equals sign.
  std::string_view next_key() {
    scanner_.skip_line();
    if (!scanner_.next()) return {};
    const char* const first = scanner_.place();
    const char* stop = first;
    while (stop != scanner_.end() && *stop != '=' && !is_blank(*stop) && !is_eol(*stop)) ++stop;
    scanner_.set_place(stop);
    if (scanner_.has_word() && *scanner_.place() == '=') scanner_.set_place(scanner_.place() + 1);
    return {first, static_cast<std::size_t>(stop - first)};
  }

  void check_corners() const {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      for (const Index v : cells_.vertices(cell)) {
        if (v < points_.size()) continue;
        input_->fail_at(cell_places_[cell],
                        fmt::format("element {} names node {}; the {} nodes count from 0", cell, v,
                                    points_.size()));
      }
    }
    if (!sets_.empty() && highest_in_markers_ >= points_.size()) {
      input_->fail(fmt::format("a marker names node {}; the {} nodes count from 0",
                               highest_in_markers_, points_.size()));
    }
  }

  MeshFile take_file() {
    MeshFile file;
    if (cells_.empty()) file.notes.push_back("The file has nodes but no elements.");
    file.sets = std::move(sets_);
    file.held = {labels_.rims(), "at the rims of markers"};
    file.mesh = Mesh(std::move(points_), std::move(cells_));
    file.patch = std::make_unique<PlacedPatch>(
        "su2", input_, CoordinateCode{.dimension = dimension_}, std::move(places_),
        FileNumbers{.vertex = "node", .cell = "element", .cell_places = std::move(cell_places_)});
    return file;
  }

  std::shared_ptr<const InputFile> input_;
  TextScanner scanner_;
  int dimension_ = 0;
  std::vector<Vec3> points_;
  std::vector<std::uint64_t> places_;
  Cells cells_;
  std::vector<std::uint64_t> cell_places_;
  std::vector<NamedSet> sets_;
  std::uint64_t highest_in_markers_ = 0;
  SideLabels labels_;
  std::vector<Index> corners_;  // of the element at hand
};

}  // namespace

MeshFile read_su2(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
