// SPDX-License-Identifier: MIT
#include "evenmesh/io/msh2.h"

#include <array>

#include <fmt/core.h>

namespace evenmesh {
namespace {

constexpr bool kWide = false;          // tags have 4 bytes
constexpr std::size_t kLeastNode = 8;  // "1 0 0 0\n"
constexpr std::size_t kBinaryNode = 4 + 3 * 8;
constexpr std::size_t kLeastElement = 8;  // "1 15 0 1"

/// The counts of version 2 are text, binary file or not.
std::uint64_t read_count(MshScanner& scanner, std::string_view what) {
  scanner.start_line();
  const char* const place = scanner.place();
  const std::int64_t count = scanner.text_integer(what);
  if (count < 0) scanner.fail(place, fmt::format("{} is negative", what));
  scanner.end_line();
  return static_cast<std::uint64_t>(count);
}

/// Reads the tags of an element: its physical group, its entity, and others that mean nothing here.
std::uint32_t read_group(MshScanner& scanner, std::int64_t tags, int dimension,
                         MshContent& content) {
  std::array<std::int64_t, 2> first{};
  for (std::int64_t i = 0; i < tags; ++i) {
    const std::int64_t tag = scanner.integer("a tag of the element");
    if (i < 2) first[static_cast<std::size_t>(i)] = tag;
  }
  const std::span<const std::int64_t> physicals(first.data(), first[0] != 0 ? 1 : 0);
  return content.group_number(dimension, physicals, first[1]);
}

std::int64_t read_tag_count(MshScanner& scanner) {
  const char* const place = scanner.item();
  const std::int64_t tags = scanner.integer("the number of tags");
  if (tags < 0) scanner.fail(place, "the number of tags is negative");
  return tags;
}

void read_line(MshScanner& scanner, MshContent& content) {
  scanner.start_record();
  const char* const start = scanner.item();
  const std::uint64_t tag = scanner.element_tag(kWide);
  const char* const place = scanner.item();
  const MshElementType type = msh_element_type(scanner, place, scanner.integer("the type"), tag);
  const std::int64_t tags = read_tag_count(scanner);
  const std::uint32_t group = read_group(scanner, tags, type.dimension, content);
  content.read_corners(scanner, type, kWide, tag, start, group);
  scanner.end_record();
}

/// Reads elements of one type with one number of tags.
/// @return  how many
std::uint64_t read_block(MshScanner& scanner, std::uint64_t most, MshContent& content) {
  const char* const place = scanner.item();
  const std::int64_t type_number = scanner.integer("the type of elements");
  const char* const count_place = scanner.item();
  const std::int64_t count = scanner.integer("the number of elements of a type");
  const std::int64_t tags = read_tag_count(scanner);
  const MshElementType type = msh_element_type(scanner, place, type_number, std::nullopt);
  if (count <= 0 || static_cast<std::uint64_t>(count) > most) {
    scanner.fail(
        count_place,
        fmt::format("a block of {} elements where {} are left; the file is damaged", count, most));
  }
  const std::size_t bytes = 4 * (1 + static_cast<std::size_t>(tags) + type.nodes);
  scanner.check_room(static_cast<std::uint64_t>(count), bytes, "elements");
  for (std::int64_t i = 0; i < count; ++i) {
    const char* const start = scanner.item();
    const std::uint64_t tag = scanner.element_tag(kWide);
    const std::uint32_t group = read_group(scanner, tags, type.dimension, content);
    content.read_corners(scanner, type, kWide, tag, start, group);
  }
  return static_cast<std::uint64_t>(count);
}

}  // namespace

void read_msh2_nodes(MshScanner& scanner, MshContent& content) {
  const std::uint64_t count = read_count(scanner, "the number of nodes");
  scanner.check_room(count, scanner.is_binary() ? kBinaryNode : kLeastNode, "nodes");
  content.nodes.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    scanner.start_record();
    const std::uint64_t tag = scanner.node_tag(kWide);
    std::uint64_t offset = 0;
    const Vec3 position = scanner.position(tag, offset);
    content.nodes.add(tag, position, offset);
    scanner.end_record();
  }
}

void read_msh2_elements(MshScanner& scanner, MshContent& content) {
  std::uint64_t left = read_count(scanner, "the number of elements");
  scanner.check_room(left, kLeastElement, "elements");
  content.reserve_cells(left);
  while (left > 0) {
    if (scanner.is_binary()) {
      left -= read_block(scanner, left, content);
    } else {
      read_line(scanner, content);
      --left;
    }
  }
}

}  // namespace evenmesh
