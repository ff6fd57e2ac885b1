// SPDX-License-Identifier: MIT
#include "evenmesh/io/inp.h"

#include <gtest/gtest.h>

#include "evenmesh/io/inp_elements.h"
#include "tests/io/only_coordinates.h"
#include "tests/io/read_text.h"
#include "tests/io/temporary_folder.h"

namespace evenmesh {
namespace {

using testing::cell_of;
using testing::read_text;
using testing::readable_beginnings;
using testing::set_of;
using testing::written;

using Numbers = std::vector<Index>;

MeshFile read(const std::string& text) { return read_text(text, "a.inp"); }

const std::string kNodes =
    "*NODE, NSET=All nodes\n"
    "10, 0., 0., 0.\n"
    "20, 1.D0, 0, 0\n"
    "30, 1, 1, 0\n"
    " 40 ,0,1 ,0.0\n"
    "70, 2, 0, 0\n"
    "80, 2, 1, 0\n";

TEST(Inp, ReadsNodesAndElementsByTheirNumbers) {
  const MeshFile file = read("** made by hand\n" + kNodes +
                             "*Element, type=S4R, elset=left\n5, 10, 20, 30, 40\n"
                             "*ELEMENT, TYPE=S4R, ELSET=right\n9, 20, 70,\n 80, 30\n");
  EXPECT_EQ(file.patch->format(), "inp");
  ASSERT_EQ(file.mesh.cells().size(), 2u);
  EXPECT_EQ(cell_of(file, 0), (Numbers{0, 1, 2, 3}));
  EXPECT_EQ(cell_of(file, 1), (Numbers{1, 4, 5, 2}));
  EXPECT_EQ(file.mesh.points()[1], Vec3(1, 0, 0));
  EXPECT_EQ(file.patch->vertex_name(1), "node 20 (line 4)");
  EXPECT_EQ(file.patch->cell_name(1), "element 9 (line 12)");
  EXPECT_EQ(file.group_names, (std::vector<std::string>{"", "elset left", "elset right"}));
  EXPECT_EQ(file.mesh.cells().group(1), 2u);
  EXPECT_EQ(set_of(file, "nset", "All nodes"), (Numbers{0, 1, 2, 3, 4, 5}));
}

TEST(Inp, GroupsCellsBySection) {
  const MeshFile file = read(kNodes +
                             "*ELEMENT, TYPE=CPS4, ELSET=a\n1, 10, 20, 30, 40\n"
                             "*ELEMENT, TYPE=CPS4, ELSET=b\n2, 20, 70, 80, 30\n"
                             "*ELSET, ELSET=whole\n a, B\n"
                             "*SOLID SECTION, ELSET=WHOLE, MATERIAL=steel\n");
  EXPECT_EQ(file.group_names, (std::vector<std::string>{"", "elset WHOLE"}));
  EXPECT_EQ(file.mesh.cells().group(0), 1u);
  EXPECT_EQ(file.mesh.cells().group(1), 1u);
}

TEST(Inp, ListsTheMembersOfASetOnceHoweverOftenItNamesThem) {
  const MeshFile file = read(kNodes +
                             "*ELEMENT, TYPE=CPS4, ELSET=e\n1, 10, 20, 30, 40\n*NSET, NSET=many, "
                             "GENERATE\n10, 40, 10\n20, 80, 10\n10, 80, 10\n");
  const auto many = std::ranges::find(file.sets, "many", &NamedSet::name);
  ASSERT_NE(many, file.sets.end());
  EXPECT_EQ(many->vertices(file.mesh.cells()).size(), 6u);
}

TEST(Inp, KnowsSetsByNumbersRangesAndNames) {
  const MeshFile file = read(kNodes +
                             "*ELEMENT, TYPE=CPS4\n1, 10, 20, 30, 40\n2, 20, 70, 80, 30\n"
                             "*NSET, NSET=few\n10, 40,\n20\n"
                             "*NSET, NSET=many, GENERATE\n20, 1000000000, 10\n"
                             "*NSET, NSET=both\nfew, 80\n"
                             "*NSET, NSET=of cell, ELSET=second\n"
                             "*ELSET, ELSET=second\n2\n"
                             "*NSET, NSET=few\n30\n");
  EXPECT_EQ(set_of(file, "nset", "few"), (Numbers{0, 1, 2, 3}));
  EXPECT_EQ(set_of(file, "nset", "many"), (Numbers{1, 2, 3, 4, 5}));
  EXPECT_EQ(set_of(file, "nset", "both"), (Numbers{0, 1, 2, 3, 5}));
  EXPECT_EQ(set_of(file, "nset", "of cell"), (Numbers{1, 2, 4, 5}));
  EXPECT_EQ(set_of(file, "elset", "second"), (Numbers{1, 2, 4, 5}));
}

TEST(Inp, SetsThatNameEachOtherInACircleEnd) {
  const MeshFile file = read(kNodes + "*NSET, NSET=a\nb, 10\n*NSET, NSET=b\na, 20\n");
  EXPECT_EQ(set_of(file, "nset", "a"), (Numbers{0, 1}));
}

TEST(Inp, HoldsNodesThatLoadsAndSupportsName) {
  const MeshFile file = read(kNodes +
                             "*ELEMENT, TYPE=CPS4\n1, 10, 20, 30, 40\n2, 20, 70, 80, 30\n"
                             "*ELEMENT, TYPE=B31\n3, 20, 30\n"
                             "*NSET, NSET=foot\n10\n*BOUNDARY\nFOOT, 1, 3\n"
                             "*STEP\n*CLOAD\n80, 2, -1.\n*END STEP\n");
  EXPECT_EQ(file.held.vertices, (Numbers{0, 1, 2, 5}));
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_TRUE(file.notes[0].ends_with("their nodes stay: 1, the first of type B31."));
}

TEST(Inp, TakesNoNumberInAnEquationForANodeThatIsNone) {
  const MeshFile file = read(kNodes +
                             "*NSET, NSET=side\n80\n*EQUATION\n2\n40, 10, 1., side, 20, -1.\n"
                             "*MPC\n30, 70\n*TRANSFORM, NSET=side\n10, 0, 0, 20, 0, 0\n"
                             "*KINEMATIC\n10, 20\n");
  EXPECT_EQ(file.held.vertices, (Numbers{3, 4, 5}));
}

TEST(Inp, PartsHaveNumbersOfTheirOwn) {
  const MeshFile file = read(
      "*PART, NAME=One\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n*ELEMENT, TYPE=S3\n1, 1, 2, 3\n"
      "*END PART\n*PART, NAME=Two\n*NODE\n1, 5, 0, 0\n2, 6, 0, 0\n3, 5, 1, 0\n*ELEMENT, TYPE=S3\n"
      "1, 1, 2, 3\n*NSET, NSET=tip\n3\n*END PART\n*ASSEMBLY, NAME=all\n"
      "*INSTANCE, NAME=Two-1, PART=Two\n*END INSTANCE\n"
      "*NSET, NSET=top, INSTANCE=Two-1\n2\n*END ASSEMBLY\n"
      "*BOUNDARY\nTwo-1.tip, 1\n");
  EXPECT_EQ(cell_of(file, 1), (Numbers{3, 4, 5}));
  EXPECT_EQ(set_of(file, "nset", "Two.tip"), (Numbers{5}));
  EXPECT_EQ(set_of(file, "nset", "top"), (Numbers{4}));
  EXPECT_EQ(file.held.vertices, (Numbers{5}));
}

TEST(Inp, NodesInTheMiddleOfEdgesFollowTheirCorners) {
  const MeshFile file = read(
      "*NODE\n1,0,0,0\n2,2,0,0\n3,0,2,0\n4,0,0,2\n5,1,0,0\n6,1,1,0\n7,0,1,0.25\n8,0,0,1\n9,1,0,1\n"
      "10,0,1,1\n*ELEMENT, TYPE=C3D10\n1, 1,2,3,4,5,6,7,8,9,10\n");
  ASSERT_EQ(file.mesh.cells().size(), 1u);
  EXPECT_EQ(file.mesh.cells().kind(0), CellKind::tet);
  EXPECT_EQ(file.followers.size(), 6u);
  EXPECT_EQ(file.followers.curved(file.mesh.points()), 1u);
  std::vector<Vec3> points = testing::points_of(file);
  points[2] = Vec3(0, 4, 0);
  const std::vector<Vec3> wanted = file.representable(points);
  EXPECT_EQ(wanted[5], Vec3(1, 2, 0));
  EXPECT_EQ(wanted[6], Vec3(0, 2, 0.25));
  EXPECT_EQ(wanted[4], Vec3(1, 0, 0));
}

TEST(Inp, ReplacesOnlyTheCoordinatesThatMoved) {
  const std::string text =
      "*HEADING\r\n a ** b\r\n** 1, 2, 3, 4\r\n*node\r\n 1,\t0.10D+00 , "
      "0.00,0\r\n2,1,0,0\r\n3,0,1,0"
      "\r\n*element, type=S3\r\n1,1,2,3";
  const MeshFile file = read(text);
  std::vector<Vec3> points = testing::points_of(file);
  EXPECT_EQ(written(file, points), text);
  points[0] = Vec3(0.1, -1.2345678901234567e-5, 7);
  std::string expected = text;
  expected.replace(expected.find("0.00,0\r"), 6, "-1.2345678901235e-05,7");
  EXPECT_EQ(written(file, file.representable(points)), expected);
  // Abaqus and CalculiX read 20 characters of a number.
  EXPECT_EQ(std::string_view("-1.2345678901235e-05").size(), 20u);
}

TEST(Inp, RefusesWhatWouldBreakAndSaysWhere) {
  const std::vector<testing::Refusal> cases = {
      {"*HEADING\n", ": has no *NODE"},
      {"*NODE\n1, 0, 0, 0\n1, 1, 0, 0\n", ":3: node 1 is there twice"},
      {"*NODE\n1, 0, x, 0\n", ":2: 'x' is not a number (a coordinate of node 1)"},
      {"*NODE\n1, 0, , 0\n", ":2: a coordinate is left out"},
      {"*NODE\n1, 0\n", ":2: node 1 has 1 of 3 coordinates"},
      {"*NODE\n1, 0, 0\n2, 0, 0, 0\n", ":3: node 2 has 3 coordinates where others have 2"},
      {"*NODE, SYSTEM=C\n1, 0, 0, 0\n", ":1: the nodes are in cylindrical"},
      {"*NODE, INPUT=n.txt\n", ":1: the nodes are in another file"},
      {"*NODE\n1, 0, 0, 0\n*NGEN\n1, 2\n", ":3: *NGEN makes nodes"},
      {"*NODE\n1, 0, 0, 0\n*INCLUDE, INPUT=/there/is/no.inp\n", ":3: an included file"},
      {kNodes + "*ELEMENT, TYPE=S3\n1, 10, 20, 99\n", ":9: element 1 uses node 99"},
      {kNodes + "*ELEMENT, TYPE=S3\n1, 10, 20\n*STEP\n", ":10: element 1 has 2 nodes where"},
      {kNodes + "*ELEMENT, TYPE=S3\n1, 10, 20, 30\n1, 10, 30, 40\n", ":10: element 1 is there"},
      {kNodes + "*NSET, NSET=a, GENERATE\n5, 1\n", ":9: GENERATE takes"},
      {kNodes + "*ELEMENT, TYPE=CPS6\n1, 10, 70, 80, 20, 30, 40\n*ELEMENT, TYPE=CPS3\n2,10,20,40\n",
       ":3: node 20 is a corner of one element and in the middle"}};
  testing::expect_refusals("a.inp", cases);
}

TEST(Inp, ReadsSetsOfIncludedFilesButNoMesh) {
  const testing::TemporaryFolder folder;
  folder.write("sets.inp", "*NSET, NSET=there\n30\n");
  folder.write("mesh.inp", "*NODE\n99, 0, 0, 0\n");
  const auto deck = [&](const std::string& name) {
    return folder.write("a.inp", kNodes + "*INCLUDE, INPUT=" + name + "\n");
  };
  EXPECT_EQ(set_of(read_mesh(deck("sets.inp")), "nset", "there"), (Numbers{2}));
  EXPECT_THROW(read_mesh(deck("mesh.inp")), IoError);
}

TEST(Inp, KnowsElementTypes) {
  EXPECT_EQ(inp_element_type("C3D20R")->kind, CellKind::hex);
  EXPECT_EQ(inp_element_type("C3D20R")->nodes, 20u);
  EXPECT_EQ(inp_element_type("STRI65")->nodes, 6u);
  EXPECT_EQ(inp_element_type("M3D4R")->kind, CellKind::quad);
  EXPECT_EQ(inp_element_type("SC6R")->kind, CellKind::wedge);
  EXPECT_EQ(inp_element_type("S8R5")->nodes, 8u);
  for (const char* none :
       {"B31", "T3D2", "SPRINGA", "MASS", "COH3D8", "SAX1", "R2D2", "U1", "S", ""}) {
    EXPECT_FALSE(inp_element_type(none)) << none;
  }
}

TEST(Inp, ReadsOrRefusesEveryBeginningOfADeck) {
  EXPECT_GT(
      readable_beginnings(kNodes + "*ELEMENT, TYPE=CPS4,\n ELSET=a\n1, 10, 20,\n30, 40\n"
                                   "*NSET, NSET=\"b c\", GENERATE\n10,30,10\n*EQUATION\n2\n10,1,1."
                                   ",20,1,-1.\n",
                          "a.inp"),
      0);
}

}  // namespace
}  // namespace evenmesh
