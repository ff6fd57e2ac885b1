// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/format.h"

namespace evenmesh::testing {

/// Reads a mesh from text as if it were in a file of this name. Patches point into the text, so all
/// texts are kept.
inline MeshFile read_text(std::string_view text, const std::string& name) {
  static std::deque<std::string> kept;
  return read_mesh(InputFile::borrow(kept.emplace_back(text), name));
}

/// The message of the IoError that `read` throws.
template <typename Read>
std::string refusal_by(const Read& read) {
  try {
    read();
  } catch (const IoError& error) {
    return error.what();
  }
  return "was read";
}

/// The message with which the text is refused.
inline std::string refusal_of(std::string_view text, const std::string& name) {
  return refusal_by([&] { read_text(text, name); });
}

/// A text, and how the message behind the name of the file begins.
struct Refusal {
  std::string text, message;
};
inline void expect_refusals(const std::string& name, const std::vector<Refusal>& refusals) {
  for (const auto& [text, message] : refusals) {
    const std::string refusal = refusal_of(text, name);
    EXPECT_TRUE(refusal.starts_with(name + message)) << refusal << "\n  not " << message;
  }
}

inline std::vector<Vec3> points_of(const MeshFile& file) {
  return {file.mesh.points().begin(), file.mesh.points().end()};
}

inline std::vector<Index> cell_of(const MeshFile& file, std::size_t cell) {
  const auto span = file.mesh.cells().vertices(cell);
  return {span.begin(), span.end()};
}

/// The vertices of the set, sorted, each once; a set that is not there is empty.
inline std::vector<Index> set_of(const MeshFile& file, std::string_view kind,
                                 std::string_view name) {
  std::vector<Index> vertices;
  for (const NamedSet& set : file.sets) {
    if (set.kind == kind && set.name == name) vertices = set.vertices(file.mesh.cells());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Reads every beginning of a text, or refuses it: a reader may not read behind its end.
/// @return  how many are read
inline int readable_beginnings(std::string_view text, const std::string& name) {
  int readable = 0;
  for (std::size_t length = 1; length <= text.size(); ++length) {
    // A copy of its own, so that the sanitizer sees a byte read too far.
    const std::vector<char> bytes(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
    try {
      read_mesh(InputFile::borrow({bytes.data(), bytes.size()}, name));
      ++readable;
    } catch (const IoError&) {
    }
  }
  return readable;
}

}  // namespace evenmesh::testing
