// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/prescribe.h"

#include <string>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

const std::vector<Vec3> kPoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 6, 7}};

std::vector<Target> read(std::string_view text, Index first_id = 1) {
  return read_targets(text, kPoints, first_id);
}

std::string complaint(std::string_view text, Index first_id = 1) {
  try {
    read(text, first_id);
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "";
}

void expect_same(const std::vector<Target>& found, const std::vector<Target>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].vertex, expected[i].vertex);
    EXPECT_EQ(found[i].position, expected[i].position);
  }
}

#define EXPECT_SAYS(text, part) \
  EXPECT_NE(complaint(text).find(part), std::string::npos) << complaint(text)

TEST(ReadTargets, TakesPositionsWithAndWithoutAHeader) {
  const std::vector<Target> expected{{0, Vec3(0.5, -1e-3, 2)}, {3, Vec3(1, 2, 3)}};
  expect_same(read("1,0.5,-1e-3,2\n4,1,2,3\n"), expected);
  expect_same(read("id,x,y,z\n4,1,2,3\n1,0.5,-1e-3,2"), expected);
  expect_same(read("0,.5,-1e-3,+2\n3,1,2,3\n", 0), expected);
}

TEST(ReadTargets, TakesDisplacements) {
  expect_same(read("id,dx,dy,dz\n4,1,2,3\n2,0,0,-1\n"), {{1, Vec3(1, 0, -1)}, {3, Vec3(6, 8, 10)}});
  expect_same(read(" ID ; dX; dy ;DZ \n4;1;2;3\n"), {{3, Vec3(6, 8, 10)}});
}

TEST(ReadTargets, TakesAnySeparatorAndComments) {
  const std::vector<Target> expected{{1, Vec3(1, 2, 3)}};
  for (const auto text :
       {"2;1;2;3", "2 1 2 3", "2\t1\t2\t3", "  2 ,1 , 2,  3  ", "2  1   2 3 # why",
        "# first\n\n \t\n2,1,2,3\r\n#2,9,9,9\n", "\xef\xbb\xbfid,x,y,z\r\n2,1,2,3\r\n"}) {
    expect_same(read(text), expected);
  }
  EXPECT_TRUE(read("").empty());
  EXPECT_TRUE(read("# nothing\nid x y z\n").empty());
}

TEST(ReadTargets, TakesAVertexTwiceIfItIsTheSame) {
  expect_same(read("2,1,2,3\n2,1.0,2,3"), {{1, Vec3(1, 2, 3)}});
  EXPECT_SAYS("id,x,y,z\n3,0,0,0\n2,1,2,3\n3,0,0,1\n", "line 4: vertex 3 was sent");
  EXPECT_SAYS("id,x,y,z\n3,0,0,0\n2,1,2,3\n3,0,0,1\n", "in line 2");
}

TEST(ReadTargets, SaysWhatIsWrongAndWhere) {
  EXPECT_SAYS("1,1,2,3\n\n1,2,3\n", "line 3: '1,2,3' has 3 columns instead of 4");
  EXPECT_SAYS("1,1,2,3,\n", "has 5 columns");
  EXPECT_SAYS("1;0,5;1,5;2", "with a point");
  EXPECT_SAYS("vertex,x,y,z\n", "line 1: the header 'vertex,x,y,z' is not known");
  EXPECT_SAYS("1,1,2,3\nid,x,y,z\n", "line 2: 'id' is no vertex number");
  EXPECT_SAYS("1.5,1,2,3", "'1.5' is no vertex number");
  EXPECT_SAYS("-1,1,2,3", "'-1' is no vertex number");
  EXPECT_SAYS("0,1,2,3", "there is no vertex 0: this mesh numbers its vertices 1 to 4");
  EXPECT_SAYS("5,1,2,3", "no vertex 5");
  EXPECT_SAYS("99999999999999999999999,1,2,3", "no vertex 9999");
  EXPECT_SAYS("1,1,zwei,3", "'zwei' is no number");
  EXPECT_SAYS("1,1,,3", "'' is no number");
  EXPECT_SAYS("1,1,2m,3", "'2m' is no number");
  EXPECT_SAYS("1,1,+-2,3", "'+-2' is no number");
  for (const auto text : {"1,nan,0,0", "1,0,inf,0", "1,0,0,-inf", "1,1e999,0,0"}) {
    EXPECT_SAYS(text, "no finite number");
  }
  EXPECT_SAYS("1,\x1b[2J,0,0", "'?[2J'");
  EXPECT_EQ(complaint("4,1,2,3"), "");
  EXPECT_NE(complaint("4,1,2,3", 0), "");
}

TEST(TargetsFrom, TakesWhatDiffersOrTheMask) {
  const Mesh mesh = shapes::quad_grid(2);
  Mesh moved = mesh;
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  points[4] = Vec3(0.25, 0.5, 1);
  points[7].x() = 0.125;
  moved.set_points(points);
  expect_same(targets_from(mesh, moved), {{4, points[4]}, {7, points[7]}});
  std::vector<char> mask(9, 0);
  mask[0] = mask[7] = 1;
  expect_same(targets_from(mesh, moved, mask), {{0, points[0]}, {7, points[7]}});
  EXPECT_THROW(targets_from(mesh, shapes::quad_grid(3)), InvalidOption);
}

}  // namespace
}  // namespace evenmesh
