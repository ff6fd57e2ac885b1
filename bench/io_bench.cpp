// SPDX-License-Identifier: MIT
//
// usage: io_bench FILE OUTPUT
// Reads a mesh, moves every vertex, writes it, reads it again and sees that it is the same. Prints
// one JSON object: CPU seconds of each step, beside those of a copy of the file, and memory.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/mesh_file.h"

namespace {

using evenmesh::MeshFile;
using evenmesh::Vec3;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <typename Work>
double timed(const Work& work) {
  const double before = cpu_seconds();
  work();
  return cpu_seconds() - before;
}

/// Mapped pages of the file included.
std::size_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::size_t>(usage.ru_maxrss);
#else
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
#endif
}

void copy(const char* from, const char* to) {
  std::ifstream in(from, std::ios::binary);
  std::ofstream out(to, std::ios::binary);
  out << in.rdbuf();
  if (!out.flush()) throw evenmesh::IoError(std::string(to) + ": cannot be written");
}

void write(const MeshFile& file, const std::vector<Vec3>& points, const char* path) {
  std::ofstream out(path, std::ios::binary);
  file.patch->write(points, [&](std::string_view piece) {
    out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
  });
  if (!out.flush()) throw evenmesh::IoError(std::string(path) + ": cannot be written");
}

bool is_same(const MeshFile& a, const MeshFile& b, const std::vector<Vec3>& points) {
  return std::ranges::equal(a.mesh.cells().corners(), b.mesh.cells().corners()) &&
         b.mesh.point_count() == points.size() &&
         std::memcmp(b.mesh.points().data(), points.data(), points.size() * sizeof(Vec3)) == 0;
}

nlohmann::json measure(const char* path, const char* output) {
  nlohmann::json result;
  result["copy_seconds"] = timed([&] { copy(path, output); });
  MeshFile file;
  result["read_seconds"] = timed([&] { file = evenmesh::read_mesh(path); });
  result["vertices"] = file.mesh.point_count();
  result["file_bytes"] = file.bytes;
  std::vector<Vec3> points(file.mesh.points().begin(), file.mesh.points().end());
  // A move that no number survives with fewer digits.
  for (Vec3& point : points) point += Vec3(1.0, 1.0, 1.0) / 3.0;
  result["round_seconds"] = timed([&] { points = file.representable(points); });
  result["write_seconds"] = timed([&] { write(file, points, output); });
  result["peak_memory_bytes"] = peak_memory();
  const MeshFile again = evenmesh::read_mesh(output);
  if (!is_same(file, again, points)) {
    throw evenmesh::IoError(std::string(output) + ": is not the mesh that was written");
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: io_bench FILE OUTPUT\n", stderr);
    return 2;
  }
  try {
    std::puts(measure(argv[1], argv[2]).dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "io_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
