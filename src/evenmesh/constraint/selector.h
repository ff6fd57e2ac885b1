// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/data_array.h"
#include "evenmesh/mesh/followers.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/named_sets.h"
#include "evenmesh/mesh/topology.h"

namespace evenmesh {

/// What a file calls its vertices, groups and sets.
struct FileNames {
  std::uint64_t first_id = 1;  // of its first vertex (1 for OBJ, 0 for SU2), if they are counted
  std::span<const std::uint64_t> ids = {};   // of each vertex; empty: they are counted
  std::span<const std::string> groups = {};  // by group number of a cell; entry 0 is "no group"
  std::span<const NamedSet> sets = {};
  std::span<const DataArray> arrays = {};
  const Followers* followers = nullptr;  // nodes of second-order cells that are no corners
};

/// The groups that a name stands for, as one flag per group number. A file may put several names
/// into one ("o part, g left, usemtl steel"): all, one of them ("g left") and its last word or
/// words
/// ("left") will do.
/// @throws InvalidOption  there is none; the message has near names, or those that there are.
std::vector<char> find_groups(std::span<const std::string> groups, std::string_view name);

/// The vertices that a selector names.
///
///   selector = term { ("+" | "-" | "&") term }          read from left to right
///   term     = "all" | "none" | "boundary" | "features" | "corners" | "interface"
///            | "non_manifold" | "id:1,5-9" | "box:x0,y0,z0,x1,y1,z1"
///            | "group:NAME" | "nset:NAME" | "elset:NAME" | "marker:NAME"
///            | "array:NAME" ("==" | "!=" | "<" | "<=" | ">" | ">=") number
///
/// `+` joins, `-` takes away, `&` keeps what both have; spaces are ignored around terms. `features`
/// includes non-manifold edges, which no smooth surface has. Vertex numbers in `id:` are those of
/// the file; a minus between two numbers makes a range, which may have gaps, any other takes away.
/// A node in the middle of an edge stands for the corners around it, for it goes where they go. A
/// box includes its faces, and its numbers may be infinite (inf). `group:` selects the vertices of
/// the cells of find_groups(), the others those of a set of that kind, in upper or lower case; of
/// several names that fit the longest counts, and quotation marks ('a b' or "a b") say where a name
/// ends. `array:` selects the vertices whose number in an array of the file compares so, or those
/// of the cells whose number does; "point.NAME" and "cell.NAME" tell arrays of one name apart.
/// @return  one flag per vertex
/// @throws InvalidOption  the text does not parse (the message shows where and what is known), or
///                        an id, a group, a set or an array is not in the file.
/// @throws IoError        an array of the file is broken
std::vector<char> select_vertices(std::string_view text, const Mesh& mesh, const Topology& topology,
                                  const FileNames& names = {});

}  // namespace evenmesh
