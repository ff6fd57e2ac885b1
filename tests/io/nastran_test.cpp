// SPDX-License-Identifier: MIT
#include "evenmesh/io/nastran.h"

#include <cmath>

#include <gtest/gtest.h>

#include "evenmesh/io/nastran_cards.h"
#include "tests/io/patch_checker.h"
#include "tests/io/read_text.h"
#include "tests/support/random.h"

namespace evenmesh {
namespace {

using testing::cell_of;
using testing::points_of;
using testing::read_bytes;
using testing::read_text;
using testing::source_dir;
using testing::written;
using Numbers = std::vector<Index>;

double real(std::string_view text) {
  double value = std::nan("");
  return scan_nastran_real(text, value) ? value : std::nan("");
}

TEST(NastranNumbers, AreReadInAllTheirForms) {
  EXPECT_EQ(real("1.5"), 1.5);
  EXPECT_EQ(real(".5"), 0.5);
  EXPECT_EQ(real("-7."), -7.0);
  EXPECT_EQ(real("1.43-13"), 1.43e-13);
  EXPECT_EQ(real("1.+5"), 1e5);
  EXPECT_EQ(real("-.5D-2"), -0.005);
  EXPECT_EQ(real("1.5e3"), 1500.0);
  for (const char* word : {"", "x", "1.2.3", "1-", "--1.", "1.5ee3", "1.e400", "nan", "inf"}) {
    EXPECT_TRUE(std::isnan(real(word))) << word;
  }
}

TEST(NastranNumbers, AreWrittenAsExactlyAsTheirFieldAllows) {
  EXPECT_EQ(nastran_real(0.0, 8), "0.");
  EXPECT_EQ(nastran_real(1.0, 8), "1.");
  EXPECT_EQ(nastran_real(-0.25, 8), "-.25");
  EXPECT_EQ(nastran_real(1.0 / 3.0, 8), ".3333333");
  EXPECT_EQ(nastran_real(-1.0 / 3.0, 8), "-.333333");
  EXPECT_EQ(nastran_real(1.0 / 3.0, 16), ".333333333333333");
  EXPECT_EQ(nastran_real(123456.789, 8), "123456.8");
  EXPECT_EQ(nastran_real(99999999.0, 8), "1.+8");
  EXPECT_EQ(nastran_real(1.43e-13, 8), "1.43-13");
  EXPECT_EQ(nastran_real(1.23456789e-5, 8), "1.2346-5");
  EXPECT_EQ(nastran_real(-1.23456789e-105, 8), "-1.2-105");
  EXPECT_EQ(nastran_real(9.99999999, 8), "10.");
}

TEST(NastranNumbers, ThatWereWrittenAreWrittenTheSame) {
  shapes::Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const double size = std::pow(10.0, 12.0 * random.signed_unit());
    const double value = random.signed_unit() * size;
    for (const std::size_t width : {7u, 8u, 15u, 16u}) {
      const std::string text = nastran_real(value, width);
      ASSERT_LE(text.size(), width);
      ASSERT_NE(text.find('.'), std::string::npos);
      const double read = real(text);
      ASSERT_LE(std::abs(read - value),
                std::abs(value) * std::pow(10.0, 6.0 - static_cast<double>(width)))
          << text;
      ASSERT_EQ(real(nastran_real(read, width)), read) << text;
    }
  }
}

MeshFile deck() { return read_mesh(source_dir() / "fuzz/corpus/nastran/deck.bdf"); }

TEST(Nastran, ReadsFieldsOfEveryForm) {
  const MeshFile file = deck();
  ASSERT_EQ(file.mesh.point_count(), 6u);  // what follows ENDDATA is none of the deck
  EXPECT_EQ(file.mesh.points()[1], Vec3(1, 0, 0));
  EXPECT_EQ(file.mesh.points()[2], Vec3(1, 1, 0));
  EXPECT_EQ(file.mesh.points()[3], Vec3(0, 1, 1.43e-13));
  EXPECT_EQ(file.mesh.points()[4], Vec3(0.5, 0.5, 1.5));
  EXPECT_EQ(file.mesh.points()[5], Vec3(0.5, 0.5, 0));
  ASSERT_EQ(file.mesh.cells().size(), 3u);
  EXPECT_EQ(cell_of(file, 0), (Numbers{0, 1, 5}));
  EXPECT_EQ(file.mesh.cells().kind(2), CellKind::tet);
  EXPECT_EQ(file.group_names,
            (std::vector<std::string>{"", "property 7", "property 12", "property 8"}));
  // The support holds 1 and 2, the load 4, the rigid element 5 and the grids that it weighs.
  EXPECT_EQ(file.held.vertices, (Numbers{0, 1, 2, 3, 4}));
  EXPECT_EQ(file.patch->cell_name(1), "element 12 (line 15)");
  EXPECT_EQ(file.patch->vertex_name(2), "GRID 3 (line 9)");
}

TEST(Nastran, WritesIntoTheFieldsThatAreThere) {
  const MeshFile file = deck();
  const std::string before = read_bytes(source_dir() / "fuzz/corpus/nastran/deck.bdf");
  EXPECT_EQ(written(file, file.mesh.points()), before);
  std::vector<Vec3> points = points_of(file);
  points[0].x() = 1.0 / 3.0;
  points[1].y() = -2.5;
  points[2].z() = 1.0 / 3.0;
  points[3].z() = -1e-9;
  points[4].x() = 1.0 / 3.0;
  points[5] += Vec3(0, 0.25, 0.125);
  const std::vector<Vec3> rounded = file.representable(points);
  EXPECT_EQ(rounded[0].x(), 0.3333333);
  EXPECT_EQ(rounded[2].z(), 0.333333333333333);
  EXPECT_EQ(rounded[4].x(), 0.333333);  // one less, so that the tab goes where it went
  std::string after = before;
  const auto change = [&after](const std::string& from, const std::string& to) {
    const std::size_t at = after.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    after.replace(at, from.size(), to);
  };
  change("1               0.      0.      0.", "1               .33333330.      0.");
  change("1.              0.      $", "1.      -2.5    0.      $");
  change("*                    0.0", "*       .333333333333333");
  change("1.0,1.43-13", "1.0,-1.-9");
  change("\t.5\t.5", "\t.333333\t.5");
  change("0.5     0.5\n", "0.5     .75     .125\n");
  EXPECT_EQ(written(file, rounded), after);
  const MeshFile again = read_text(after, "a.bdf");
  EXPECT_EQ(points_of(again), rounded);
}

TEST(Nastran, CoordinatesBehindTheEndOfALineAreAppended) {
  const MeshFile file = read_text(
      "GRID    1\nGRID    2               1.\nGRID    3               1.      1.\n"
      "CTRIA3  1       1       1       2       3\n",
      "a.bdf");
  std::vector<Vec3> points = points_of(file);
  points[0] = Vec3(0, 0.5, -0.25);
  points[1].z() = 2;
  EXPECT_EQ(
      written(file, points),
      "GRID    1                       .5      -.25\nGRID    2               1.              2.\n"
      "GRID    3               1.      1.\nCTRIA3  1       1       1       2       3\n");
}

TEST(Nastran, CoordinatesBetweenTabsOrBehindCommasFindTheirPlace) {
  const std::string deck =
      "GRID,1,,.5 $ y and z are not there\nGRID\t2\t\t1.5\t\t\t\nGRID\t3\t\t\t 2.\n"
      "GRID*\t\t4\t\t\t3.\t\t4.\nGRID*  \t       5\t\t        5.5             6.\n"
      "CQUAD4,1,,1,2,3,4\n";
  const MeshFile file = read_text(deck, "a.bdf");
  std::vector<Vec3> points = points_of(file);
  EXPECT_EQ(points[1], Vec3(1.5, 0, 0));
  EXPECT_EQ(points[2], Vec3(0, 2, 0));
  EXPECT_EQ(points[4], Vec3(5.5, 6, 0));
  for (Vec3& p : points) p += Vec3(1.0 / 3, 0.25, 0.125);
  points = file.representable(points);
  EXPECT_EQ(points[0], Vec3(.8333333, 0.25, 0.125));
  EXPECT_EQ(points[1], Vec3(1.83333, 0.25, 0.125));
  EXPECT_EQ(points[4].z(), 0);  // there is no second line to write it to
  const std::string after = written(file, points);
  EXPECT_EQ(points_of(read_text(after, "a.bdf")), points) << after;
  EXPECT_EQ(after.substr(0, after.find('\n')), "GRID,1,,.8333333,.25,.125 $ y and z are not there");
}

TEST(Nastran, RangesOfGridsMayOverlap) {
  std::string deck;
  for (const int grid : {1, 2, 5, 7, 8, 9, 12, 20}) deck += "GRID," + std::to_string(grid) + "\n";
  const MeshFile file = read_text(
      deck + "SPC1,1,1,5,THRU,9\nSPC1,1,1,2,THRU,7\nSPC1,1,1,12,THRU,12\nSPC1,1,1,13,THRU,19\n",
      "a.bdf");
  EXPECT_EQ(file.held.vertices, (Numbers{1, 2, 3, 4, 5, 6}));
}

TEST(Nastran, MiddlesOfEdgesMayBeLeftOut) {
  const MeshFile file = read_mesh(source_dir() / "fuzz/corpus/nastran/second.bdf");
  EXPECT_EQ(file.followers.size(), 3u);
  const MeshFile fewer = read_text(
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,1.,0.\nGRID,5,,.5,.5,0.\nCTRIA6,1,1,1,2,3,,"
      "5\n",
      "a.bdf");
  ASSERT_EQ(fewer.followers.size(), 1u);
  EXPECT_EQ(fewer.followers.leaders(0)[0], 1u);
  EXPECT_EQ(fewer.followers.leaders(0)[1], 2u);
}

TEST(Nastran, DecksMayBeginWithTheirFirstCard) {
  const std::string bulk = "GRID,1\nGRID,2,,1.\nGRID,3,,,1.\nCTRIA3,1,,1,2,3\n";
  EXPECT_EQ(read_text(bulk, "a.dat").mesh.cells().size(), 1u);
  EXPECT_EQ(read_text("$ a comment\r\n\r\n" + bulk, "a").mesh.cells().size(), 1u);
  EXPECT_EQ(read_text("ID a,b\nSOL 1\nCEND\nBEGIN BULK $\n" + bulk, "a").mesh.cells().size(), 1u);
}

TEST(Nastran, BrokenDecksAreRefusedWithTheLine) {
  const std::string grids = "GRID,1\nGRID,2,,1.\nGRID,3,,,1.\n";
  testing::expect_refusals(
      "a.bdf",
      {{"SOL 101\nCEND\nBEGIN BULK\n", ": has no GRID"},
       {"GRID,1,7,0.,0.,0.\n", ":1: GRID 1 is in coordinate system 7"},
       {"GRDSET,,7\nGRID,1\n", ":1: GRDSET is in coordinate system 7"},
       {"GRID,x,,0.\n", ":1: GRID has 'x' where its number should be"},
       {"GRID,1,,0.x\n", ":1: '0.x' is no coordinate (of GRID 1)"},
       {"GRID,1\nGRID,1\n", ":2: GRID 1 is there twice"},
       {"GRID,1\nINCLUDE 'mesh.bdf'\n", ":2: INCLUDE: put what is in that file here"},
       {grids + "CTRIA3,4,,1,2,9\n", ":4: CTRIA3 4 uses GRID 9, which the file does not have"},
       {grids + "CTRIA3,4,,1,2\n", ":4: CTRIA3 4 has '' for its grid 3"},
       {grids + "CTRIA3,,,1,2,3\n", ":4: CTRIA3 has '' where its number should be"},
       {grids + "GRID,4\nCTRIA6,1,,1,2,3,4\nCTRIA3,2,,1,4,3\n",
        ":4: GRID 4 is a corner of one element and in the middle of an edge of another"}});
  for (const char* name : {"deck.bdf", "second.bdf"}) {
    testing::readable_beginnings(read_bytes(source_dir() / "fuzz/corpus/nastran" / name), "a.bdf");
  }
}

TEST(Ucd, ReadsCellsInTheOrderOfItsNodes) {
  const MeshFile file = read_mesh(source_dir() / "fuzz/corpus/ucd/mixed.inp");
  ASSERT_EQ(file.mesh.cells().size(), 3u);
  EXPECT_EQ(cell_of(file, 0), (Numbers{0, 1, 2, 3, 4, 5, 6, 3}));  // the top comes first
  EXPECT_EQ(cell_of(file, 1), (Numbers{0, 1, 2, 3, 7}));           // the apex comes first
  EXPECT_EQ(file.group_names, (std::vector<std::string>{"", "material 7", "material 2"}));
  EXPECT_EQ(file.held.vertices, (Numbers{0, 1, 2, 3}));  // the rim of material 2
  EXPECT_EQ(file.patch->vertex_numbers()[7], 10u);
  EXPECT_EQ(file.patch->cell_name(1), "cell 2 (line 12)");
  std::vector<Vec3> points = points_of(file);
  points[7].z() = 2.5;
  std::string text = read_bytes(source_dir() / "fuzz/corpus/ucd/mixed.inp");
  text.replace(text.find("0.5 0.5 2"), 9, "0.5 0.5 2.5");
  EXPECT_EQ(written(file, points), text);
}

TEST(Ucd, BrokenFilesAreRefusedWithTheLine) {
  testing::expect_refusals(
      "a.inp", {{"0 0 0 0 0\n", ": has no nodes"},
                {"9 1 0 0 0\n1 0 0 0\n", ":1: promises 9 nodes"},
                {"1 9 0 0 0\n1 0 0 0\n1 0 pt 1\n", ":2: promises 9 cells"},
                {"2 0 0 0 0\n1 0 0 0\n1 0 0 1\n", ":3: node 1 is there twice"},
                {"1 1 0 0 0\n1 0 0 0\n1 0 sphere 1\n", ":3: 'sphere' is no type of cell"},
                {"1 1 0 0 0\n1 0 0 0\n1 0 pt 7\n", ":3: cell 1 uses node 7"},
                {"1 1 0 0 0\n1 0 0 nan\n1 0 pt 1\n", ":2: 'nan' is not a finite number"},
                {"1 1 0 0\n1 0 0 0\n", ": is a .inp file, but neither a deck"}});
}

}  // namespace
}  // namespace evenmesh
