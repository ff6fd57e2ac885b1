// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/io/mesh_file.h"

namespace evenmesh::testing {

/// A second opinion on what a writer may change. It knows the formats only as far as needed to say
/// where coordinates stand, and shares no code with the readers.
/// @return  what else differs; empty if nothing does
inline std::string difference_beside_coordinates(const MeshFile& file, Points points,
                                                 std::string_view before, std::string_view after);

namespace internal {

struct Piece {
  std::string_view gap, word;
};

inline Piece take_piece(std::string_view& text) {
  constexpr std::string_view kSpaces = " \t\r\n\v\f";
  const std::size_t begin = std::min(text.find_first_not_of(kSpaces), text.size());
  const std::size_t end = std::min(text.find_first_of(kSpaces, begin), text.size());
  const Piece piece{text.substr(0, begin), text.substr(begin, end - begin)};
  text.remove_prefix(end);
  return piece;
}

inline bool has_moved(const MeshFile& file, Points points, Index vertex) {
  return std::memcmp(&points[vertex], &file.mesh.points()[vertex], sizeof(Vec3)) != 0;
}

inline bool facet_has_moved(const MeshFile& file, Points points, std::size_t facet) {
  bool moved = false;
  for (const Index v : file.mesh.cells().vertices(facet)) moved |= has_moved(file, points, v);
  return moved;
}

/// Walks both texts word by word. free_words(line_start, word) says how many of the words that
/// follow may differ.
inline std::string compare_words(
    std::string_view before, std::string_view after,
    const std::function<int(bool line_start, std::string_view word)>& free_words) {
  int free = 0;
  bool continued = false;
  bool comment = false;
  bool first = true;
  while (!before.empty() || !after.empty()) {
    const Piece a = take_piece(before);
    const Piece b = take_piece(after);
    if (a.gap != b.gap) return "white space before '" + std::string(a.word) + "'";
    const bool new_line = first || a.gap.find_first_of("\r\n") != std::string_view::npos;
    const bool line_start = new_line && !continued;
    first = false;
    if (line_start) comment = false;
    comment = comment || a.word.starts_with('#');
    continued = a.word == "\\" && !comment;
    if (continued || comment) {
      if (a.word != b.word) return "'" + std::string(a.word) + "'";
      continue;
    }
    if (line_start && free > 0) return "a line with too few words";
    if (free > 0) {
      --free;
    } else {
      if (a.word != b.word) return "'" + std::string(a.word) + "'";
      free = free_words(line_start, a.word);
    }
  }
  return "";
}

inline std::string compare_obj(const MeshFile& file, Points points, std::string_view before,
                               std::string_view after) {
  Index vertex = 0;
  if (before.starts_with("\xEF\xBB\xBF") && after.starts_with("\xEF\xBB\xBF")) {
    before.remove_prefix(3);
    after.remove_prefix(3);
  }
  return compare_words(before, after, [&](bool line_start, std::string_view word) {
    if (!line_start || word != "v") return 0;
    return has_moved(file, points, vertex++) ? 3 : 0;
  });
}

inline std::string compare_stl_ascii(const MeshFile& file, Points points, std::string_view before,
                                     std::string_view after) {
  std::size_t corner = 0;
  bool in_facet = false;
  return compare_words(before, after, [&](bool line_start, std::string_view word) {
    const bool is_facet = line_start && (word == "facet" || word == "FACET");
    if (is_facet) in_facet = true;
    if (line_start && !is_facet && (word == "endsolid" || word == "ENDSOLID")) in_facet = false;
    if (!in_facet) return 0;
    if (word == "normal" || word == "NORMAL") {
      return facet_has_moved(file, points, corner / 3) ? 3 : 0;
    }
    if (word != "vertex" && word != "VERTEX") return 0;
    return has_moved(file, points, file.mesh.cells().corners()[corner++]) ? 3 : 0;
  });
}

inline std::string compare_stl_binary(const MeshFile& file, Points points, std::string_view before,
                                      std::string_view after) {
  if (before.size() != after.size()) return "the size";
  const std::size_t facets = file.mesh.cells().size();
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == after[i]) continue;
    const std::size_t facet = (i - 84) / 50;
    const std::size_t within = (i - 84) % 50;
    if (i < 84 || facet >= facets || within >= 48) return "byte " + std::to_string(i);
    const bool normal = within < 12;
    if (normal ? !facet_has_moved(file, points, facet)
               : !has_moved(file, points, file.mesh.cells().vertices(facet)[(within - 12) / 12])) {
      return "byte " + std::to_string(i) + " of what did not move";
    }
  }
  return "";
}

/// The text up to and with the end of its line.
inline std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end == text.npos ? end : end + 1);
  text.remove_prefix(line.size());
  return line;
}

inline std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (Piece piece = take_piece(line); !piece.word.empty(); piece = take_piece(line)) {
    words.push_back(piece.word);
  }
  return words;
}

/// Text only. Coordinates are the last three of four numbers in $Nodes of version 2, and three that
/// stand alone in that of version 4.1; in 4.0 four numbers are a block's beginning or a node.
inline std::string compare_msh(const MeshFile& file, Points points, std::string_view before,
                               std::string_view after) {
  Index vertex = 0;
  std::string version;
  bool in_nodes = false;
  int left_in_block = 0;  // version 4.0
  while (!before.empty() && !after.empty()) {
    const std::string_view a = take_line(before);
    const std::string_view b = take_line(after);
    const auto words = words_of(a);
    const auto others = words_of(b);
    if (version.empty() && words.size() == 3) version = words[0];
    if (!words.empty() && words[0] == "$Nodes") in_nodes = true;
    if (!words.empty() && words[0] == "$EndNodes") in_nodes = false;
    bool node = in_nodes && words.size() == (version == "4.1" ? 3u : 4u);
    if (node && version.starts_with("4") && version != "4.1" && left_in_block-- == 0) {
      node = false;
      left_in_block = std::stoi(std::string(words[3]));
    }
    const bool may_differ = node && has_moved(file, points, vertex++);
    if (a == b) continue;
    if (!may_differ || words.size() != others.size()) return "'" + std::string(a) + "'";
    if (words.size() == 4 && words[0] != others[0]) return "a tag";
  }
  if (before.size() != after.size()) return "the number of lines";
  return vertex == points.size() ? "" : "the number of nodes";
}

}  // namespace internal

inline std::string difference_beside_coordinates(const MeshFile& file, Points points,
                                                 std::string_view before, std::string_view after) {
  if (file.patch->format() == "obj") return internal::compare_obj(file, points, before, after);
  if (file.patch->format() == "stl_ascii") {
    return internal::compare_stl_ascii(file, points, before, after);
  }
  if (file.patch->format() == "msh") return internal::compare_msh(file, points, before, after);
  return internal::compare_stl_binary(file, points, before, after);
}

/// What the patch writes.
inline std::string written(const MeshFile& file, Points points) {
  std::string text;
  file.patch->write(points, [&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace evenmesh::testing
