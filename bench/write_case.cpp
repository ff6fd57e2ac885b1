// SPDX-License-Identifier: MIT
//
// usage: write_case CASE VERTICES FILE
// Writes a mesh of the benchmarks with all digits that a double has. The suffix says the format:
// .obj, .msh (4.1), .inp, .bdf and .mesh are text, .mshb (MSH 4.1), .vtk, .vtu, .ply, .stl and
// .meshb are binary.
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "bench/support/case.h"
#include "evenmesh/base/error.h"
#include "evenmesh/io/nastran_cards.h"

namespace {

using evenmesh::CellKind;
using evenmesh::Index;
using evenmesh::Mesh;
using evenmesh::Vec3;

static_assert(std::endian::native == std::endian::little);

/// A file that grows.
class Text {
 public:
  Text& operator<<(std::string_view text) {
    bytes_ += text;
    return *this;
  }
  template <typename Number>
  requires std::is_arithmetic_v<Number> Text& operator<<(Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    bytes_.append(digits.data(), end);
    return *this;
  }
  template <typename Number>
  Text& raw(Number value) {
    std::array<char, sizeof(Number)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof value);
    bytes_.append(bytes.data(), bytes.size());
    return *this;
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

bool is_triangle(const Mesh& mesh, std::size_t cell) {
  return mesh.cells().kind(cell) == CellKind::triangle;
}

std::size_t count_triangles(const Mesh& mesh) {
  std::size_t count = 0;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) count += is_triangle(mesh, c) ? 1 : 0;
  return count;
}

/// Visits the triangles, then the quads.
template <typename Begin, typename Visit>
void for_each_kind(const Mesh& mesh, const Begin& begin, const Visit& visit) {
  const std::size_t triangles = count_triangles(mesh);
  for (const std::size_t corners : {3u, 4u}) {
    const std::size_t count = corners == 3 ? triangles : mesh.cells().size() - triangles;
    if (count == 0) continue;
    begin(corners, count);
    for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
      if (mesh.cells().vertices(c).size() == corners) visit(c, mesh.cells().vertices(c));
    }
  }
}

std::string obj(const Mesh& mesh) {
  Text out;
  for (const Vec3& p : mesh.points()) out << "v " << p.x() << " " << p.y() << " " << p.z() << "\n";
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    out << "f";
    for (const Index v : mesh.cells().vertices(c)) out << " " << v + 1;
    out << "\n";
  }
  return out.take();
}

std::string msh(const Mesh& mesh) {
  const std::size_t n = mesh.point_count();
  Text out;
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " << n << " 1 " << n << "\n2 1 0 " << n
      << "\n";
  for (std::size_t v = 1; v <= n; ++v) out << v << "\n";
  for (const Vec3& p : mesh.points()) out << p.x() << " " << p.y() << " " << p.z() << "\n";
  const std::size_t triangles = count_triangles(mesh);
  const bool both = triangles > 0 && triangles < mesh.cells().size();
  out << "$EndNodes\n$Elements\n"
      << (both ? 2 : 1) << " " << mesh.cells().size() << " 1 " << mesh.cells().size() << "\n";
  for_each_kind(
      mesh,
      [&](std::size_t corners, std::size_t count) {
        out << "2 1 " << corners - 1 << " " << count << "\n";
      },
      [&](std::size_t c, auto corners) {
        out << c + 1;
        for (const Index v : corners) out << " " << v + 1;
        out << "\n";
      });
  out << "$EndElements\n";
  return out.take();
}

std::string binary_msh(const Mesh& mesh) {
  const std::uint64_t n = mesh.point_count();
  const std::uint64_t cells = mesh.cells().size();
  Text out;
  out << "$MeshFormat\n4.1 1 8\n";
  out.raw(std::int32_t{1}) << "\n$EndMeshFormat\n$Nodes\n";
  for (const std::uint64_t count : {std::uint64_t{1}, n, std::uint64_t{1}, n}) out.raw(count);
  out.raw(std::int32_t{2}).raw(std::int32_t{1}).raw(std::int32_t{0}).raw(n);
  for (std::uint64_t v = 1; v <= n; ++v) out.raw(v);
  for (const Vec3& p : mesh.points()) out.raw(p.x()).raw(p.y()).raw(p.z());
  const std::size_t triangles = count_triangles(mesh);
  const std::uint64_t blocks = triangles > 0 && triangles < cells ? 2 : 1;
  out << "\n$EndNodes\n$Elements\n";
  for (const std::uint64_t count : {blocks, cells, std::uint64_t{1}, cells}) out.raw(count);
  for_each_kind(
      mesh,
      [&](std::size_t corners, std::uint64_t count) {
        out.raw(std::int32_t{2}).raw(std::int32_t{1});
        out.raw(static_cast<std::int32_t>(corners - 1)).raw(count);
      },
      [&](std::uint64_t c, auto corners) {
        out.raw(c + 1);
        for (const Index v : corners) out.raw(std::uint64_t{v} + 1);
      });
  out << "\n$EndElements\n";
  return out.take();
}

