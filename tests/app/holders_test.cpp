// SPDX-License-Identifier: MIT
#include "apps/evenmesh/holders.h"

#include <gtest/gtest.h>

#include "tests/app/patch_stub.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using Lines = std::vector<std::string>;

// A grid of 3 x 3 vertices of which the first two are fixed.
class HoldersOfAGrid : public ::testing::Test {
 protected:
  HoldersOfAGrid() {
    std::vector<char> fixed(mesh_.point_count(), 0);
    fixed[0] = fixed[1] = 1;
    problem_.orientation = find_orientation(mesh_);
    problem_.motion = Motion(mesh_, problem_.orientation, fixed);
    holding_.of_vertex.assign(mesh_.point_count(), 0.0f);
  }
  Lines of_cell(std::size_t cell) const {
    return app::Holders(problem_, holding_, names_).of_cell(cell, mesh_.cells().vertices(cell));
  }

  const Mesh mesh_ = shapes::quad_grid(2);  // cell 0: vertices 0, 1, 4, 3
  const testing::PatchStub names_;
  Problem problem_;
  Holding holding_;
};

TEST_F(HoldersOfAGrid, AreNoneWhereNothingHolds) {
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(of_cell(c), Lines{});
}

TEST_F(HoldersOfAGrid, AreNoneWhereNothingWasSolved) {
  holding_ = {};
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(of_cell(c), Lines{});
}

TEST_F(HoldersOfAGrid, AreItsVerticesWhereAllAreFixed) {
  for (const Index v : mesh_.cells().vertices(2)) problem_.motion.fix(v);
  EXPECT_EQ(of_cell(2), Lines{"all its vertices are fixed"});
  EXPECT_EQ(of_cell(1), Lines{});
  holding_ = {};
  EXPECT_EQ(of_cell(2), Lines{"all its vertices are fixed"});
}

TEST_F(HoldersOfAGrid, ComeTheStrongestFirst) {
  holding_.of_vertex[0] = 2.0f;
  holding_.of_vertex[1] = 3.0f;
  holding_.of_vertex[3] = 9.0f;  // free: a gradient that is left, no constraint
  holding_.cells = {{0, 2.5, 0.0}};
  holding_.moves = {{4, 4.0, 0.0}};
  EXPECT_EQ(of_cell(0),
            (Lines{"vertex 4 has gone as far as it may (multiplier 4)",
                   "vertex 1 is fixed (multiplier 3)", "it is at its least size (multiplier 2.5)",
                   "vertex 0 is fixed (multiplier 2)"}));
}

TEST_F(HoldersOfAGrid, AreThoseOfTheCellAndNoOther) {
  holding_.cells = {{1, 1.0, 0.5}, {3, 2.0, 0.0}};
  holding_.moves = {{2, 8.0, 0.0}, {6, 16.0, 0.0}};
  EXPECT_EQ(of_cell(0), Lines{});
  EXPECT_EQ(of_cell(1), (Lines{"vertex 2 has gone as far as it may (multiplier 8)",
                               "its least size is not met (multiplier 1)"}));
  EXPECT_EQ(of_cell(2), Lines{"vertex 6 has gone as far as it may (multiplier 16)"});
  EXPECT_EQ(of_cell(3), Lines{"it is at its least size (multiplier 2)"});
}

}  // namespace
}  // namespace evenmesh
