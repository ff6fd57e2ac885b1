// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/orientation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "evenmesh/mesh/extent.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

bool every_third(std::size_t cell) { return cell % 3 == 0; }
bool every(std::size_t) { return true; }

/// Cells without positive area or volume by the orientation's own standard.
std::size_t count_inverted(const Mesh& mesh, const Orientation& orientation) {
  const Cells& cells = mesh.cells();
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const auto v = cells.vertices(cell);
    const double size =
        traits(cells.kind(cell)).dimension == 3
            ? orientation.sign(cell) * volume(cells.kind(cell), mesh.points(), v, 1.0)
            : doubled_area(mesh.points(), v, 1.0).dot(orientation.up(cell));
    count += size <= 0.0;
  }
  return count;
}

TEST(Orientation, TellsPlanarSurfaceAndVolumeApart) {
  const std::map<std::string, MeshType> special{
      {"sphere_triangles", MeshType::surface}, {"cube_surface", MeshType::surface},
      {"cylinder_side", MeshType::surface},    {"moebius_strip", MeshType::surface},
      {"fan_of_three", MeshType::surface},     {"mixed_surface", MeshType::surface},
      {"tet_grid", MeshType::volume},          {"hex_grid", MeshType::volume},
      {"wedge_grid", MeshType::volume},        {"pyramid_grid", MeshType::volume}};
  for (const auto& [name, mesh] : shapes::zoo()) {
    const auto it = special.find(name);
    EXPECT_EQ(find_orientation(mesh).type, it == special.end() ? MeshType::planar : it->second)
        << name;
  }
  EXPECT_EQ(name(MeshType::planar), "planar");
}

TEST(Orientation, FindsNoCellOfTheZooInvertedButTangledOnes) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Orientation o = find_orientation(mesh);
    if (name == "tangled_triangles") {
      EXPECT_GT(count_inverted(mesh, o), 20u);
    } else {
      EXPECT_EQ(count_inverted(mesh, o), 0u) << name;
    }
    // The strip of quads is consistent but for one side; no other shape is one-sided.
    EXPECT_EQ(o.orientable, name != "moebius_strip") << name;
    EXPECT_EQ(o.against_majority, name == "wound_both_ways" ? mesh.cells().size() / 3 : 0) << name;
  }
}

TEST(Orientation, ReportsExactlyTheReversedThird) {
  for (const Mesh& mesh :
       {shapes::triangle_grid(7, 1.0, 0.2), shapes::quad_grid(8, 1.0, 0.2),
        shapes::irregular_triangles(500), shapes::tet_grid(2), shapes::hex_grid(3, 0.2),
        shapes::wedge_grid(2), shapes::pyramid_grid(2), shapes::sphere_triangles(2)}) {
    const Orientation o = find_orientation(shapes::reversed(mesh, every_third));
    EXPECT_EQ(o.against_majority, (mesh.cells().size() + 2) / 3);
    ASSERT_EQ(o.signs.size(), mesh.cells().size());
    for (std::size_t cell = 0; cell < o.signs.size(); ++cell) {
      EXPECT_EQ(o.signs[cell], every_third(cell) ? -1 : 1);
    }
    EXPECT_TRUE(o.orientable);
  }
}

TEST(Orientation, TakesAWhollyLeftHandedMeshAsItIs) {
  for (const Mesh& mesh : {shapes::hex_grid(3, 0.2), shapes::tet_grid(2)}) {
    const Mesh left = shapes::reversed(mesh, every);
    const Orientation o = find_orientation(left);
    EXPECT_EQ(o.against_majority, 0u);
    EXPECT_EQ(count_inverted(left, o), 0u);
    EXPECT_EQ(o.sign(0), -1.0);
  }
  const Mesh left = shapes::reversed(shapes::quad_grid(4), every);
  const Orientation o = find_orientation(left);
  EXPECT_EQ(o.normal, Vec3(0, 0, -1));
  EXPECT_TRUE(o.signs.empty());
  EXPECT_EQ(count_inverted(left, o), 0u);
}

TEST(Orientation, JudgesEveryPieceByItself) {
  const Mesh mesh = shapes::two_components(3);  // 18 triangles each
  const Mesh half = shapes::reversed(mesh, [](std::size_t cell) { return cell >= 18; });
  const Orientation o = find_orientation(half);
  EXPECT_EQ(o.normal, Vec3(0, 0, 1));  // a tie
  EXPECT_EQ(o.against_majority, 0u);
  EXPECT_EQ(count_inverted(half, o), 0u);
}

