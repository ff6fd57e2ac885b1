// SPDX-License-Identifier: MIT
#include "evenmesh/io/msh_content.h"

#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "evenmesh/io/second_order.h"

namespace evenmesh {
namespace {

/// The names of all groups may be so many times longer than the file. No honest file comes near.
constexpr std::size_t kNameRatio = 32;

constexpr std::uint32_t kPoint = 15;
constexpr std::uint32_t kLine = 1;

std::int64_t without_sign(std::int64_t tag) { return tag < 0 ? -tag : tag; }

/// The types of third to fifth order, in ranges.
bool is_of_higher_order(std::int64_t type) {
  return (type >= 20 && type <= 62) || (type >= 71 && type <= 93) || type == 96 || type == 97;
}

std::optional<MshElementType> known_type(std::int64_t type) {
  switch (type) {
    case kLine:
      return MshElementType{.dimension = 1, .nodes = 2};
    case 2:
      return MshElementType{CellKind::triangle, 2, 3};
    case 3:
      return MshElementType{CellKind::quad, 2, 4};
    case 4:
      return MshElementType{CellKind::tet, 3, 4};
    case 5:
      return MshElementType{CellKind::hex, 3, 8};
    case 6:
      return MshElementType{CellKind::wedge, 3, 6};
    case 7:
      return MshElementType{CellKind::pyramid, 3, 5};
    case 8:
      return MshElementType{.dimension = 1, .nodes = 3};
    case 9:
      return MshElementType{CellKind::triangle, 2, 6};
    case 10:
      return MshElementType{CellKind::quad, 2, 9};
    case 11:
      return MshElementType{CellKind::tet, 3, 10};
    case 12:
      return MshElementType{CellKind::hex, 3, 27};
    case 13:
      return MshElementType{CellKind::wedge, 3, 18};
    case 14:
      return MshElementType{CellKind::pyramid, 3, 14};
    case 16:
      return MshElementType{CellKind::quad, 2, 8};
    case 17:
      return MshElementType{CellKind::hex, 3, 20};
    case 18:
      return MshElementType{CellKind::wedge, 3, 15};
    case 19:
      return MshElementType{CellKind::pyramid, 3, 13};
    case kPoint:
      return MshElementType{.dimension = 0, .nodes = 1};
    default:
      return std::nullopt;
  }
}

}  // namespace

void MshNodes::add(std::uint64_t tag, const Vec3& position, std::uint64_t offset) {
  points.push_back(position);
  tags.push_back(tag);
  offsets.push_back(offset);
}

void MshNodes::reserve(std::size_t nodes) {
  points.reserve(nodes);
  tags.reserve(nodes);
  offsets.reserve(nodes);
}

void MshNodes::finish(const MshScanner& scanner) {
  finished_ = true;
  if (tags.empty()) return;
  if (tags.size() >= std::numeric_limits<Index>::max()) {
    scanner.input().fail("has more nodes than 32-bit numbers can count");
  }
  const std::size_t twice = numbers_.index(tags);
  if (twice == tags.size()) return;
  scanner.fail(offsets[twice],
               fmt::format("node {} is there twice; number the nodes anew", tags[twice]));
}

void MshGroups::set_name(int dimension, std::int64_t physical, std::string_view name) {
  names_[{dimension, physical}] = name;
}

/// Cells of one group mostly come one after the other, and this makes no key.
bool MshGroups::is_latest(int dimension, std::span<const std::int64_t> physicals,
                          std::int64_t entity) const {
  return latest_.size() == 2 + physicals.size() && latest_[0] == dimension &&
         latest_[1] == (physicals.empty() ? entity : 0) &&
         std::equal(physicals.begin(), physicals.end(), latest_.begin() + 2,
                    [](std::int64_t a, std::int64_t b) { return without_sign(a) == b; });
}

std::uint32_t MshGroups::number(int dimension, std::span<const std::int64_t> physicals,
                                std::int64_t entity) {
  if (physicals.empty() && entity == 0) return 0;
  if (is_latest(dimension, physicals, entity)) return latest_number_;
  Key key{dimension, physicals.empty() ? entity : 0};
  for (const std::int64_t tag : physicals) key.push_back(without_sign(tag));
  const auto next = static_cast<std::uint32_t>(numbers_.size() + 1);
  latest_number_ = numbers_.emplace(key, next).first->second;
  latest_ = std::move(key);
  return latest_number_;
}

std::vector<std::string> MshGroups::names(const InputFile& input) const {
  std::vector<std::string> result(numbers_.size() + 1);
  std::size_t bytes = 0;
  for (const auto& [key, number] : numbers_) {
    std::string& text = result[number];
    if (key.size() == 2) text = fmt::format("entity {}", key[1]);
    for (std::size_t i = 2; i < key.size(); ++i) {
      if (i > 2) text += ", ";
      const auto named = names_.find({static_cast<int>(key[0]), key[i]});
      const bool has_name = named != names_.end() && !named->second.empty();
      text += has_name ? "physical " + named->second : fmt::format("physical {}", key[i]);
    }
    bytes += text.size();
    if (bytes > kNameRatio * input.bytes().size()) {
      input.fail(
          "the names of the physical groups are too long for so many combinations of them; "
          "shorten them");
    }
  }
  return result;
}

MshElementType msh_element_type(const MshScanner& scanner, const char* place, std::int64_t type,
                                std::optional<std::uint64_t> tag) {
  if (const auto known = known_type(type)) return *known;
  const std::string who = tag ? fmt::format("element {}", *tag) : "a block of elements";
  if (is_of_higher_order(type)) {
    scanner.fail(place, fmt::format("{} is of third order or higher (type {}), which evenmesh does "
                                    "not read; save the mesh with 'gmsh -order 2' or less",
                                    who, type));
  }
  scanner.fail(place,
               fmt::format("{} has type {}; evenmesh reads points, lines, triangles, quads, tets, "
                           "hexes, wedges and pyramids of first and second order (1 to 19). Save "
                           "the mesh with 'gmsh -order 1'",
                           who, type));
}

void MshContent::reserve_cells(std::size_t elements) {
  constexpr std::size_t kCorners = 4;  // no more than a guess; pages that stay empty cost nothing
  cells.reserve(elements, kCorners * elements);
  cell_offsets.reserve(elements);
}

void MshContent::read_corners(MshScanner& scanner, const MshElementType& type, bool wide,
                              std::uint64_t tag, const char* place, std::uint32_t group) {
  corners_.clear();
  for (std::size_t i = 0; i < type.nodes; ++i) {
    const char* const at = scanner.item();
    const std::uint64_t node = scanner.node_tag(wide);
    const Index vertex = nodes.find(node);
    if (vertex == MshNodes::kNoVertex) {
      scanner.fail(at,
                   fmt::format("element {} uses node {}, which the file does not have", tag, node));
    }
    corners_.push_back(vertex);
  }
  if (!type.makes_cell()) return;
  const auto linear = static_cast<std::size_t>(traits(type.kind).vertices);
  cells.add(type.kind, std::span(corners_).first(linear), group);
  add_followers(type.kind, EdgeOrder::gmsh, corners_, followers);
  cell_offsets.push_back(scanner.offset(place));
}

}  // namespace evenmesh