std::string inp(const Mesh& mesh) {
  Text out;
  out << "*NODE\n";
  std::size_t number = 0;
  for (const Vec3& p : mesh.points()) {
    out << ++number << ", " << p.x() << ", " << p.y() << ", " << p.z() << "\n";
  }
  for_each_kind(
      mesh, [&](std::size_t corners, std::size_t) { out << "*ELEMENT, TYPE=S" << corners << "\n"; },
      [&](std::size_t c, auto corners) {
        out << c + 1;
        for (const Index v : corners) out << ", " << v + 1;
        out << "\n";
      });
  return out.take();
}

std::string nastran(const Mesh& mesh) {
  Text out;
  out << "BEGIN BULK\n";
  const auto field = [&](std::string text, std::size_t width) {
    text.resize(width, ' ');
    out << text;
  };
  for (std::size_t v = 0; v < mesh.point_count(); ++v) {
    const Vec3& p = mesh.points()[v];
    field("GRID*", 8);
    field(std::to_string(v + 1), 32);
    field(evenmesh::nastran_real(p.x(), 16), 16);
    field(evenmesh::nastran_real(p.y(), 16), 16);
    out << "\n*       " << evenmesh::nastran_real(p.z(), 16) << "\n";
  }
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    field(is_triangle(mesh, c) ? "CTRIA3" : "CQUAD4", 8);
    field(std::to_string(c + 1), 8);
    field("1", 8);
    for (const Index v : mesh.cells().vertices(c)) field(std::to_string(v + 1), 8);
    out << "\n";
  }
  out << "ENDDATA\n";
  return out.take();
}

std::string medit(const Mesh& mesh) {
  Text out;
  out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.point_count() << "\n";
  for (const Vec3& p : mesh.points()) out << p.x() << " " << p.y() << " " << p.z() << " 0\n";
  for_each_kind(
      mesh,
      [&](std::size_t corners, std::size_t count) {
        out << (corners == 3 ? "Triangles\n" : "Quadrilaterals\n") << count << "\n";
      },
      [&](std::size_t, auto corners) {
        for (const Index v : corners) out << v + 1 << " ";
        out << "1\n";
      });
  out << "End\n";
  return out.take();
}

std::string meshb(const Mesh& mesh) {
  Text out;
  constexpr std::int32_t kVertices = 4;
  constexpr std::int32_t kTriangles = 6;
  constexpr std::int32_t kQuads = 7;
  constexpr std::int32_t kEnd = 54;
  constexpr std::size_t kHead = 12;  // keyword, next place, count
  std::size_t place = 20;
  const auto head = [&](std::int32_t keyword, std::size_t count, std::size_t bytes) {
    place += kHead + count * bytes;
    out.raw(keyword).raw(static_cast<std::int32_t>(place)).raw(static_cast<std::int32_t>(count));
  };
  out.raw(std::int32_t{1}).raw(std::int32_t{2});
  out.raw(std::int32_t{3}).raw(std::int32_t{20}).raw(std::int32_t{3});
  head(kVertices, mesh.point_count(), 28);
  for (const Vec3& p : mesh.points()) {
    out.raw(p.x()).raw(p.y()).raw(p.z()).raw(std::int32_t{0});
  }
  for_each_kind(
      mesh,
      [&](std::size_t corners, std::size_t count) {
        head(corners == 3 ? kTriangles : kQuads, count, 4 * corners + 4);
      },
      [&](std::size_t, auto corners) {
        for (const Index v : corners) out.raw(static_cast<std::int32_t>(v + 1));
        out.raw(std::int32_t{1});
      });
  out.raw(kEnd).raw(std::int32_t{0});
  return out.take();
}

template <typename Number>
Text& swapped(Text& out, Number value) {
  std::array<char, sizeof(Number)> bytes{};
  std::memcpy(bytes.data(), &value, sizeof value);
  for (std::size_t i = bytes.size(); i-- > 0;) out << std::string_view(&bytes[i], 1);
  return out;
}

