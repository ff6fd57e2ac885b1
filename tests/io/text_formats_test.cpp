// SPDX-License-Identifier: MIT
//
// OFF, MEDIT and SU2, and what formats share.
#include <cstring>

#include <gtest/gtest.h>

#include "evenmesh/io/gzip.h"
#include "tests/io/only_coordinates.h"
#include "tests/io/read_text.h"
#include "tests/io/temporary_folder.h"

namespace evenmesh {
namespace {

using testing::cell_of;
using testing::expect_refusals;
using testing::read_bytes;
using testing::read_text;
using testing::readable_beginnings;
using testing::refusal_of;
using testing::set_of;
using testing::TemporaryFolder;
using testing::written;

using Numbers = std::vector<Index>;

// ---- OFF ----

const std::string kFive = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 2 0\n";

TEST(Off, MakesTrianglesQuadsAndPolygons) {
  const MeshFile file =
      read_text("OFF\n5 3 0\n" + kFive + "3 0 1 2\n4 0 1 2 3\n5 0 1 2 4 3\n", "a.off");
  ASSERT_EQ(file.mesh.cells().size(), 3u);
  EXPECT_EQ(file.mesh.cells().kind(1), CellKind::quad);
  EXPECT_EQ(file.mesh.cells().kind(2), CellKind::polygon);
  EXPECT_EQ(cell_of(file, 2), (Numbers{0, 1, 2, 4, 3}));
  EXPECT_TRUE(file.notes.empty());
}

TEST(Off, TakesEveryKeywordWithCountsBehindItOrBelow) {
  for (const std::string keyword : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF"}) {
    for (const std::string gap : {"\n", " ", "  # c\r\n\r\n", "", "\r# c\r"}) {
      std::string text = "\xEF\xBB\xBF# c\n\n";
      text += keyword + gap + "3 1 0\n0 0 0 .1 .2 1 255 0 0 1\n1 0 0\n0 1 0\n3 0 1 2\n";
      const MeshFile file = read_text(text, "a.obj");
      EXPECT_EQ(file.patch->format(), "off");
      EXPECT_EQ(cell_of(file, 0), (Numbers{0, 1, 2})) << text;
      EXPECT_EQ(file.notes.size(), keyword.find('N') == std::string::npos ? 0u : 1u) << text;
    }
  }
}

TEST(Off, SkipsFacesOfFewerThanThreeVerticesAndCountsThem) {
  const MeshFile file =
      read_text("OFF\n5 5 0\n" + kFive + "2 0 1\n3 0 1 2\n0\n# c\n3 1 2 3\n1 4\n", "a.off");
  ASSERT_EQ(file.mesh.cells().size(), 2u);
  EXPECT_EQ(file.patch->cell_name(0), "face 1 (line 9)");
  EXPECT_EQ(file.patch->cell_name(1), "face 3 (line 12)");
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_TRUE(
      file.notes[0].starts_with("3 of 5 faces have fewer than three vertices (the first is "
                                "face 0)"));
}

TEST(Off, RefusesWithTheLineAtFault) {
  expect_refusals(
      "a.off", {{"4OFF\n3 1 0\n", ":1: 4OFF has vertices of other than three"},
                {"nOFF\n3 1 0\n", ":1: nOFF has vertices of other than three"},
                {"OFF BINARY\n1 2 3", ":1: a binary OFF file; write it in ASCII"},
                {"OFF\n3\n1\n0\n", ":2: the number of faces is missing"},
                {"OFF\n0 0 0\n", ": has no vertices"},
                {"OFF\n-3 1 0\n", ":2: the number of vertices is -3, below zero"},
                {"OFF\n3 1.0 0\n", ":2: '1.0' is not a whole number; the number of faces"},
                {"OFF\n3 4000000000 0\n0 0 0\n0 0 0\n0 0 0\n", ":2: promises 4000000000 faces but"},
                {"OFF\n2 0 0\n0 0 0\n10 10\n", ":4: vertex 1 has 2 of 3 coordinates"},
                {"OFF\r\n2 0 0\r\n0 0 0\r\n1 nan 0\r\n", ":4: 'nan' is not a finite number"},
                {"OFF\n2 0 0\n0 0 0\n1 0,5 0\n", ":4: '0,5' has a decimal comma"},
                {"OFF\n5 2 0\n" + kFive + "3 0 1 2\n", ":9: the file ends after 1 of 2 faces"},
                {"OFF\n5 1 0\n" + kFive + "3 0 1\n", ":8: face 0 has 2 of 3 vertices"},
                {"OFF\n5 1 0\n" + kFive + "3 0 1 5\n", ":8: face 0 names vertex 5; the 5 vertices"},
                {"OFF\n5 1 0\n" + kFive + "3 0 1 -1\n", ":8: face 0 names vertex -1"}});
}

TEST(Off, ReplacesOnlyTheCoordinatesThatMoved) {
  const std::string text =
      "COFF # head\r\n3 1 0\r\n\r\n\t+1.50  2e0\t3 255 0 0 # w\r\n# 7 7 7\r\n4 5 6.000\r\n7 8 9 1\r"
      "\n3 0 1 2 0.5 0 0";
  const MeshFile file = read_text(text, "a.off");
  std::vector<Vec3> points = testing::points_of(file);
  EXPECT_EQ(written(file, points), text);
  points[0].y() = 1.0 / 3.0;
  points[1].z() = -0.0;
  EXPECT_EQ(written(file, points),
            "COFF # head\r\n3 1 0\r\n\r\n\t+1.50  0.3333333333333333\t3 255 0 0 # w\r\n# 7 7 7\r\n"
            "4 5 -0\r\n7 8 9 1\r\n3 0 1 2 0.5 0 0");
}

TEST(Off, ReadsOrRefusesEveryBeginningOfAFile) {
  EXPECT_EQ(readable_beginnings("# c\r\nSTCNOFF5 4 0 # k\r\n0 0 0 .5 # c\r1 0 0\n\n1 +1e0 0\n0 1 "
                                "0\r\n.5 2. 1e-400\n3 0 1 2 255\n2 1 0\n4 0 1 2 3 # c\n5 0 1 2 4 "
                                "3\n",
                                "a.off"),
            2);
}

// ---- MEDIT ----

const std::string kMedit =
    "MeshVersionFormatted 2\nDimension\n3\n# made by hand\nVertices 5\n0 0 0 0\n1 0 0 7\n0 1 0 0\n"
    "0 0 1.0D0 0\n1 1 1 7\nTetrahedra\n2\n1 2 3 4 1\n2 3 4 5 2\nTriangles\n2\n1 2 3 9\n1 2 4 8\n"
    "Corners\n1\n1\nNormals\n1\n0 0 1\nRequiredTriangles\n1\n2\nEnd\n";

TEST(Medit, ReadsCellsReferencesAndWhatIsRequired) {
  const MeshFile file = read_text(kMedit, "a.mesh");
  ASSERT_EQ(file.mesh.cells().size(), 4u);
  EXPECT_EQ(cell_of(file, 1), (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(file.group_names, (std::vector<std::string>{"", "ref 1", "ref 2"}));
  EXPECT_EQ(file.mesh.cells().group(2), 0u);
  EXPECT_EQ(set_of(file, "marker", "9"), (Numbers{0, 1, 2}));
  EXPECT_EQ(set_of(file, "nset", "7"), (Numbers{1, 4}));
  EXPECT_EQ(file.held.vertices, (Numbers{0, 1, 2, 3}));  // required, and the rims of 8 and 9
  EXPECT_EQ(file.patch->cell_name(0), "cell 1 (line 13)");
  EXPECT_EQ(file.patch->vertex_name(0), "vertex 1 (line 6)");
  EXPECT_EQ(file.mesh.points()[3], Vec3(0, 0, 1));
}

TEST(Medit, PlanarFilesHaveNoThirdCoordinate) {
  const std::string text =
      "MeshVersionFormatted 1\nDimension 2\nVertices\n3\n0 0 1\n1 0 1\n0 1 1\nEdges\n2\n1 2 5\n2 3 "
      "6\nTriangles\n1\n1 2 3 0\nEnd";
  const MeshFile file = read_text(text, "a.mesh");
  EXPECT_EQ(file.held.vertices, (Numbers{0, 1, 2}));  // where the edges of 5 and 6 end
  std::vector<Vec3> points = testing::points_of(file);
  points[1] = Vec3(0.5, 0.25, 3);
  EXPECT_EQ(file.representable(points)[1], Vec3(0.5, 0.25, 0));
  std::string expected = text;
  expected.replace(expected.find("1 0 1\n"), 3, "0.5 0.25");
  EXPECT_EQ(written(file, points), expected);
}

TEST(Medit, RefusesWithTheLineAtFault) {
  const std::string head = "MeshVersionFormatted 2\nDimension 3\n";
  expect_refusals(
      "a.mesh",
      {{head, ": has no vertices"},
       {head + "Dimension 2\n", ":3: a second Dimension"},
       {"MeshVersionFormatted 2\nDimension 4\n", ":2: the dimension is 4"},
       {"MeshVersionFormatted 2\nVertices 1\n0 0 0 0\n", ":2: Vertices come before Dimension"},
       {head + "Vertices 9999999\n0 0 0 0\n", ":3: promises 9999999 vertices"},
       {head + "Vertices 1\n0 0 inf 0\n", ":4: 'inf' is not a finite number"},
       {head + "Vertices 2\n0 0 0 0\n1 1 1 0\nTetrahedra 1\n1 2 3 4 0\n",
        ":7: a vertex with number"},
       {head + "Vertices 1\n0 0 0 0\nTetrahedraP2 1\n", ":5: TetrahedraP2 are cells of second"},
       {head + "Vertices 1\n0 0 0 0\nRidges 1\n1\n", ":6: an edge with number 1"}});
}

TEST(Medit, ReadsOrRefusesEveryBeginningOfAFile) {
  EXPECT_GT(readable_beginnings(kMedit, "a.mesh"), 0);
}

/// A binary file of one tet, of a version and in a byte order.
class Meshb {
 public:
  Meshb(int version, bool swap) : version_(version), swap_(swap) {
    number<std::int32_t>(1);
    number<std::int32_t>(version);
    section(3, [&] { number<std::int32_t>(3); });
    section(4, [&] {
      integer(4);
      for (const int corner : {0, 1, 2, 3}) {
        for (int k = 0; k < 3; ++k) real(corner == k + 1 ? 1.0 : 0.0);
        integer(corner == 2 ? 5 : 0);
      }
    });
    section(8, [&] {
      integer(1);
      for (const int n : {1, 2, 3, 4, 6}) integer(n);
    });
    number<std::int32_t>(54);
    position(0);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  template <typename T>
  void number(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (swap_) std::reverse(raw, raw + sizeof(T));
    bytes_.append(raw, sizeof(T));
  }
  void integer(int value) {
    version_ >= 4 ? number<std::int64_t>(value) : number<std::int32_t>(value);
  }
  void real(double value) { version_ == 1 ? number(static_cast<float>(value)) : number(value); }
  void position(std::size_t value) {
    version_ >= 3 ? number(static_cast<std::int64_t>(value))
                  : number(static_cast<std::int32_t>(value));
  }
  template <typename Fill>
  void section(int code, const Fill& fill) {
    const std::string before = bytes_;
    position(0);
    fill();
    const std::size_t end = bytes_.size() + sizeof(std::int32_t);
    bytes_ = before;
    number<std::int32_t>(code);
    position(end);
    fill();
  }

  int version_;
  bool swap_;
  std::string bytes_;
};

TEST(Meshb, IsReadAndPatchedInEveryVersionAndByteOrder) {
  for (int version = 1; version <= 4; ++version) {
    for (const bool swap : {false, true}) {
      SCOPED_TRACE(version);
      const std::string bytes = Meshb(version, swap).bytes();
      const MeshFile file = read_text(bytes, "a.meshb");
      EXPECT_EQ(file.patch->format(), "meshb");
      ASSERT_EQ(file.mesh.cells().size(), 1u);
      EXPECT_EQ(cell_of(file, 0), (Numbers{0, 1, 2, 3}));
      EXPECT_EQ(file.mesh.points()[2], Vec3(0, 1, 0));
      EXPECT_EQ(file.group_names[1], "ref 6");
      EXPECT_EQ(set_of(file, "nset", "5"), (Numbers{2}));
      std::vector<Vec3> points = testing::points_of(file);
      EXPECT_EQ(written(file, points), bytes);
      points[3] = Vec3(0.1, 0.0, 1.0);
      const std::string text = written(file, points);
      ASSERT_EQ(text.size(), bytes.size());
      const MeshFile again = read_text(text, "a.meshb");
      const std::vector<Vec3> wanted = file.representable(points);
      EXPECT_EQ(again.mesh.points()[3], wanted[3]);
      EXPECT_EQ(wanted[3].x(), version == 1 ? double{0.1f} : 0.1);
    }
  }
}

TEST(Meshb, ReadsOrRefusesEveryBeginningOfAFile) {
  EXPECT_GT(readable_beginnings(Meshb(2, false).bytes(), "a.meshb"), 0);
}

TEST(Meshb, RefusesSectionsThatRunInACircle) {
  std::string bytes = Meshb(2, false).bytes();
  bytes[12] = 8;  // where the section behind the dimension begins
  EXPECT_TRUE(refusal_of(bytes, "a.meshb").find("circle") != std::string::npos)
      << refusal_of(bytes, "a.meshb");
}

// ---- SU2 ----

const std::string kSu2 =
    "% made by hand\nNDIME= 2\nNELEM= 2\n5 0 1 2 0\n5\t0\t2\t3\nNPOIN= 4 4\n0 0 0\n1.0 0 1\n1 1 2\n"
    "0 1 3\nNMARK= 2\nMARKER_TAG= inlet\nMARKER_ELEMS= 1\n3 3 0\nMARKER_TAG= far field\n"
    "MARKER_ELEMS= 2\n3 0 1\n3 1 2\nFFD_NBOX= 0\n";

TEST(Su2, ReadsCellsAndMarkers) {
  const MeshFile file = read_text(kSu2, "a.su2");
  ASSERT_EQ(file.mesh.cells().size(), 2u);
  EXPECT_EQ(cell_of(file, 1), (Numbers{0, 2, 3}));
  EXPECT_EQ(set_of(file, "marker", "far field"), (Numbers{0, 1, 2}));
  EXPECT_EQ(file.held.vertices, (Numbers{0, 2, 3}));  // where markers end
  EXPECT_EQ(file.patch->cell_name(1), "element 1 (line 5)");
  EXPECT_EQ(file.patch->vertex_name(3), "node 3 (line 10)");
  EXPECT_EQ(file.patch->first_vertex_number(), 0u);
  std::vector<Vec3> points = testing::points_of(file);
  EXPECT_EQ(written(file, points), kSu2);
  points[1].x() = 1.5;
  std::string expected = kSu2;
  expected.replace(expected.find("1.0 0 1"), 3, "1.5");
  EXPECT_EQ(written(file, points), expected);
}

TEST(Su2, RefusesWithTheLineAtFault) {
  expect_refusals("a.su2",
                  {{"NDIME= 5\n", ":1: NDIME is 5"},
                   {"NDIME= 2\nNELEM= 0\n", ": has no nodes"},
                   {"NZONE= 2\n", ":1: several zones"},
                   {"NPOIN= 1\n0 0\n", ":1: NPOIN= comes before NDIME="},
                   {"NDIME= 2\nNELEM= 1\n42 0 1 2\n", ":3: element 0 has type 42"},
                   {"NDIME= 2\nNELEM= 1\n5 0 1\n", ":3: element 0 has 2 of 3 nodes"},
                   {"NDIME= 2\nNELEM= 1\n5 0 1 9\nNPOIN= 1\n0 0\n", ":3: element 0 names node 1"},
                   {"NDIME= 2\nNPOIN= 9999\n0 0\n", ":2: promises 9999 nodes"},
                   {"NDIME= 2\nNPOIN= 1\n0 0\nMARKER_TAG= a\nMARKER_ELEMS= 1\n3 0 7\n",
                    ": a marker names node 7"}});
}

TEST(Su2, ReadsOrRefusesEveryBeginningOfAFile) { EXPECT_GT(readable_beginnings(kSu2, "a.su2"), 0); }

// ---- gzip ----

std::string gzipped(std::string_view text) {
  std::string packed;
  GzipWriter writer([&](std::string_view bytes) { packed += bytes; });
  writer.append(text);
  writer.finish();
  return packed;
}

TEST(Gzip, CompressedFilesAreReadAndComeOutCompressed) {
  const TemporaryFolder folder;
  const std::string packed = gzipped(kSu2);
  const MeshFile file = read_mesh(folder.write("a.su2.gz", packed));
  EXPECT_EQ(file.patch->format(), "su2");
  EXPECT_EQ(file.bytes, packed.size());
  std::vector<Vec3> points = testing::points_of(file);
  write_mesh(file, points, folder.path() / "same.su2.gz");
  EXPECT_EQ(read_bytes(folder.path() / "same.su2.gz"), packed);
  points[1].x() = 1.5;
  write_mesh(file, points, folder.path() / "b.su2.gz");
  EXPECT_EQ(gunzip(read_bytes(folder.path() / "b.su2.gz"), "b"), written(file, points));
  EXPECT_THROW(write_mesh(file, points, folder.path() / "c.su2"), IoError);
}

TEST(Gzip, SeveralMembersAreOneText) {
  EXPECT_EQ(gunzip(gzipped("abc") + gzipped("def"), "a"), "abcdef");
}

TEST(Gzip, RefusesWhatIsBrokenOrCutOffOrABomb) {
  const std::string packed = gzipped(kSu2);
  const auto refusal = [](const std::string& bytes) { return refusal_of(bytes, "a.gz"); };
  EXPECT_TRUE(refusal(packed.substr(0, packed.size() / 2))
                  .starts_with("a.gz: the compressed file was cut"));
  std::string broken = packed;
  for (std::size_t i = packed.size() / 2; i < packed.size(); ++i) broken[i] = '\x55';
  EXPECT_TRUE(refusal(broken).starts_with("a.gz: the compressed file")) << refusal(broken);
  const std::string bomb = gzipped(std::string(std::size_t{40} << 20, ' '));
  EXPECT_TRUE(refusal(bomb).starts_with("a.gz: unpacks to more")) << refusal(bomb);
  EXPECT_TRUE(refusal(gzipped("")).starts_with("a.gz: is empty when unpacked"));
}

}  // namespace
}  // namespace evenmesh
