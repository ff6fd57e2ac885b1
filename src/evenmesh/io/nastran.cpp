// SPDX-License-Identifier: MIT
#include "evenmesh/io/nastran.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/text.h"
#include "evenmesh/io/byte_patcher.h"
#include "evenmesh/io/nastran_cards.h"
#include "evenmesh/io/node_numbers.h"
#include "evenmesh/io/placed_patch.h"
#include "evenmesh/io/second_order.h"

namespace evenmesh {
namespace {

constexpr std::size_t kNarrow = 8;
constexpr std::size_t kWide = 16;
constexpr std::size_t kFirstCoordinate = 3;  // field of a GRID

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// How many characters each coordinate of a GRID may have; 0 if there is no place for it.
using Widths = std::array<std::uint8_t, 3>;

/// Between commas a deck that has long numbers gets such.
Widths widths_of(const NastranCard& card) {
  Widths widths{};
  std::array<bool, 3> is_word{};
  bool has_long = false;
  for (std::size_t k = 0; k < 3 && kFirstCoordinate + k < card.fields.size(); ++k) {
    const NastranField& field = card.fields[kFirstCoordinate + k];
    widths[k] = static_cast<std::uint8_t>(field.width);
    is_word[k] = field.form == NastranField::Form::word;
    has_long |= is_word[k] && field.text.size() > kNarrow;
  }
  for (std::size_t k = 0; has_long && k < 3; ++k) {
    if (is_word[k]) widths[k] = kWide;
  }
  return widths;
}

// ---- writing ---------------------------------------------------------------------------------
/// Writes the coordinates of one GRID.
class GridWriter {
 public:
  explicit GridWriter(BytePatcher& out) : out_(out) {}

  void write(const NastranField& field, std::string text) {
    const bool is_word = field.form == NastranField::Form::word;
    const auto length = static_cast<std::size_t>(field.last - field.first);
    if (length == 0) {
      // Fields behind the end of a line come one behind the other.
      const std::size_t there = field.first == line_end_ ? added_ : 0;
      text.insert(0, field.missing - std::min(field.missing, there), is_word ? ',' : ' ');
      added_ = is_word ? field.missing : there + text.size();
      line_end_ = field.first;
    } else if (!is_word && text.size() < length) {
      const bool left = field.text.empty() || field.text.data() == field.first;
      text.insert(left ? text.size() : 0, length - text.size(), ' ');
    }
    out_.replace(field.first, field.last, text);
  }

 private:
  BytePatcher& out_;
  const char* line_end_ = nullptr;
  std::size_t added_ = 0;  // columns or commas at line_end_
};

class NastranPatch : public PlacedPatch {
 public:
  NastranPatch(std::shared_ptr<const InputFile> input, std::vector<std::uint64_t> places,
               std::vector<Widths> widths, FileNumbers numbers)
      : PlacedPatch("nastran", input, CoordinateCode{}, places, std::move(numbers)),
        input_(std::move(input)),
        places_(std::move(places)),
        widths_(std::move(widths)) {}

  std::vector<Vec3> representable(Points points) const override {
    std::vector<Vec3> result(points.begin(), points.end());
    for (std::size_t v = 0; v < result.size(); ++v) {
      for (int k = 0; k < 3; ++k) {
        const std::size_t width = widths_[v][static_cast<std::size_t>(k)];
        const std::string text = width == 0 ? "0." : nastran_real(result[v][k], width);
        scan_nastran_real(text, result[v][k]);
      }
    }
    return result;
  }