std::string vtk(const Mesh& mesh) {
  Text out;
  out << "# vtk DataFile Version 2.0\nbench\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS "
      << mesh.point_count() << " double\n";
  for (const Vec3& p : mesh.points()) {
    for (int k = 0; k < 3; ++k) swapped(out, p[k]);
  }
  const std::size_t cells = mesh.cells().size();
  out << "\nCELLS " << cells << " " << cells + mesh.cells().corners().size() << "\n";
  for (std::size_t c = 0; c < cells; ++c) {
    swapped(out, static_cast<std::int32_t>(mesh.cells().vertices(c).size()));
    for (const Index v : mesh.cells().vertices(c)) swapped(out, static_cast<std::int32_t>(v));
  }
  out << "\nCELL_TYPES " << cells << "\n";
  for (std::size_t c = 0; c < cells; ++c) swapped(out, std::int32_t{is_triangle(mesh, c) ? 5 : 9});
  return out.take();
}

std::string vtu(const Mesh& mesh) {
  const std::size_t cells = mesh.cells().size();
  const std::uint64_t points_bytes = 24 * mesh.point_count();
  const std::uint64_t corner_bytes = 8 * mesh.cells().corners().size();
  const std::uint64_t offset_bytes = 8 * cells;
  Text out;
  out << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
      << mesh.point_count() << "\" NumberOfCells=\"" << cells << "\">\n";
  std::uint64_t offset = 0;
  const auto array = [&](std::string_view type, std::string_view name, std::uint64_t bytes) {
    out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
        << (name == "Points" ? 3 : 1) << "\" format=\"appended\" offset=\"" << offset << "\"/>\n";
    offset += bytes + 8;
  };
  out << "<Points>\n";
  array("Float64", "Points", points_bytes);
  out << "</Points>\n<Cells>\n";
  array("Int64", "connectivity", corner_bytes);
  array("Int64", "offsets", offset_bytes);
  array("UInt8", "types", cells);
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  out.raw(points_bytes);
  for (const Vec3& p : mesh.points()) out.raw(p.x()).raw(p.y()).raw(p.z());
  out.raw(corner_bytes);
  for (const Index v : mesh.cells().corners()) out.raw(std::int64_t{v});
  out.raw(offset_bytes);
  std::int64_t end = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    end += static_cast<std::int64_t>(mesh.cells().vertices(c).size());
    out.raw(end);
  }
  out.raw(std::uint64_t{cells});
  for (std::size_t c = 0; c < cells; ++c)
    out.raw(std::uint8_t{is_triangle(mesh, c) ? std::uint8_t{5} : std::uint8_t{9}});
  out << "\n</AppendedData>\n</VTKFile>\n";
  return out.take();
}

std::string ply(const Mesh& mesh) {
  Text out;
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.point_count()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << mesh.cells().size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : mesh.points()) out.raw(p.x()).raw(p.y()).raw(p.z());
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    out.raw(static_cast<std::uint8_t>(mesh.cells().vertices(c).size()));
    for (const Index v : mesh.cells().vertices(c)) out.raw(static_cast<std::int32_t>(v));
  }
  return out.take();
}

/// Triangles only.
std::string stl(const Mesh& mesh) {
  Text out;
  out << std::string(80, ' ');
  out.raw(static_cast<std::uint32_t>(mesh.cells().size()));
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    for (int k = 0; k < 3; ++k) out.raw(0.0F);
    for (const Index v : mesh.cells().vertices(c).first(3)) {
      for (int k = 0; k < 3; ++k) out.raw(static_cast<float>(mesh.points()[v][k]));
    }
    out.raw(std::uint16_t{0});
  }
  return out.take();
}

struct Writer {
  std::string_view suffix;
  std::string (*write)(const Mesh&);
};
constexpr std::array kWriters{
    Writer{".obj", obj},     Writer{".msh", msh},     Writer{".mshb", binary_msh},
    Writer{".inp", inp},     Writer{".bdf", nastran}, Writer{".mesh", medit},
    Writer{".meshb", meshb}, Writer{".vtk", vtk},     Writer{".vtu", vtu},
    Writer{".ply", ply},     Writer{".stl", stl}};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: write_case CASE VERTICES FILE\n", stderr);
    return 2;
  }
  try {
    const std::string suffix = std::filesystem::path(argv[3]).extension().string();
    for (const Writer& writer : kWriters) {
      if (writer.suffix != suffix) continue;
      const Mesh mesh =
          evenmesh::bench::make_case_mesh(argv[1], std::strtoull(argv[2], nullptr, 10));
      std::ofstream file(argv[3], std::ios::binary);
      file << writer.write(mesh);
      if (!file.flush()) throw evenmesh::IoError(std::string(argv[3]) + ": cannot be written");
      return 0;
    }
    throw evenmesh::IoError(std::string(argv[3]) + ": the suffix names no format that is written");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_case: %s\n", error.what());
    return 1;
  }
}
