// SPDX-License-Identifier: MIT
#include "evenmesh/io/second_order.h"

#include <gtest/gtest.h>

#include "tests/io/read_text.h"

namespace evenmesh {
namespace {

/// The nodes of an ideal cell where VTK's manual puts them, corners first.
std::vector<Vec3> ideal_corners(CellKind kind) {
  std::vector<Vec3> points;
  for (const auto& p : traits(kind).ideal) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

Followers followers_of(CellKind kind, EdgeOrder order, std::size_t nodes) {
  std::vector<Index> numbers(nodes);
  for (Index i = 0; i < nodes; ++i) numbers[i] = i;
  Followers followers;
  add_followers(kind, order, numbers, followers);
  return followers;
}

std::vector<std::vector<Index>> leaders_of(CellKind kind, EdgeOrder order, std::size_t nodes) {
  const Followers followers = followers_of(kind, order, nodes);
  std::vector<std::vector<Index>> result;
  for (std::size_t i = 0; i < followers.size(); ++i) {
    const auto leaders = followers.leaders(i);
    result.emplace_back(leaders.begin(), leaders.end());
  }
  return result;
}

TEST(SecondOrder, EveryEdgeHasOneMiddleInEveryOrder) {
  for (const EdgeOrder order : {EdgeOrder::levels, EdgeOrder::gmsh, EdgeOrder::nastran}) {
    for (const CellKind kind : {CellKind::triangle, CellKind::quad, CellKind::tet, CellKind::hex,
                                CellKind::wedge, CellKind::pyramid}) {
      const std::size_t edges = traits(kind).edges.size();
      auto leaders =
          leaders_of(kind, order, static_cast<std::size_t>(traits(kind).vertices) + edges);
      ASSERT_EQ(leaders.size(), edges);
      std::vector<std::vector<Index>> wanted;
      for (const auto edge : traits(kind).edges) wanted.push_back({edge.a, edge.b});
      std::sort(leaders.begin(), leaders.end());
      std::sort(wanted.begin(), wanted.end());
      EXPECT_EQ(leaders, wanted) << traits(kind).name;
    }
  }
}

TEST(SecondOrder, GmshListsEdgesByTheirLowerCorner) {
  // As in the manual of Gmsh, section "Node ordering".
  const auto tet = leaders_of(CellKind::tet, EdgeOrder::gmsh, 10);
  EXPECT_EQ(tet[4], (std::vector<Index>{2, 3}));
  EXPECT_EQ(tet[5], (std::vector<Index>{1, 3}));
  const auto hex = leaders_of(CellKind::hex, EdgeOrder::gmsh, 27);
  EXPECT_EQ(hex[1], (std::vector<Index>{3, 0}));
  EXPECT_EQ(hex[2], (std::vector<Index>{0, 4}));
  EXPECT_EQ(hex[12], (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(hex[17], (std::vector<Index>{4, 5, 6, 7}));
  EXPECT_EQ(hex[18].size(), 8u);
}

TEST(SecondOrder, NastranListsUprightEdgesBeforeThoseOnTop) {
  const auto hex = leaders_of(CellKind::hex, EdgeOrder::nastran, 20);
  EXPECT_EQ(hex[3], (std::vector<Index>{3, 0}));
  EXPECT_EQ(hex[4], (std::vector<Index>{0, 4}));
  EXPECT_EQ(hex[8], (std::vector<Index>{4, 5}));
  const auto wedge = leaders_of(CellKind::wedge, EdgeOrder::nastran, 15);
  EXPECT_EQ(wedge[3], (std::vector<Index>{0, 3}));
  EXPECT_EQ(wedge[6], (std::vector<Index>{3, 4}));
}

TEST(SecondOrder, MiddlesMoveByTheMeanOfTheirCorners) {
  std::vector<Vec3> before = ideal_corners(CellKind::triangle);
  before.emplace_back(0.5, 0.1, 0);  // a curved edge
  const std::vector<Index> leaders = {0, 1};
  Followers followers;
  followers.add(3, leaders);
  followers.add(3, leaders);
  ASSERT_EQ(followers.size(), 1u);
  EXPECT_EQ(followers.curved(before), 1u);
  std::vector<Vec3> points = before;
  points[2] = Vec3(0, 5, 0);
  points[3] = Vec3(9, 9, 9);
  followers.follow(before, points);
  EXPECT_EQ(points[3], before[3]);
  points[0] += Vec3(0, 0, 2);
  followers.follow(before, points);
  EXPECT_EQ(points[3], Vec3(0.5, 0.1, 1));
}

TEST(SecondOrder, GmshFilesAreReadAndTheirMiddlesFollow) {
  const std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 1 0 0\n5 1 1 "
      "0\n"
      "6 0 1 0\n$EndNodes\n$Elements\n2\n1 8 2 0 1 1 2 4\n2 9 2 7 1 1 2 3 4 5 6\n$EndElements\n";
  const MeshFile file = testing::read_text(text, "a.msh");
  EXPECT_EQ(testing::cell_of(file, 0), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(file.followers.size(), 3u);
  std::vector<Vec3> points = testing::points_of(file);
  points[1] = Vec3(4, 0, 0);
  EXPECT_EQ(file.representable(points)[3], Vec3(2, 0, 0));
  EXPECT_EQ(file.representable(points)[4], Vec3(2, 1, 0));
}

}  // namespace
}  // namespace evenmesh
