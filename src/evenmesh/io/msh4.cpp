// SPDX-License-Identifier: MIT
#include "evenmesh/io/msh4.h"

#include <fmt/core.h>

namespace evenmesh {
namespace {

/// No node, and no element, of a text takes less: "1\n0 0 0\n" and "1 1".
constexpr std::size_t kLeastNode = 8;
constexpr std::size_t kLeastElement = 3;

}  // namespace

/// The numbers of one entity may be spread over lines: nothing in them is ever changed.
void Msh4Reader::read_one_entity(int dimension) {
  const auto next = [&] { scanner_.start_record(); };
  next();
  const std::int64_t tag = scanner_.integer("the tag of an entity");
  const int numbers = is_41_ && dimension == 0 ? 3 : 6;
  for (int i = 0; i < numbers; ++i) {
    next();
    scanner_.skip_real("a coordinate of an entity");
  }
  next();
  std::uint64_t count = scanner_.count("the number of an entity's physical groups");
  scanner_.check_room(count, 2, "physical groups");
  std::vector<std::int64_t> physicals;
  for (; count > 0; --count) {
    next();
    const std::int64_t physical = scanner_.integer("the tag of a physical group");
    if (physical != 0) physicals.push_back(physical);
  }
  if (!physicals.empty()) content_.physicals[{dimension, tag}] = std::move(physicals);
  if (dimension == 0) return;
  next();
  count = scanner_.count("the number of an entity's boundaries");
  scanner_.check_room(count, 2, "boundaries");
  for (; count > 0; --count) {
    next();
    scanner_.integer("the tag of a boundary");
  }
}

void Msh4Reader::read_entities() {
  std::uint64_t counts[4];
  for (std::uint64_t& count : counts) {
    scanner_.start_record();
    count = scanner_.count("the number of entities of a dimension");
  }
  for (int dimension = 0; dimension < 4; ++dimension) {
    scanner_.check_room(counts[dimension], 10, "entities");
    for (std::uint64_t i = 0; i < counts[dimension]; ++i) read_one_entity(dimension);
  }
}

Msh4Reader::Entity Msh4Reader::read_entity_of_block() {
  scanner_.start_record();
  const char* const place = scanner_.item();
  const std::int64_t first = scanner_.integer("the entity of a block");
  const std::int64_t second = scanner_.integer("the entity of a block");
  const std::int64_t dimension = is_41_ ? first : second;
  if (dimension < 0 || dimension > 3) {
    scanner_.fail(place,
                  fmt::format("a block's entity has dimension {}; the file is damaged", dimension));
  }
  return {static_cast<int>(dimension), is_41_ ? second : first};
}

std::uint64_t Msh4Reader::read_block_count(std::uint64_t most, std::string_view things) {
  const char* const place = scanner_.item();
  const std::uint64_t count = scanner_.count("the size of a block");
  if (count > most) {
    scanner_.fail(place, fmt::format("a block of {} {} where {} are left; the file is damaged",
                                     count, things, most));
  }
  scanner_.end_record();
  return count;
}

void Msh4Reader::read_node_block(std::uint64_t count) {
  const auto read_tag = [&] { return scanner_.node_tag(is_41_); };
  const auto read_position = [&](std::uint64_t tag) {
    std::uint64_t offset = 0;
    const Vec3 position = scanner_.position(tag, offset);
    content_.nodes.add(tag, position, offset);
    scanner_.end_record();
  };
  if (!is_41_) {
    for (std::uint64_t i = 0; i < count; ++i) {
      scanner_.start_record();
      read_position(read_tag());
    }
    return;
  }
  tags_.clear();
  for (std::uint64_t i = 0; i < count; ++i) {
    scanner_.start_record();
    tags_.push_back(read_tag());
  }
  for (const std::uint64_t tag : tags_) {
    scanner_.start_record();
    read_position(tag);
  }
}

void Msh4Reader::read_nodes() {
  scanner_.start_record();
  std::uint64_t blocks = scanner_.count("the number of blocks of nodes");
  std::uint64_t left = scanner_.count("the number of nodes");
  if (is_41_) {
    scanner_.count("the smallest tag");
    scanner_.count("the largest tag");
  }
  scanner_.end_record();
  scanner_.check_room(left, scanner_.is_binary() ? 28 : kLeastNode, "nodes");
  content_.nodes.reserve(left);
  for (; blocks > 0; --blocks) {
    read_entity_of_block();
    const char* const place = scanner_.item();
    if (scanner_.integer("whether nodes are parametric") != 0) {
      scanner_.fail(place,
                    "nodes have parametric coordinates, which would not fit them any more when "
                    "they move; save the mesh with 'gmsh -setnumber Mesh.SaveParametric 0'");
    }
    const std::uint64_t count = read_block_count(left, "nodes");
    read_node_block(count);
    left -= count;
  }
  if (left > 0) {
    scanner_.fail(
        scanner_.place(),
        fmt::format("the blocks hold {} nodes fewer than the section promises; export the "
                    "mesh again",
                    left));
  }
}

void Msh4Reader::read_element_block(const Entity& entity, const MshElementType& type,
                                    std::uint64_t count) {
  std::uint32_t group = 0;
  if (count > 0) {
    const auto found = content_.physicals.find({entity.dimension, entity.tag});
    const std::span<const std::int64_t> none;
    group = content_.group_number(
        type.dimension, found != content_.physicals.end() ? found->second : none, entity.tag);
  }
  for (; count > 0; --count) {
    scanner_.start_record();
    const char* const start = scanner_.item();
    const std::uint64_t tag = scanner_.element_tag(is_41_);
    content_.read_corners(scanner_, type, is_41_, tag, start, group);
    scanner_.end_record();
  }
}

void Msh4Reader::read_elements() {
  scanner_.start_record();
  std::uint64_t blocks = scanner_.count("the number of blocks of elements");
  std::uint64_t left = scanner_.count("the number of elements");
  if (is_41_) {
    scanner_.count("the smallest tag");
    scanner_.count("the largest tag");
  }
  scanner_.end_record();
  scanner_.check_room(left, kLeastElement, "elements");
  content_.reserve_cells(left);
  for (; blocks > 0; --blocks) {
    const Entity entity = read_entity_of_block();
    const char* const place = scanner_.item();
    const MshElementType type =
        msh_element_type(scanner_, place, scanner_.integer("the type of elements"), std::nullopt);
    const std::uint64_t count = read_block_count(left, "elements");
    read_element_block(entity, type, count);
    left -= count;
  }
  if (left > 0) {
    scanner_.fail(scanner_.place(),
                  fmt::format("the blocks hold {} elements fewer than the section promises; export "
                              "the mesh again",
                              left));
  }
}

}  // namespace evenmesh