TEST(Orientation, SeesTangledCellsAsInvertedNotAsWoundTheOtherWay) {
  const Mesh mesh = shapes::irregular_triangles(5000, 0.3, 1, 0.9);
  const Orientation o = find_orientation(mesh);
  EXPECT_EQ(o.type, MeshType::planar);
  EXPECT_EQ(o.normal, Vec3(0, 0, 1));
  EXPECT_EQ(o.against_majority, 0u);
  EXPECT_GT(count_inverted(mesh, o), mesh.cells().size() / 5);
  // Nor if the file is wound both ways on top.
  const Orientation both = find_orientation(shapes::reversed(mesh, every_third));
  EXPECT_EQ(both.against_majority, (mesh.cells().size() + 2) / 3);
}

TEST(Orientation, IsTheSameForRenumberedMeshes) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Orientation a = find_orientation(mesh);
    shapes::Renumbering to;
    const Orientation b = find_orientation(shapes::shuffled(mesh, 11, &to));
    EXPECT_EQ(a.type, b.type) << name;
    EXPECT_EQ(a.normal, b.normal) << name;
    EXPECT_EQ(a.against_majority, b.against_majority) << name;
    EXPECT_EQ(a.orientable, b.orientable) << name;
    for (std::size_t cell = 0; cell < mesh.cells().size(); ++cell) {
      EXPECT_EQ(a.sign(cell), b.sign(to.cells[cell])) << name;
      EXPECT_EQ(a.up(cell), b.up(to.cells[cell])) << name;
    }
  }
}

TEST(Orientation, FollowsRigidMotionAndScaling) {
  const Vec3 axis(1, -2, 0.5);
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Orientation a = find_orientation(mesh);
    for (const double scale : {1e-140, 1.0, 1e140}) {
      const Mesh other =
          shapes::scaled(shapes::moved(shapes::rotated(mesh, axis, 1.2), Vec3(10, -20, 30)), scale);
      const Orientation b = find_orientation(other);
      EXPECT_EQ(a.type, b.type) << name;
      EXPECT_EQ(a.against_majority, b.against_majority) << name;
      EXPECT_EQ(a.orientable, b.orientable) << name;
      const Mesh one_up({a.up(0)}, {});
      const Vec3 turned = shapes::rotated(one_up, axis, 1.2).points()[0];
      EXPECT_NEAR((turned - b.up(0)).norm(), 0.0, 1e-9) << name;
    }
  }
}

TEST(Orientation, SurfaceNormalsAreThoseOfTheCells) {
  const Mesh mesh = shapes::sphere_triangles(2);
  const Orientation o = find_orientation(mesh);
  EXPECT_TRUE(o.signs.empty());
  EXPECT_EQ(o.normal, Vec3::Zero());
  for (std::size_t cell = 0; cell < mesh.cells().size(); ++cell) {
    EXPECT_NEAR(o.normals[cell].norm(), 1.0, 1e-15);
    EXPECT_GT(o.up(cell).dot(mesh.points()[mesh.cells().vertices(cell)[0]]), 0.9);
  }
}

TEST(Orientation, SurvivesDegenerateInput) {
  EXPECT_EQ(find_orientation(Mesh()).type, MeshType::surface);
  EXPECT_EQ(find_orientation(Mesh({{0, 0, 0}, {1, 2, 3}}, {})).type, MeshType::surface);
  Cells cells;
  cells.add(CellKind::triangle, {{0, 0, 0}});
  cells.add(CellKind::triangle, {{0, 1, 1}});
  cells.add(CellKind::quad, {{0, 1, 0, 2}});
  cells.add(CellKind::quad, {{2, 2, 3, 3}});
  cells.add(CellKind::polygon, {{0, 1, 2, 3, 0, 1, 2, 3}});
  const std::vector<Vec3> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {7, 7, 7}};
  const Orientation o = find_orientation(Mesh(corner, cells));
  EXPECT_EQ(o.type, MeshType::surface);
  for (const Vec3& n : o.normals) EXPECT_TRUE(n.isZero(0.0) || std::abs(n.norm() - 1.0) < 1e-15);
  cells.add(CellKind::tet, {{0, 0, 1, 1}});
  cells.add(CellKind::hex, {{0, 0, 0, 0, 1, 1, 1, 1}});
  EXPECT_EQ(find_orientation(Mesh(corner, cells)).type, MeshType::volume);
  const std::vector<Vec3> coincident(5, Vec3(1, 2, 3));
  EXPECT_EQ(find_orientation(Mesh(coincident, cells)).against_majority, 0u);
}

