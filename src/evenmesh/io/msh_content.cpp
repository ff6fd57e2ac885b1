// SPDX-License-Identifier: MIT
#include "evenmesh/io/msh_content.h"

#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "evenmesh/io/second_order.h"
#include "evenmesh/io/side_labels.h"

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

/// How many things each group has.
std::vector<std::size_t> count_in_groups(std::span<const std::uint32_t> group_of) {
  std::vector<std::size_t> sizes;
  for (const std::uint32_t group : group_of) {
    if (group >= sizes.size()) sizes.resize(std::size_t{group} + 1, 0);
    ++sizes[group];
  }
  return sizes;
}

std::size_t members_of(const MshGroups::Physical& physical, std::span<const std::size_t> sizes) {
  std::size_t members = 0;
  for (const std::uint32_t group : physical.groups)
    members += group < sizes.size() ? sizes[group] : 0;
  return members;
}

/// Those of the points or lines in some groups, which are sorted.
std::vector<Index> vertices_of_sides(const MshSides& sides,
                                     const std::vector<std::uint32_t>& groups, bool points) {
  const auto& group_of = points ? sides.point_groups : sides.line_groups;
  std::vector<Index> vertices;
  for (std::size_t i = 0; i < group_of.size(); ++i) {
    if (!std::ranges::binary_search(groups, group_of[i])) continue;
    if (points) {
      vertices.push_back(sides.points[i]);
    } else {
      vertices.insert(vertices.end(), {sides.lines[2 * i], sides.lines[2 * i + 1]});
    }
  }
  return vertices;
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

std::vector<MshGroups::Physical> MshGroups::physicals() const {
  std::map<std::pair<int, std::int64_t>, std::vector<std::uint32_t>> found;
  for (const auto& [key, number] : numbers_) {
    for (std::size_t i = 2; i < key.size(); ++i) {
      found[{static_cast<int>(key[0]), key[i]}].push_back(number);
    }
  }
  std::vector<Physical> result;
  for (auto& [tag, groups] : found) {
    std::sort(groups.begin(), groups.end());
    const auto named = names_.find(tag);
    const bool has_name = named != names_.end() && !named->second.empty();
    result.push_back(
        {tag.first, has_name ? named->second : std::to_string(tag.second), std::move(groups)});
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

std::uint32_t MshContent::group_number(int dimension, std::span<const std::int64_t> of_element,
                                       std::int64_t entity) {
  if (dimension >= 2) return groups.number(dimension, of_element, entity);
  return side_groups.number(dimension, of_element, 0);
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
  if (type.dimension == 0) {
    sides.points.push_back(corners_[0]);
    sides.point_groups.push_back(group);
  } else if (type.dimension == 1) {
    sides.lines.insert(sides.lines.end(), {corners_[0], corners_[1]});
    sides.line_groups.push_back(group);
  }
  if (!type.makes_cell()) return;
  const auto linear = static_cast<std::size_t>(traits(type.kind).vertices);
  cells.add(type.kind, std::span(corners_).first(linear), group);
  add_followers(type.kind, EdgeOrder::gmsh, corners_, followers);
  cell_offsets.push_back(scanner.offset(place));
}

void MshContent::add_sets(MeshFile& file) {
  const auto shared = std::make_shared<const MshSides>(std::move(sides));
  const bool volume =
      std::ranges::any_of(cells.kinds(), [](CellKind kind) { return traits(kind).dimension == 3; });
  for (const int dimension : {0, 1}) {
    const bool points = dimension == 0;
    const auto sizes = count_in_groups(points ? shared->point_groups : shared->line_groups);
    for (const MshGroups::Physical& physical : side_groups.physicals()) {
      if (physical.dimension != dimension) continue;
      file.sets.push_back({.kind = points ? "nset" : "marker",
                           .name = physical.name,
                           .members = members_of(physical, sizes),
                           .unit = points ? "vertices" : "sides",
                           .vertices = [shared, groups = physical.groups, points](const Cells&) {
                             return vertices_of_sides(*shared, groups, points);
                           }});
    }
  }
  if (volume) add_surface_sets(file);
  hold_sides(*shared, volume, file);
}

/// Surface elements of a volume mesh are cells, and their physical groups markers as well.
void MshContent::add_surface_sets(MeshFile& file) const {
  std::vector<std::uint32_t> group_of(cells.size());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) group_of[cell] = cells.group(cell);
  const std::vector<std::size_t> sizes = count_in_groups(group_of);
  for (const MshGroups::Physical& physical : groups.physicals()) {
    if (physical.dimension != 2) continue;
    file.sets.push_back({.kind = "marker",
                         .name = physical.name,
                         .members = members_of(physical, sizes),
                         .unit = "sides",
                         .vertices = [wanted = physical.groups](const Cells& all) {
                           std::vector<Index> vertices;
                           for (std::size_t cell = 0; cell < all.size(); ++cell) {
                             if (!std::ranges::binary_search(wanted, all.group(cell))) continue;
                             const auto corners = all.vertices(cell);
                             vertices.insert(vertices.end(), corners.begin(), corners.end());
                           }
                           return vertices;
                         }});
  }
}

/// Boundary conditions belong to physical groups: their rims stay, and in a volume the lines and
/// points that have a name.
void MshContent::hold_sides(const MshSides& all, bool volume, MeshFile& file) const {
  SideLabels labels;
  std::vector<Index> held;
  if (volume) {
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      const std::uint32_t group = cells.group(cell);
      if (traits(cells.kind(cell)).dimension == 2 &&
          file.group_names[group].starts_with("physical")) {
        labels.add(cells.vertices(cell), group);
      }
    }
  } else {
    held = on_lines_within(cells, all.lines);
  }
  for (std::size_t i = 0; i < all.line_groups.size(); ++i) {
    if (all.line_groups[i] == 0) continue;
    const auto ends = std::span(all.lines).subspan(2 * i, 2);
    if (volume) {
      held.insert(held.end(), ends.begin(), ends.end());
    } else {
      labels.add(ends, all.line_groups[i]);
    }
  }
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    if (all.point_groups[i] != 0) held.push_back(all.points[i]);
  }
  const std::vector<Index> rims = labels.rims();
  held.insert(held.end(), rims.begin(), rims.end());
  file.held = {std::move(held), "on points and lines of the file, or at the rims of its groups"};
}

}  // namespace evenmesh
