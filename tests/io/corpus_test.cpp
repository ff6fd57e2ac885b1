// SPDX-License-Identifier: MIT
//
// Every file of the corpus in a format that is read: read or refused as it should be, and patched
// without a trace.
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/format.h"
#include "evenmesh/io/mesh_file.h"
#include "tests/io/patch_checker.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/places.h"

namespace evenmesh {
namespace {

namespace fs = std::filesystem;
using testing::corpus_dir;
using testing::read_bytes;
using testing::written;

/// Some suffixes stand for several formats, of which one is read.
bool has_known_format(const fs::path& path) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  if (suffix == ".mesh") return read_bytes(path).starts_with("MeshVersionFormatted");
  return suffix == ".obj" || suffix == ".stl" || suffix == ".msh" || suffix == ".off" ||
         suffix == ".ply" || suffix == ".su2" || suffix == ".vtk" || suffix == ".vtu" ||
         suffix == ".inp" || suffix == ".bdf" || suffix == ".g";
}

std::vector<fs::path> corpus_files(bool readable_formats) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(corpus_dir())) {
    if (entry.is_regular_file() && has_known_format(entry.path()) == readable_formats) {
      files.push_back(fs::relative(entry.path(), corpus_dir()));
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What each file that is not refused holds, and a part of the message for those that are.
struct Outcome {
  std::size_t points = 0;
  std::size_t cells = 0;
  std::string note_or_message;  // "": no note at all
};
constexpr std::size_t kRefused = ~std::size_t{0};
Outcome refused(std::string message) { return {kRefused, 0, std::move(message)}; }

const std::map<std::string, Outcome> kOutcomes{
    {"hostile/all_coincident.obj", {25, 32, ""}},
    {"hostile/medit_count_lie.mesh", refused(":10: promises 99 Tetrahedra")},
    {"hostile/medit_dimension_on_next_line.mesh", {4, 1, ""}},
    {"hostile/off_bad_index.off", refused(":6: face 0 names vertex 7")},
    {"hostile/off_comments_blank.off", {3, 1, ""}},
    {"hostile/off_huge_counts.off", refused(":2: promises 4000000000 vertices")},
    {"hostile/off_negative_count.off", refused(":2: the number of vertices is -3")},
    {"format_features/assimp__issue623.ply", refused(":15: '7.941797' is not a whole number")},
    {"hostile/ply_big_endian_double.ply", {3, 1, ""}},
    {"hostile/ply_face_before_vertex.ply", {3, 1, ""}},
    {"hostile/ply_huge_list.ply", refused("byte 207: promises 2147483647 numbers in a list")},
    {"malformed/assimp__crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply",
     refused("' is no type of a PLY")},
    {"malformed/trimesh__points_emptyface.ply", {1024, 0, "vertices but no faces"}},
    {"malformed/assimp__OutOfMemory.off", refused(":2: promises 353535235358 vertices")},
    {"malformed/assimp__invalid.off", refused(":7: face 1 has 0 of 2 vertices")},
    {"hostile/degenerate_hex_as_wedge.vtk", {8, 1, ""}},
    {"hostile/flat_tet.vtk", {5, 2, ""}},
    {"hostile/hex_huge_count.vtk", refused(":14: promises 2147483647 cells")},
    {"hostile/hex_index_oob.vtk", refused(":15: cell 0 names point 88; the 8 points")},
    {"hostile/hex_left_handed.vtk", {8, 1, ""}},
    {"hostile/hex_ok.vtk", {8, 1, ""}},
    {"hostile/hex_type_mismatch.vtk",
     refused(":15: cell 0 has 8 points; a cell of type 10 (tet) has 4")},
    {"hostile/hex_unknown_type.vtk", refused(":15: cell 0 is of type 99, unknown")},
    {"hostile/quadratic_tet.vtk", {10, 1, ""}},
    {"hostile/truncated.vtk", refused(":5: promises 8 points")},
    {"hostile/wedge_both_orders.vtk", {12, 2, ""}},
    {"nonmanifold/pynastran__bend_A1_105_2.bdf",
     refused(":40: GRID 11031 is in coordinate system 1")},
    {"hostile/ascii_comma.stl",
     refused("ascii_comma.stl:4: '0,000000000e+00' has a decimal comma")},
    {"hostile/ascii_crlf.stl", {25, 32, ""}},
    {"hostile/ascii_four_vertices.stl", refused(":7: facet 1 has more than three vertices")},
    {"hostile/ascii_hexfloat.stl", refused(":4: '0x0p+0' is not a number")},
    {"hostile/ascii_leading_blank.stl", {25, 32, ""}},
    {"hostile/ascii_nan_normal.stl", {25, 32, ""}},
    {"hostile/ascii_no_endsolid.stl", {25, 32, "may have been cut off"}},
    {"hostile/ascii_truncated.stl", refused("it was cut off")},
    {"hostile/ascii_two_solids.stl", {25, 32, ""}},
    {"hostile/ascii_upper.stl", {25, 32, ""}},
    {"hostile/big_endian.stl", refused("big-endian")},
    {"hostile/binary_noise.obj", refused("has no vertices")},
    {"hostile/bom_utf8.obj", {25, 32, ""}},
    {"hostile/bowtie_quad.obj", {25, 16, ""}},
    {"hostile/collinear_sliver.obj", {25, 32, ""}},
    {"hostile/concave_ngon.obj", {5, 1, ""}},
    {"hostile/count_too_large.stl", refused("promises 4294967295 facets but has room for 32")},
    {"hostile/count_too_small.stl", {25, 32, "promises 29 facets, but 3 more follow"}},
    {"hostile/count_zero_with_data.stl", {25, 32, "promises 0 facets, but 32 more follow"}},
    {"hostile/cr_only.obj", {25, 32, ""}},
    {"hostile/crlf.obj", {25, 16, ""}},
    {"hostile/decimal_comma.obj", refused("decimal_comma.obj:2: '0,25' has a decimal comma")},
    {"hostile/dup_vertices.obj", {26, 32, ""}},
    {"hostile/duplicate_faces.obj", {25, 37, ""}},
    {"hostile/edge_fan_nonmanifold.obj", {5, 3, ""}},
    {"hostile/empty.obj", refused("is empty")},
    {"hostile/empty.stl", refused("is empty")},
    {"hostile/faces_before_vertices.obj", {25, 32, ""}},
    {"hostile/far_from_origin.obj", {25, 16, ""}},
    {"hostile/far_from_origin_f32.stl", {25, 32, ""}},
    {"hostile/flipped_faces.obj", {25, 32, ""}},
    {"hostile/free_form.obj", {25, 32, ""}},
    {"hostile/garbage_number.obj", refused("garbage_number.obj:5: '1x' is not a number")},
    {"hostile/header_only.stl", {0, 0, "no facets"}},
    {"hostile/huge_coords.obj", {25, 32, ""}},
    {"hostile/index_out_of_range.obj", refused(":58: a face uses vertex 1000000, but")},
    {"hostile/index_overflow.obj", refused(":58: face 33 names vertex '99999999999999999999'")},
    {"hostile/index_zero.obj", refused(":58: face 33 names vertex '0'")},
    {"hostile/inf_coord.obj", refused(":8: 'inf' is not a finite number")},
    {"hostile/isolated_vertices.obj", {28, 32, ""}},
    {"hostile/latin1_names.obj", {25, 32, ""}},
    {"hostile/line_continuation.obj", {25, 32, ""}},
    {"hostile/long_line.obj", {25, 32, ""}},
    {"hex/dealii__grid_in_gmsh_01.3da.msh", refused("a Gmsh mesh of version 1")},
    {"hostile/msh_bad_section.msh", refused(":14: element 2 uses node 33, which the file")},
    {"hostile/nan_coord.obj", refused(":8: 'nan' is not a finite number")},
    {"hostile/nan_coord_bin.stl",
     refused("facet 3 (byte 184) has a coordinate that is not a finite")},
    {"hostile/near_coincident_soup.stl", {25, 32, ""}},
    {"hostile/neg_out_of_range.obj", refused(":58: face 33 names vertex '-9999'")},
    {"hostile/negative_indices.obj", {25, 16, ""}},
    {"hostile/ngon.obj", {7, 1, ""}},
    {"hostile/no_final_newline.obj", {25, 32, ""}},
    {"hostile/one_triangle.obj", {3, 1, ""}},
    {"hostile/only_comments.obj", refused("has no vertices")},
    {"hostile/repeated_vertex_quad.obj", {25, 16, ""}},
    {"hostile/rgb_and_w.obj", {25, 32, ""}},
    {"hostile/short_79.stl", refused("nor long enough for a binary one")},
    {"hostile/short_vertex.obj", refused(":1: vertex 1 has 2 of 3 coordinates")},
    {"hostile/solid_prefixed_binary.stl", {25, 32, ""}},
    {"hostile/tabs_and_trailing.obj", {25, 32, ""}},
    {"hostile/tiny_coords.obj", {25, 32, ""}},
    {"hostile/trailing_bytes.stl", {25, 32, "17 bytes behind the last facet"}},
    {"hostile/truncated.stl", refused("promises 32 facets but has room for 31")},
    {"hostile/utf8_groups.obj", {25, 32, ""}},
    {"hostile/vertex_bowtie.obj", {5, 2, ""}},
    {"hostile/vertices_only.obj", {25, 0, "no faces"}},
    {"hostile/vt_vn_slashes.obj", {25, 16, ""}},
    {"hostile/zero_area.obj", {26, 35, ""}},
    {"malformed/assimp__malformed.obj", refused(":28: face 6 names vertex '0'")},
    {"malformed/stlmodels__empty.stl", refused("is empty")},
    {"malformed/stlmodels__incorrectFaceCounter.bin.stl",
     refused("promises 66 facets but has room for 4")},
    {"malformed/stlmodels__missingEndsolid.ascii.stl", {4, 4, "may have been cut off"}},
    {"malformed/stlmodels__notANumberNormal.ascii.stl", {4, 4, ""}},
    {"malformed/stlmodels__quad.ascii.stl", refused(":7: facet 1 has more than three vertices")},
    {"malformed/stlmodels__twoVertices.ascii.stl",
     refused(":6: facet 1 has 2 vertices instead of 3")},
    {"malformed/stlmodels__wrongHeader.bin.stl", {8, 12, ""}},
    {"format_features/assimp__box_UTF16BE.obj", refused("UTF-16")},
    {"format_features/assimp__number_formats.obj", refused(":11: '3.1+e2' is not a number")},
};

bool is_refused(const std::string& name) {
  const auto found = kOutcomes.find(name);
  return found != kOutcomes.end() && found->second.points == kRefused;
}

void expect_outcome(const fs::path& path, const Outcome& outcome) {
  try {
    const MeshFile file = read_mesh(path);
    ASSERT_NE(outcome.points, kRefused) << path << " was read";
    EXPECT_EQ(file.mesh.point_count(), outcome.points) << path;
    EXPECT_EQ(file.mesh.cells().size(), outcome.cells) << path;
    ASSERT_EQ(file.notes.size(), outcome.note_or_message.empty() ? 0u : 1u) << path;
    if (file.notes.empty()) return;
    EXPECT_NE(file.notes[0].find(outcome.note_or_message), std::string::npos) << file.notes[0];
  } catch (const IoError& error) {
    const std::string message = error.what();
    ASSERT_EQ(outcome.points, kRefused) << message;
    EXPECT_TRUE(message.starts_with(path.string() + ":")) << message;
    EXPECT_NE(message.find(outcome.note_or_message), std::string::npos) << message;
  }
}

/// Moves two vertices of three in one or two coordinates, by parts that no two vertices share.
std::vector<Vec3> moved_points(const Mesh& mesh) {
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  double size = 0.0;
  for (const Vec3& point : points) size = std::max(size, point.cwiseAbs().maxCoeff());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(points.size());
    const double step = size * (1e-3 + 1e-4 * part);
    if (i % 3 != 0) points[i][static_cast<int>(i % 2)] += step;
    if (i % 3 == 2) points[i].z() -= step / 3.0;
  }
  return points;
}

void expect_same_mesh(const Mesh& a, const Cells& cells, Points points, const std::string& name) {
  EXPECT_TRUE(std::ranges::equal(a.cells().corners(), cells.corners())) << name;
  EXPECT_TRUE(std::ranges::equal(a.cells().offsets(), cells.offsets())) << name;
  ASSERT_EQ(a.point_count(), points.size()) << name;
  if (points.empty()) return;
  EXPECT_EQ(std::memcmp(a.points().data(), points.data(), points.size_bytes()), 0) << name;
}

class Corpus : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(corpus_dir())) GTEST_SKIP() << "there is no corpus at " << corpus_dir();
  }
};

