// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/io/msh_content.h"
#include "evenmesh/io/msh_scanner.h"

namespace evenmesh {

/// Reads the sections of a Gmsh file of version 4, text or binary.
///
/// In 4.1 the tags of nodes and elements have 8 bytes, a block lists all its tags before the
/// coordinates, and a point has no box. In 4.0 they have 4, stand before each node's coordinates,
/// and a block names its entity before the dimension.
class Msh4Reader {
 public:
  /// @param is_41  version 4.1, else 4.0
  Msh4Reader(MshScanner& scanner, MshContent& content, bool is_41)
      : scanner_(scanner), content_(content), is_41_(is_41) {}

  /// @throws IoError  see read_mesh()
  void read_entities();
  void read_nodes();
  void read_elements();

 private:
  struct Entity {
    int dimension;
    std::int64_t tag;
  };
  Entity read_entity_of_block();
  void read_one_entity(int dimension);
  std::uint64_t read_block_count(std::uint64_t most, std::string_view things);
  void read_node_block(std::uint64_t count);
  void read_element_block(const Entity& entity, const MshElementType& type, std::uint64_t count);

  MshScanner& scanner_;
  MshContent& content_;
  bool is_41_;
  std::vector<std::uint64_t> tags_;  // of the nodes of the block at hand
};

}  // namespace evenmesh
