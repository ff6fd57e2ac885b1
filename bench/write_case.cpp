// SPDX-License-Identifier: MIT
//
// usage: write_case CASE VERTICES FILE.obj
// Writes a mesh of the benchmarks as an OBJ file, all digits that a double has.
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>

#include "bench/support/case.h"
#include "evenmesh/base/error.h"

namespace {

using evenmesh::Mesh;

template <typename Number>
void append(std::string& text, Number value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.push_back(' ');
  text.append(digits.data(), end);
}

std::string obj_text(const Mesh& mesh) {
  std::string text;
  for (const evenmesh::Vec3& point : mesh.points()) {
    text += 'v';
    for (const double coordinate : point) append(text, coordinate);
    text += '\n';
  }
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    text += 'f';
    for (const evenmesh::Index v : mesh.cells().vertices(c)) append(text, v + 1);
    text += '\n';
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: write_case CASE VERTICES FILE.obj\n", stderr);
    return 2;
  }
  try {
    std::ofstream file(argv[3], std::ios::binary);
    file << obj_text(evenmesh::bench::make_case_mesh(argv[1], std::strtoull(argv[2], nullptr, 10)));
    if (!file.flush()) throw evenmesh::IoError(std::string(argv[3]) + ": cannot be written");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_case: %s\n", error.what());
    return 1;
  }
  return 0;
}