TEST_F(Corpus, HostileAndMalformedFilesComeOutAsTheyShould) {
  for (const auto& [name, outcome] : kOutcomes) expect_outcome(corpus_dir() / name, outcome);
}

TEST_F(Corpus, EveryHostileAndMalformedFileHasAnOutcome) {
  for (const fs::path& path : corpus_files(true)) {
    const std::string folder = path.begin()->string();
    if (folder != "hostile" && folder != "malformed") continue;
    EXPECT_TRUE(kOutcomes.contains(path.string())) << path;
  }
}

TEST_F(Corpus, OtherFormatsAreRefusedWithTheListOfThoseThatAreRead) {
  for (const fs::path& path : corpus_files(false)) {
    try {
      read_mesh(corpus_dir() / path);
      ADD_FAILURE() << path << " was read";
    } catch (const IoError& error) {
      EXPECT_NE(
          std::string(error.what()).find("evenmesh reads OBJ, STL, OFF, PLY, Gmsh MSH, MEDIT"),
          std::string::npos)
          << error.what();
    }
  }
}

TEST_F(Corpus, UnmovedFilesAreWrittenByteForByte) {
  for (const fs::path& path : corpus_files(true)) {
    if (is_refused(path.string())) continue;
    const MeshFile file = read_mesh(corpus_dir() / path);
    EXPECT_TRUE(written(file, file.mesh.points()) == read_bytes(corpus_dir() / path)) << path;
  }
}

TEST_F(Corpus, OnlyCoordinatesOfMovedVerticesChange) {
  for (const fs::path& path : corpus_files(true)) {
    if (is_refused(path.string())) continue;
    const std::string before = read_bytes(corpus_dir() / path);
    const auto input = InputFile::borrow(before, path.string());
    const MeshFile file = read_mesh(input);
    // As write_mesh() has it: nodes in the middle of edges go where their corners go.
    const std::vector<Vec3> points = file.representable(moved_points(file.mesh));
    const std::string after = written(file, points);
    const testing::TemporaryFolder folder;
    const fs::path changed = folder.write(path.filename().string(), after);
    EXPECT_EQ(testing::difference_of_files(file, points, corpus_dir() / path, changed), "") << path;
    const MeshFile again = read_mesh(InputFile::borrow(after, path.string()));
    expect_same_mesh(again.mesh, file.mesh.cells(), points, path.string());
    EXPECT_EQ(again.group_names, file.group_names) << path;
  }
}

}  // namespace
}  // namespace evenmesh
