// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/io/mesh_file.h"
#include "evenmesh/io/msh_scanner.h"
#include "evenmesh/io/node_numbers.h"
#include "evenmesh/mesh/followers.h"
#include "evenmesh/mesh/mesh.h"

namespace evenmesh {

/// The nodes of a Gmsh file in its order. Their tags may have gaps and come in any order.
class MshNodes {
 public:
  /// @param offset  where the node's coordinates begin in the file
  void add(std::uint64_t tag, const Vec3& position, std::uint64_t offset);
  void reserve(std::size_t nodes);

  /// Makes find() ready. To be called once, behind the last node.
  /// @throws IoError  two nodes have one tag, or there are too many
  void finish(const MshScanner& scanner);

  /// @return  the vertex with this tag, or kNoVertex
  Index find(std::uint64_t tag) const { return numbers_.find(tag); }
  static constexpr Index kNoVertex = NodeNumbers::kNone;

  bool is_finished() const { return finished_; }
  /// Whether the tags are 1, 2, 3 ...
  bool counts_from_one() const { return numbers_.counts_from_one(); }

  std::vector<Vec3> points;
  std::vector<std::uint64_t> tags;
  std::vector<std::uint64_t> offsets;

 private:
  bool finished_ = false;
  NodeNumbers numbers_;
};

/// The groups of a Gmsh file. A cell is in the combination of physical groups that it or its
/// entity belongs to, and without one in its entity.
class MshGroups {
 public:
  void set_name(int dimension, std::int64_t physical, std::string_view name);

  /// A physical group of a file, and the groups of this list that it has a part in.
  struct Physical {
    int dimension;
    std::string name;                   // its number where it has none
    std::vector<std::uint32_t> groups;  // sorted
  };
  std::vector<Physical> physicals() const;

  /// The number of the group of cells that are in these physical groups and this entity, where 0
  /// is none. The sign of a physical group's tag, which says how the elements are wound, is no
  /// part of it.
  std::uint32_t number(int dimension, std::span<const std::int64_t> physicals, std::int64_t entity);

  /// [number], "physical steel", "physical 7", "entity 5"; entry 0 is "no group".
  /// @throws IoError  they are far longer together than the file
  std::vector<std::string> names(const InputFile& input) const;

 private:
  bool is_latest(int dimension, std::span<const std::int64_t> physicals, std::int64_t entity) const;

  using Key = std::vector<std::int64_t>;  // dimension, entity or 0, physical groups
  std::map<std::pair<int, std::int64_t>, std::string> names_;
  std::map<Key, std::uint32_t> numbers_;
  Key latest_;
  std::uint32_t latest_number_ = 0;
};

/// What is to be known of elements of one type.
struct MshElementType {
  CellKind kind = CellKind::triangle;  // where it makes a cell
  int dimension = 0;
  std::size_t nodes = 1;
  bool makes_cell() const { return dimension >= 2; }
};

/// @param tag  of the element, for the message; none: a block of elements
/// @throws IoError  the type is not read, for example one of third order
MshElementType msh_element_type(const MshScanner& scanner, const char* place, std::int64_t type,
                                std::optional<std::uint64_t> tag);

/// Points and lines of a Gmsh file, which make no cells, with their groups among MshContent's
/// side_groups.
struct MshSides {
  std::vector<Index> points;
  std::vector<std::uint32_t> point_groups;
  std::vector<Index> lines;  // pairs
  std::vector<std::uint32_t> line_groups;
};

/// Everything that is taken out of a Gmsh file.
struct MshContent {
  MshNodes nodes;
  MshGroups groups;       // of cells
  MshGroups side_groups;  // of points and lines: physical groups only
  MshSides sides;
  Cells cells;
  Followers followers;
  std::vector<std::uint64_t> cell_offsets;  // where the cell's tag stands in the file
  std::map<std::pair<int, std::int64_t>, std::vector<std::int64_t>> physicals;  // by entity

  /// @pre  the file has room for so many elements
  void reserve_cells(std::size_t elements);

  /// The group of elements of a dimension, in the one list or the other.
  std::uint32_t group_number(int dimension, std::span<const std::int64_t> of_element,
                             std::int64_t entity);

  /// Reads the nodes of an element from the place that the scanner is at, and adds its cell or
  /// side.
  /// @param place  where its tag stands
  void read_corners(MshScanner& scanner, const MshElementType& type, bool wide, std::uint64_t tag,
                    const char* place, std::uint32_t group);

  /// Adds what the file calls by name to its sets, and finds the vertices that these hold.
  /// @pre  the groups of the file have their names
  void add_sets(MeshFile& file);

 private:
  void add_surface_sets(MeshFile& file) const;
  void hold_sides(const MshSides& all, bool volume, MeshFile& file) const;

  std::vector<Index> corners_;
};

}  // namespace evenmesh