  void write(Points points, const std::function<void(std::string_view)>& sink) const override {
    input_->check_unchanged();
    const std::string_view bytes = input_->bytes();
    BytePatcher out(bytes, sink);
    NastranCard card;
    for (std::size_t v = 0; v < places_.size(); ++v) {
      NastranCards cards(bytes.data() + places_[v], bytes.data() + bytes.size());
      if (!cards.next(card)) continue;
      GridWriter writer(out);
      for (std::size_t k = 0; k < 3; ++k) {
        const double wanted = points[v][static_cast<int>(k)];
        double before = 0.0;
        const std::size_t field = kFirstCoordinate + k;
        scan_nastran_real(card.text(field), before);
        if (same_bits(before, wanted) || widths_[v][k] == 0) continue;
        writer.write(card.fields[field], nastran_real(wanted, widths_[v][k]));
      }
    }
    out.finish();
    input_->check_unchanged();
  }

 private:
  std::shared_ptr<const InputFile> input_;
  std::vector<std::uint64_t> places_;
  std::vector<Widths> widths_;
};

// ---- elements --------------------------------------------------------------------------------
struct ElementType {
  std::string_view name;
  CellKind kind;
  std::size_t corners;
  std::size_t nodes;  // with those in the middle of edges, which may be left out
};
constexpr std::array kElementTypes{
    ElementType{"CTRIA3", CellKind::triangle, 3, 3},
    ElementType{"CTRIAR", CellKind::triangle, 3, 3},
    ElementType{"CTRIA6", CellKind::triangle, 3, 6},
    ElementType{"CQUAD4", CellKind::quad, 4, 4},
    ElementType{"CQUADR", CellKind::quad, 4, 4},
    ElementType{"CQUAD8", CellKind::quad, 4, 8},
    ElementType{"CQUAD", CellKind::quad, 4, 9},
    ElementType{"CSHEAR", CellKind::quad, 4, 4},
    ElementType{"CTRIAX", CellKind::triangle, 3, 6},
    ElementType{"CQUADX", CellKind::quad, 4, 9},
    ElementType{"CPLSTN3", CellKind::triangle, 3, 3},
    ElementType{"CPLSTN4", CellKind::quad, 4, 4},
    ElementType{"CPLSTN6", CellKind::triangle, 3, 6},
    ElementType{"CPLSTN8", CellKind::quad, 4, 8},
    ElementType{"CPLSTS3", CellKind::triangle, 3, 3},
    ElementType{"CPLSTS4", CellKind::quad, 4, 4},
    ElementType{"CPLSTS6", CellKind::triangle, 3, 6},
    ElementType{"CPLSTS8", CellKind::quad, 4, 8},
    ElementType{"CTETRA", CellKind::tet, 4, 10},
    ElementType{"CPYRAM", CellKind::pyramid, 5, 13},
    ElementType{"CPYRA", CellKind::pyramid, 5, 13},
    ElementType{"CPENTA", CellKind::wedge, 6, 15},
    ElementType{"CHEXA", CellKind::hex, 8, 20},
};

/// Where a card names grids whose places it hangs on.
struct HoldingCard {
  std::string_view name;
  std::size_t first;  // field
  std::size_t step;   // to the next; 0: there is no other
  std::size_t last;   // ~0: as many as there are
};
constexpr std::size_t kAll = ~std::size_t{0};
constexpr std::array kHoldingCards{
    HoldingCard{"CBAR", 3, 1, 5},       HoldingCard{"CBEAM", 3, 1, 5},
    HoldingCard{"CBEND", 3, 1, 5},      HoldingCard{"CROD", 3, 1, 4},
    HoldingCard{"CTUBE", 3, 1, 4},      HoldingCard{"CONROD", 2, 1, 3},
    HoldingCard{"CBUSH", 3, 1, 5},      HoldingCard{"CBUSH1D", 3, 1, 4},
    HoldingCard{"CGAP", 3, 1, 5},       HoldingCard{"CVISC", 3, 1, 4},
    HoldingCard{"CELAS1", 3, 2, 5},     HoldingCard{"CELAS2", 3, 2, 5},
    HoldingCard{"CDAMP1", 3, 2, 5},     HoldingCard{"CDAMP2", 3, 2, 5},
    HoldingCard{"CMASS1", 3, 2, 5},     HoldingCard{"CMASS2", 3, 2, 5},
    HoldingCard{"CONM1", 2, 0, 2},      HoldingCard{"CONM2", 2, 0, 2},
    HoldingCard{"CTRIAX6", 3, 1, 8},    HoldingCard{"RBAR", 2, 1, 3},
    HoldingCard{"RROD", 2, 1, 3},       HoldingCard{"RBE1", 2, 2, kAll},
    HoldingCard{"RSPLINE", 3, 2, kAll}, HoldingCard{"SPC", 2, 3, 5},
    HoldingCard{"SPCD", 2, 3, 5},       HoldingCard{"SUPORT", 1, 2, 7},
    HoldingCard{"SUPORT1", 2, 2, 6},    HoldingCard{"ASET", 1, 2, 7},
    HoldingCard{"BSET", 1, 2, 7},       HoldingCard{"CSET", 1, 2, 7},
    HoldingCard{"OMIT", 1, 2, 7},       HoldingCard{"FORCE", 2, 0, 2},
    HoldingCard{"MOMENT", 2, 0, 2},     HoldingCard{"FORCE1", 2, 2, 4},
    HoldingCard{"MOMENT1", 2, 2, 4},    HoldingCard{"SLOAD", 2, 2, 6},
    HoldingCard{"CORD1R", 2, 1, 4},     HoldingCard{"CORD1C", 2, 1, 4},
    HoldingCard{"CORD1S", 2, 1, 4},
};

/// Cards that list grids, with "THRU" between the ends of a range.
struct ListingCard {
  std::string_view name;
  std::size_t first;
};
constexpr std::array kListingCards{ListingCard{"SPC1", 3},  ListingCard{"RBE2", 4},
                                   ListingCard{"ASET1", 2}, ListingCard{"BSET1", 2},
                                   ListingCard{"CSET1", 2}, ListingCard{"OMIT1", 2}};

template <typename Table>
const typename Table::value_type* find_row(const Table& table, std::string_view name) {
  const auto at = std::find_if(table.begin(), table.end(),
                               [name](const auto& row) { return row.name == name; });
  return at == table.end() ? nullptr : &*at;
}

/// @return  false where the field has no whole number above zero
bool whole_number(std::string_view text, std::uint64_t& value) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && stop == text.data() + text.size() && value > 0;
}

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), bulk_(nastran_bulk(input_->bytes())) {}

  MeshFile read() {
    for_each_card([this](const NastranCard& card) { read_grid(card); });
    if (points_.empty()) input_->fail("has no GRID; give the file that has the mesh");
    const std::size_t twice = numbers_.index(ids_);
    if (twice < ids_.size()) {
      input_->fail_at(places_[twice],
                      fmt::format("GRID {} is there twice; number the grids anew", ids_[twice]));
    }
    for_each_card([this](const NastranCard& card) { read_other(card); });
    return take_file();
  }

 private:
  template <typename Visit>
  void for_each_card(const Visit& visit) const {
    const std::string_view bytes = input_->bytes();
    NastranCards cards(bulk_, bytes.data() + bytes.size());
    NastranCard card;
    while (cards.next(card) && card.name != "ENDDATA") visit(card);
  }

  [[noreturn]] void fail(const NastranCard& card, std::string_view message) const {
    input_->fail_at(card.place, message);
  }

  std::uint64_t id_of(const NastranCard& card) const {
    std::uint64_t id = 0;
    if (whole_number(card.text(1), id)) return id;
    fail(card, fmt::format("{} has '{}' where its number should be", shown(card.name),
                           shown(card.text(1))));
  }

  // ---- grids ---------------------------------------------------------------------------------
  void read_grid(const NastranCard& card) {
    if (card.name == "INCLUDE") {
      fail(card, "INCLUDE: put what is in that file here, where the mesh needs it");
    }
    if (card.name != "GRID" && card.name != "GRDSET") return;
    const std::string_view system = card.text(2);
    if (!system.empty() && system != "0") {
      const bool is_grid = card.name == "GRID";
      fail(card, fmt::format("{}{} is in coordinate system {}; write it in the basic one (CP blank "
                             "or 0)",
                             card.name, is_grid ? " " + shown(card.text(1)) : "", shown(system)));
    }
    if (card.name == "GRDSET") return;
    const std::uint64_t id = id_of(card);
    Vec3 position = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string_view text = card.text(kFirstCoordinate + k);
      if (text.empty()) continue;
      if (!scan_nastran_real(text, position[static_cast<int>(k)])) {
        input_->fail_at(text.data(),
                        fmt::format("'{}' is no coordinate (of GRID {})", shown(text), id));
      }
    }
    ids_.push_back(id);
    places_.push_back(static_cast<std::uint64_t>(card.place - input_->bytes().data()));
    widths_.push_back(widths_of(card));
    points_.push_back(position);
  }

  // ---- everything else -----------------------------------------------------------------------
  void read_other(const NastranCard& card) {
    if (const auto* type = find_row(kElementTypes, card.name)) return read_element(card, *type);
    if (const auto* row = find_row(kHoldingCards, card.name)) {
      for (std::size_t f = row->first; f < card.fields.size() && f <= row->last;
           f += std::max<std::size_t>(row->step, 1)) {
        hold(card.text(f));
      }
    } else if (const auto* list = find_row(kListingCards, card.name)) {
      if (card.name == "RBE2") hold(card.text(2));
      hold_list(card, list->first);
    } else if (card.name == "RBE3") {
      hold_weighted(card);
    } else if (card.name == "MPC") {
      // Each line has a blank or the set's number, then grid, component, factor, twice.
      for (std::size_t f = 2; f < card.fields.size(); f += f % kNarrow == 2 ? 3 : 5) {
        hold(card.text(f));
      }
    }
  }

  void read_element(const NastranCard& card, const ElementType& type) {
    const std::uint64_t id = id_of(card);
    nodes_.clear();
    for (std::size_t i = 0; i < type.nodes; ++i) {
      const std::string_view text = card.text(3 + i);
      if (text.empty() && i >= type.corners) {
        nodes_.push_back(kNoNode);
        continue;
      }
      nodes_.push_back(node(card, text, i, id));
    }
    cells_.add(type.kind, std::span(nodes_).first(type.corners), group_of(card.text(2), id));
    add_followers(type.kind, EdgeOrder::nastran, nodes_, followers_);
    cell_ids_.push_back(id);
    cell_places_.push_back(static_cast<std::uint64_t>(card.place - input_->bytes().data()));
  }

  Index node(const NastranCard& card, std::string_view text, std::size_t i,
             std::uint64_t element) const {
    std::uint64_t id = 0;
    if (!whole_number(text, id)) {
      // An angle may follow the corners of a cell that could have more.
      if (i >= 4 && text.find('.') != std::string_view::npos) return kNoNode;
      fail(card,
           fmt::format("{} {} has '{}' for its grid {}", card.name, element, shown(text), i + 1));
    }
    const Index vertex = numbers_.find(id);
    if (vertex == NodeNumbers::kNone) {
      fail(card,
           fmt::format("{} {} uses GRID {}, which the file does not have", card.name, element, id));
    }
    return vertex;
  }

  /// The property; the element's number where it is left out.
  std::uint32_t group_of(std::string_view text, std::uint64_t element) {
    std::uint64_t property = element;
    whole_number(text, property);
    const auto next = static_cast<std::uint32_t>(names_.size());
    const auto [at, is_new] = groups_.emplace(property, next);
    if (is_new) names_.push_back(fmt::format("property {}", property));
    return at->second;
  }

  void hold(std::string_view text) {
    std::uint64_t id = 0;
    if (!whole_number(text, id)) return;
    const Index vertex = numbers_.find(id);
    if (vertex != NodeNumbers::kNone) held_.push_back(vertex);
  }

  void hold_list(const NastranCard& card, std::size_t first) {
    for (std::size_t f = first; f < card.fields.size(); ++f) {
      std::uint64_t low = 0;
      std::uint64_t high = 0;
      const bool range = f + 2 < card.fields.size() &&
                         equal_but_for_case(card.text(f + 1), "THRU") &&
                         whole_number(card.text(f), low) && whole_number(card.text(f + 2), high);
      if (!range) {
        hold(card.text(f));
        continue;
      }
      ranges_.emplace_back(low, high);
      f += 2;
    }
  }

  /// Ranges may overlap, each with all grids: they are joined before grids are listed.
  void hold_ranges() {
    std::sort(ranges_.begin(), ranges_.end());
    std::vector<Range> joined;
    for (const Range& range : ranges_) {
      if (!joined.empty() && range.first <= joined.back().second) {
        joined.back().second = std::max(joined.back().second, range.second);
      } else {
        joined.push_back(range);
      }
    }
    for (std::size_t v = 0; v < ids_.size() && !joined.empty(); ++v) {
      const auto behind =
          std::upper_bound(joined.begin(), joined.end(), Range{ids_[v], ~std::uint64_t{0}});
      if (behind != joined.begin() && ids_[v] <= std::prev(behind)->second) {
        held_.push_back(static_cast<Index>(v));
      }
    }
  }

  /// The grid that goes with the others, and these: behind each weight come components and grids.
  void hold_weighted(const NastranCard& card) {
    constexpr std::size_t kReference = 3;
    hold(card.text(kReference));
    for (std::size_t f = kReference + 2; f < card.fields.size(); ++f) {
      const std::string_view text = card.text(f);
      if (equal_but_for_case(text, "UM") || equal_but_for_case(text, "ALPHA")) return;
      if (text.find('.') != std::string_view::npos) {
        ++f;  // the components
      } else {
        hold(text);
      }
    }
  }

  MeshFile take_file() {
    MeshFile file;
    if (const auto v = torn_vertex(followers_, cells_, points_.size())) {
      input_->fail_at(places_[*v], torn_message(fmt::format("GRID {}", ids_[*v]), "element"));
    }
    if (cells_.empty()) {
      file.notes.push_back("The deck has grids but no elements that make a surface or a volume.");
    }
    hold_ranges();
    file.held = {std::move(held_), "in loads, supports, rigid and one-dimensional elements"};
    file.group_names = std::move(names_);
    file.followers = std::move(followers_);
    file.mesh = Mesh(std::move(points_), std::move(cells_));
    file.patch =
        std::make_unique<NastranPatch>(input_, std::move(places_), std::move(widths_),
                                       FileNumbers{.vertex = "GRID",
                                                   .cell = "element",
                                                   .vertices = std::move(ids_),
                                                   .cells = std::move(cell_ids_),
                                                   .cell_places = std::move(cell_places_)});
    return file;
  }

  std::shared_ptr<const InputFile> input_;
  const char* bulk_;
  std::vector<Vec3> points_;
  std::vector<std::uint64_t> ids_;
  std::vector<std::uint64_t> places_;
  std::vector<Widths> widths_;
  NodeNumbers numbers_;
  Cells cells_;
  Followers followers_;
  std::vector<std::uint64_t> cell_ids_;
  std::vector<std::uint64_t> cell_places_;
  std::map<std::uint64_t, std::uint32_t> groups_;
  std::vector<std::string> names_{""};
  std::vector<Index> held_;
  using Range = std::pair<std::uint64_t, std::uint64_t>;
  std::vector<Range> ranges_;  // of the numbers of grids that are held
  std::vector<Index> nodes_;   // of the element at hand
};

}  // namespace

MeshFile read_nastran(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
