// SPDX-License-Identifier: MIT
#include "evenmesh/io/exodus.h"

#include <gtest/gtest.h>

#include "evenmesh/io/input_file.h"
#include "tests/io/patch_checker.h"
#include "tests/io/read_text.h"

namespace evenmesh {
namespace {

using testing::cell_of;
using testing::points_of;
using testing::read_bytes;
using testing::read_text;
using testing::source_dir;
using testing::written;
using Numbers = std::vector<Index>;

std::filesystem::path seed(const char* name) { return source_dir() / "fuzz/corpus/exodus" / name; }

Numbers vertices_of(const MeshFile& file, std::size_t set) {
  return file.sets[set].vertices(file.mesh.cells());
}

TEST(Exodus, ReadsBlocksSetsAndMaps) {
  const MeshFile file = read_mesh(seed("mixed.e"));
  EXPECT_EQ(file.patch->format(), "exodus");
  ASSERT_EQ(file.mesh.point_count(), 13u);
  EXPECT_EQ(file.mesh.points()[11], Vec3(1.5, 0.5, 2.1));
  ASSERT_EQ(file.mesh.cells().size(), 5u);  // the bar is none
  EXPECT_EQ(cell_of(file, 0), (Numbers{0, 1, 3, 2, 4, 5, 7, 6}));
  EXPECT_EQ(file.mesh.cells().kind(1), CellKind::wedge);
  EXPECT_EQ(file.mesh.cells().kind(4), CellKind::quad);
  EXPECT_EQ(file.group_names, (std::vector<std::string>{"", "block body", "block 20", "block 30",
                                                        "block 40", "block skin", "block 60"}));
  EXPECT_EQ(file.patch->cell_name(3), "element 104");
  EXPECT_EQ(file.patch->vertex_name(0), "node 501");
  ASSERT_EQ(file.sets.size(), 2u);
  EXPECT_EQ(file.sets[0].kind + " " + file.sets[0].name, "nset 7");
  EXPECT_EQ(vertices_of(file, 0), (Numbers{10, 11}));
  EXPECT_EQ(file.sets[1].kind + " " + file.sets[1].name, "marker inlet");
  // Side 1 of the hex, 4 of the wedge, 3 of the shell, which is its first edge.
  EXPECT_EQ(vertices_of(file, 1), (Numbers{0, 1, 5, 4, 1, 3, 8, 0, 1}));
  // The rims of these, and the bar.
  EXPECT_EQ(file.held.vertices, (Numbers{0, 1, 3, 4, 5, 8, 12}));
  ASSERT_EQ(file.notes.size(), 1u);
}

TEST(Exodus, WritesIntoTheArraysOfItsCoordinates) {
  for (const char* name : {"mixed.e", "plane.e", "second_order.e"}) {
    const MeshFile file = read_mesh(seed(name));
    const std::string before = read_bytes(seed(name));
    EXPECT_EQ(written(file, file.mesh.points()), before);
    std::vector<Vec3> points = points_of(file);
    for (Vec3& point : points) point.head<2>() += Eigen::Vector2d(1.0 / 3.0, -0.25);
    points = file.representable(points);
    const std::string after = written(file, points);
    EXPECT_EQ(after.size(), before.size());
    EXPECT_EQ(points_of(read_text(after, "a.e")), points) << name;
    const testing::TemporaryFolder folder;
    EXPECT_EQ(testing::checker_complaint(seed(name), folder.write("after.e", after)), "");
  }
}

TEST(Exodus, PlanarFilesOfFloatsAreRounded) {
  const MeshFile file = read_mesh(seed("plane.e"));
  std::vector<Vec3> points = points_of(file);
  EXPECT_EQ(points[4], Vec3(0.4F, 0.3F, 0.0));
  points[4].x() = 1.0 / 3.0;
  EXPECT_EQ(file.representable(points)[4].x(), double{1.0F / 3.0F});
  EXPECT_EQ(vertices_of(file, 0), (Numbers{5, 6}));  // the edge of a quad of the plane
}

TEST(Exodus, NodesOfSecondOrderFollowTheRightCorners) {
  const MeshFile file = read_mesh(seed("second_order.e"));
  EXPECT_EQ(file.followers.size(), 98u);
  // Straight: each node is in the mean of its leaders, wherever it stands in its element.
  for (std::size_t i = 0; i < file.followers.size(); ++i) {
    Vec3 mean = Vec3::Zero();
    for (const Index v : file.followers.leaders(i)) mean += file.mesh.points()[v];
    mean /= static_cast<double>(file.followers.leaders(i).size());
    EXPECT_LT((mean - file.mesh.points()[file.followers.vertex(i)]).norm(), 1e-15) << i;
  }
}

TEST(Exodus, BrokenFilesAreRefused) {
  const std::string bytes = read_bytes(seed("mixed.e"));
  const auto with = [&bytes](const std::string& from, const std::string& to) {
    std::string changed = bytes;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return changed.replace(at, from.size(), to);
  };
  const auto number = [](int value) { return std::string(3, '\0') + static_cast<char>(value); };
  testing::expect_refusals(
      "a.e",
      {{with("TETRA", "NSIDE"), ": elements NSIDE with 4 nodes are not read"},
       {with("coordx", "coordX"), ": is netCDF, but its nodes have no coordx as Exodus has it"},
       {with(number(2) + number(9) + number(4), number(2) + number(99) + number(4)),
        ": has element 2 with node 99; there are 13"},
       {with("num_nodes" + std::string(3, '\0') + number(13),
             "num_nodes" + std::string(3, '\0') + number(12)),
        ": has element 6 with node 13; there are 12"},
       {bytes.substr(0, 700), ": byte "},
       {"CDF\x01" + std::string(28, '\0'), ": has no nodes"},
       {"\x89HDF\r\n\x1a\n" + std::string(100, '\0'),
        ": is an HDF5 file (MED, CGNS, or Exodus in netCDF-4, of which 'nccopy -k cdf5"}});
}

}  // namespace
}  // namespace evenmesh