TEST(Orientation, DoesNotLetACellListedTwiceTurnItsTwinOver) {
  for (const bool turned : {false, true}) {
    Cells cells;
    cells.add(CellKind::triangle, {{0, 1, 2}});
    if (turned) {
      cells.add(CellKind::triangle, {{0, 2, 1}});
    } else {
      cells.add(CellKind::triangle, {{1, 2, 0}});
    }
    const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, cells);
    const Orientation o = find_orientation(mesh);
    EXPECT_EQ(count_inverted(mesh, o), 0u);
    EXPECT_TRUE(o.orientable);
  }
}

TEST(Orientation, ComparesAMillionCornersOfTwoPolygonsOnce) {
  std::vector<Vec3> points;
  std::vector<Index> around;
  for (Index i = 0; i < 200000; ++i) {
    points.emplace_back(std::cos(i * 3e-5), std::sin(i * 3e-5), 0.0);
    around.push_back(i);
  }
  Cells cells;
  cells.add(CellKind::polygon, around);
  std::rotate(around.begin(), around.begin() + 1000, around.end());
  cells.add(CellKind::polygon, around);
  const Mesh mesh(points, cells);
  EXPECT_EQ(count_inverted(mesh, find_orientation(mesh)), 0u);
}

TEST(Orientation, IsNotSpoiltByAQuadListedCrosswise) {
  // Two vertices of the middle quad are swapped, one quad is wound the other way, and one vertex
  // lies so that cells around it are tangled.
  const Mesh grid = shapes::quad_grid(5);
  Cells cells;
  for (std::size_t i = 0; i < 25; ++i) {
    const auto v = grid.cells().vertices(i);
    if (i == 12) {
      cells.add(CellKind::quad, {{v[0], v[2], v[1], v[3]}});
    } else if (i == 3) {
      cells.add(CellKind::quad, {{v[3], v[2], v[1], v[0]}});
    } else {
      cells.add(CellKind::quad, v);
    }
  }
  std::vector<Vec3> points(grid.points().begin(), grid.points().end());
  points[28] = Vec3(0.8, 0.1, 0.0);
  const Mesh mesh(points, cells);
  const Orientation o = find_orientation(mesh);
  EXPECT_TRUE(o.orientable);
  EXPECT_EQ(o.against_majority, 1u);
  EXPECT_EQ(o.sign(3), -1.0);
  for (std::size_t cell = 0; cell < 25; ++cell) {
    if (cell != 3 && cell != 12) {
      EXPECT_EQ(o.sign(cell), 1.0) << cell;
    }
  }
}

TEST(Orientation, JudgesCellsOneByOneWhereWindingsCannotAgree) {
  // A Moebius strip pressed flat: going round it once changes the winding.
  const Mesh strip = shapes::moebius_strip(13);
  std::vector<Vec3> flat;
  for (const Vec3& p : strip.points()) flat.emplace_back(p.x(), p.y(), 0.0);
  Cells cells;
  for (std::size_t i = 0; i < strip.cells().size(); ++i) {
    const auto v = strip.cells().vertices(i);
    cells.add(CellKind::triangle, {{v[0], v[1], v[2]}});
    cells.add(CellKind::triangle, {{v[0], v[2], v[3]}});
  }
  const Mesh mesh(flat, cells);
  for (const Mesh& m : {mesh, shapes::reversed(mesh, every_third)}) {
    const Orientation o = find_orientation(m);
    EXPECT_EQ(o.type, MeshType::planar);
    EXPECT_FALSE(o.orientable);
    EXPECT_EQ(o.against_majority, 0u);
    EXPECT_EQ(count_inverted(m, o), 0u);
  }
}

TEST(Orientation, GivesSurfaceCellsOfAVolumeMeshNoSide) {
  Cells cells;
  cells.add(CellKind::tet, {{0, 2, 1, 3}});  // left-handed
  cells.add(CellKind::triangle, {{0, 1, 2}});
  const Orientation o = find_orientation(Mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, cells));
  EXPECT_EQ(o.type, MeshType::volume);
  EXPECT_EQ(o.sign(0), -1.0);
  EXPECT_EQ(o.sign(1), 1.0);
  EXPECT_EQ(o.up(1), Vec3::Zero());
}

}  // namespace
}  // namespace evenmesh
