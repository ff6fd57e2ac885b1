// SPDX-License-Identifier: MIT
#include "evenmesh/io/obj.h"

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "tests/io/only_coordinates.h"
#include "tests/io/read_text.h"

namespace evenmesh {
namespace {

using testing::cell_of;
using testing::points_of;
using testing::refusal_by;
using testing::written;

MeshFile read(std::string_view text) { return read_obj(InputFile::borrow(text, "a.obj")); }

std::string refusal(std::string_view text) {
  return refusal_by([&] { read(text); });
}

const std::string kFive = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 2 0\n";

TEST(Obj, MakesTrianglesQuadsAndPolygons) {
  const MeshFile file = read(kFive + "f 1 2 3\nf 1 2 3 4\nf 1 2 3 5 4\n");
  ASSERT_EQ(file.mesh.cells().size(), 3u);
  EXPECT_EQ(file.mesh.cells().kind(0), CellKind::triangle);
  EXPECT_EQ(file.mesh.cells().kind(1), CellKind::quad);
  EXPECT_EQ(file.mesh.cells().kind(2), CellKind::polygon);
  EXPECT_EQ(cell_of(file, 2), (std::vector<Index>{0, 1, 2, 4, 3}));
  EXPECT_EQ(file.mesh.points()[4], Vec3(0.5, 2, 0));
}

TEST(Obj, ReadsEveryFormOfReference) {
  const MeshFile file = read(kFive +
                             "f 1/1 2/2 3/3\nf 1//1 2//2 3//3\nf 1/1/1 2/2/2 3/-3/-3\n"
                             "f +1 2/ 3//\n");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(cell_of(file, i), (std::vector<Index>{0, 1, 2}));
}

TEST(Obj, CountsNegativeIndicesBackFromTheFace) {
  const MeshFile file = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
  EXPECT_EQ(cell_of(file, 0), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(cell_of(file, 1), (std::vector<Index>{0, 2, 3}));
}

TEST(Obj, TakesFacesBeforeTheirVertices) {
  EXPECT_EQ(cell_of(read("f 1 2 3\n" + kFive), 0), (std::vector<Index>{0, 1, 2}));
}

TEST(Obj, JoinsContinuedLinesWithAnyLineEnd) {
  for (const std::string eol : {"\n", "\r\n", "\r"}) {
    const MeshFile file =
        read("\\" + eol + "v 0 \\" + eol + "0 0" + eol + "v\\" + eol + " 1 0 0" + eol + "v 1 1 0" +
             eol + "f 1 \\" + eol + " 2\\" + eol + "\t3" + eol + "vt 0 \\" + eol + "v 7 7 7" + eol);
    EXPECT_EQ(file.mesh.point_count(), 3u);
    EXPECT_EQ(cell_of(file, 0), (std::vector<Index>{0, 1, 2}));
  }
}

TEST(Obj, EndsACommentWithItsLine) {
  const MeshFile file = read("# C:\\\nv 0 0 0 # \\\nv 1 0 0\nv 0 1 0\ns 1 # \\\nf 1 2 3 # all\n");
  EXPECT_EQ(file.mesh.point_count(), 3u);
  EXPECT_EQ(file.mesh.cells().size(), 1u);
}

TEST(Obj, GroupsCellsByObjectGroupAndMaterial) {
  const MeshFile file = read(kFive +
                             "f 1 2 3\no plane\nf 1 2 3\ng wing  left \nusemtl steel\nf 1 2 3\n"
                             "usemtl\nf 1 2 3\nusemtl steel\nf 1 2 3\no\ng\nusemtl\nf 1 2 3\n");
  EXPECT_EQ(file.group_names,
            (std::vector<std::string>{"", "o plane", "o plane, g wing  left, usemtl steel",
                                      "o plane, g wing  left"}));
  const std::vector<std::uint32_t> expected{0, 1, 2, 3, 2, 0};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(file.mesh.cells().group(i), expected[i]) << i;
}

TEST(Obj, AcceptsAFaceThatRepeatsAVertex) {
  EXPECT_EQ(cell_of(read(kFive + "f 5 3 3 1\n"), 0), (std::vector<Index>{4, 2, 2, 0}));
}

TEST(Obj, RefusesWithTheLineAtFault) {
  const std::pair<std::string, std::string> cases[] = {
      {kFive + "f 1 2\n", "a.obj:6: face 1 has 2 vertices; a face needs three or more"},
      {kFive + "\r\n\r\nf 1 \\\r\n2 9\n", "a.obj:9: a face uses vertex 9, but the file has 5"},
      {"v 0 0 0\rv 1 0\r", "a.obj:2: vertex 2 has 2 of 3 coordinates"},
      {"v 0 0 0\r\n\r\nv 1 \\\r\n0 x\r\n", "a.obj:4: 'x' is not a number"},
      {"v 0 0 0v 1 1 1\n", "a.obj:1: '0v' is not a number"},
      {"v 0 0 0 v 1 1 1\n", "a.obj:1: 'v' is not a number"},
      {kFive + "f 1 2 3.0\n", "a.obj:6: face 1 names vertex '3.0'"},
      {kFive + "f 1 2 3/x\n", "a.obj:6: face 1 names vertex '3/x'"},
      {kFive + "f 1 2 3/1/1/1\n", "a.obj:6: face 1 names vertex '3/1/1/1'"},
      {kFive + "f 1 2 -6\n", "a.obj:6: face 1 names vertex '-6'"},
      {kFive + "f 1 2 4294967296\n", "a.obj:6: face 1 names vertex '4294967296'"},
      {std::string("v 0 0 0\n\0\0\0\n", 12), "a.obj:2: binary data"},
      {"vn 0 0 1\n", "a.obj: has no vertices"}};
  for (const auto& [text, message] : cases) {
    EXPECT_TRUE(refusal(text).starts_with(message)) << refusal(text);
  }
}

TEST(Obj, RefusesNamesThatWouldFillTheMemory) {
  std::string text = kFive + "o " + std::string(100'000, 'x') + "\n";
  for (int i = 0; i < 1000; ++i) text += "g " + std::to_string(i) + "\nf 1 2 3\n";
  EXPECT_NE(refusal(text).find("are too long"), std::string::npos);
}

TEST(Obj, NamesCellsAndVerticesAsInTheFile) {
  const std::string text = "\r\n" + kFive + "s 1\nf 1 2 3\n# f\nf 1 \\\n3 4\n";
  const MeshFile file = read(text);
  EXPECT_EQ(file.patch->vertex_name(1), "vertex 2 (line 3)");
  EXPECT_EQ(file.patch->cell_name(0), "face 1 (line 8)");
  EXPECT_EQ(file.patch->cell_name(1), "face 2 (line 10)");
}

TEST(Obj, NamesCellsFarDownTheFile) {
  std::string text = kFive;
  for (int i = 0; i < 5000; ++i) text += i % 2 == 0 ? "f 1 2 3\n" : "g x # \\\nf 1 2 3\n";
  const MeshFile file = read(text);
  for (const std::size_t cell : {0, 1023, 1024, 1025, 4999}) {
    EXPECT_EQ(file.patch->cell_name(cell), "face " + std::to_string(cell + 1) + " (line " +
                                               std::to_string(6 + cell + (cell + 1) / 2) + ")");
  }
}

TEST(Obj, ReplacesOnlyTheCoordinatesThatMoved) {
  const std::string text =
      "\xEF\xBB\xBF# head\r\nv\t+1.50  2e0\t3 0.5 # w\r\nv 4 \\\r\n 5 6.000\r\nv 7 8 9 1 0 0\r\n"
      "vt 1 2\r\nf 1/1 2 3";
  const MeshFile file = read(text);
  std::vector<Vec3> points = points_of(file);
  EXPECT_EQ(written(file, points), text);
  points[0].y() = 1.0 / 3.0;
  points[1].y() = -0.0;
  points[1].z() = 1e300;
  points[2].x() = 5e-324;
  EXPECT_EQ(written(file, points),
            "\xEF\xBB\xBF# head\r\nv\t+1.50  0.3333333333333333\t3 0.5 # w\r\nv 4 \\\r\n -0 1e+300"
            "\r\nv 5e-324 8 9 1 0 0\r\nvt 1 2\r\nf 1/1 2 3");
  EXPECT_EQ(points_of(read(written(file, points))), points);
}

TEST(Obj, TurnsZeroIntoMinusZeroWhenAsked) {
  const MeshFile file = read("v 0 0 0\n");
  EXPECT_EQ(written(file, std::vector<Vec3>{{-0.0, 0, 0}}), "v -0 0 0\n");
}

TEST(Obj, ReadsOrRefusesEveryBeginningOfAFile) {
  const std::string text =
      "\xEF\xBB\xBF# c\no a\\\r\nb\nv +1.5 -2e-3 \\\r\n3 1\rv 1 2 3\r\nvt 0 1\nv 0 .5 9"
      "\ng x y\nusemtl m\nf 1/2/3 -2//4 \\\n 3 # c\ncurv 0 1\nv 1e10 0 0\nf 1 2 3 4 1\n";
  int readable = 0;
  for (std::size_t length = 0; length <= text.size(); ++length) {
    // A copy of its own, so that the sanitizer sees a byte read too far.
    const std::vector<char> bytes(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
    const std::string_view part(bytes.data(), bytes.size());
    try {
      const MeshFile file = read(part);
      EXPECT_EQ(written(file, file.mesh.points()), part);
      for (std::size_t i = 0; i < file.mesh.cells().size(); ++i) file.patch->cell_name(i);
      ++readable;
    } catch (const IoError&) {
    }
  }
  EXPECT_GT(readable, 50);
}

}  // namespace
}  // namespace evenmesh
