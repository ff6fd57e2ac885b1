// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/curves.h"
#include "evenmesh/mesh/sides.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

Topology topology_of(const Mesh& mesh, double feature_angle = 45.0) {
  return find_topology(mesh, find_orientation(mesh), {.feature_angle = feature_angle});
}

std::size_t count(const std::vector<char>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), char{1}));
}

/// Flags from a rule about points.
std::vector<char> where(const Mesh& mesh, const std::function<bool(const Vec3&)>& rule) {
  std::vector<char> flags;
  for (const Vec3& p : mesh.points()) flags.push_back(rule(p));
  return flags;
}

int faces_of_unit_cube(const Vec3& p) {
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) count += p[axis] == 0.0 || p[axis] == 1.0;
  return count;
}

using FlagsOf = std::vector<char> Topology::*;
constexpr FlagsOf kFlags[] = {&Topology::boundary,  &Topology::non_manifold, &Topology::features,
                              &Topology::interface, &Topology::corners,      &Topology::used};

void expect_same_counts(const Topology& a, const Topology& b, const std::string& name) {
  EXPECT_EQ(a.boundary_sides, b.boundary_sides) << name;
  EXPECT_EQ(a.non_manifold_sides, b.non_manifold_sides) << name;
  EXPECT_EQ(a.feature_sides, b.feature_sides) << name;
  EXPECT_EQ(a.interface_sides, b.interface_sides) << name;
  EXPECT_EQ(a.components, b.components) << name;
  EXPECT_EQ(a.curves.size(), b.curves.size()) << name;
}

TEST(Topology, OfAPlanarGridIsItsFourStraightSides) {
  for (const Mesh& mesh : {shapes::quad_grid(6, 1.0, 0.2), shapes::triangle_grid(6, 1.0, 0.2)}) {
    const Topology t = topology_of(mesh);
    EXPECT_EQ(t.boundary_sides, 24u);
    EXPECT_EQ(t.boundary, where(mesh, [](const Vec3& p) {
                return p.x() == 0.0 || p.x() == 1.0 || p.y() == 0.0 || p.y() == 1.0;
              }));
    EXPECT_EQ(t.corners, where(mesh, [](const Vec3& p) {
                return (p.x() == 0.0 || p.x() == 1.0) && (p.y() == 0.0 || p.y() == 1.0);
              }));
    EXPECT_EQ(count(t.features) + count(t.non_manifold) + count(t.interface), 0u);
    EXPECT_EQ(t.feature_sides + t.non_manifold_sides + t.interface_sides, 0u);
    EXPECT_EQ(t.components, 1u);
    EXPECT_EQ(count(t.used), mesh.point_count());
  }
}

TEST(Topology, OfACubeIsEightCornersAndTwelveEdges) {
  for (const int n : {1, 2, 5}) {
    const Mesh mesh = shapes::cube_surface(n);
    const Topology t = topology_of(mesh);
    EXPECT_EQ(t.feature_sides, 12u * static_cast<std::size_t>(n));
    EXPECT_EQ(t.features, where(mesh, [](const Vec3& p) { return faces_of_unit_cube(p) >= 2; }));
    EXPECT_EQ(t.corners, where(mesh, [](const Vec3& p) { return faces_of_unit_cube(p) == 3; }));
    EXPECT_EQ(t.boundary_sides, 0u);
    EXPECT_EQ(count(topology_of(mesh, 89.9).corners), 8u);
    EXPECT_EQ(topology_of(mesh, 90.0).feature_sides, 0u);  // not beyond the limit
  }
}

TEST(Topology, OfASurfaceWoundBothWaysHasTheSameFeatures) {
  const Mesh mesh =
      shapes::reversed(shapes::cube_surface(3), [](std::size_t cell) { return cell % 4 == 1; });
  EXPECT_EQ(topology_of(mesh).feature_sides, 36u);
}

TEST(Topology, OfSmoothClosedSurfacesIsEmpty) {
  const Topology t = topology_of(shapes::sphere_triangles(3));
  EXPECT_EQ(count(t.boundary) + count(t.features) + count(t.corners), 0u);
  EXPECT_EQ(topology_of(shapes::sphere_triangles(0), 41.0).feature_sides, 30u);  // 41.81 degrees
  EXPECT_EQ(topology_of(shapes::sphere_triangles(0), 42.0).feature_sides, 0u);
}

TEST(Topology, OfACylinderIsTwoCirclesWithoutCorners) {
  const Mesh mesh = shapes::cylinder_side(12, 3);
  const Topology t = topology_of(mesh);
  EXPECT_EQ(t.boundary_sides, 24u);
  EXPECT_EQ(count(t.boundary), 24u);
  EXPECT_EQ(count(t.corners), 0u);  // each turn is 30 degrees
  EXPECT_EQ(count(topology_of(mesh, 29.0).corners), 24u);
}

TEST(Topology, OfAMoebiusStripIsOneBoundary) {
  const Topology t = topology_of(shapes::moebius_strip(20));
  EXPECT_EQ(t.boundary_sides, 40u);
  EXPECT_EQ(t.feature_sides, 0u);  // also where the windings clash
  EXPECT_EQ(t.components, 1u);
}

TEST(Topology, OfAFanMarksTheEdgeOfThreeAndItsEnds) {
  const Topology t = topology_of(shapes::fan_of_three());
  EXPECT_EQ(t.non_manifold, (std::vector<char>{1, 1, 0, 0, 0}));
  EXPECT_EQ(t.non_manifold_sides, 1u);
  EXPECT_EQ(t.boundary_sides, 6u);
  EXPECT_EQ(t.feature_sides, 0u);
  EXPECT_EQ(t.corners, (std::vector<char>{1, 1, 1, 1, 1}));
}

TEST(Topology, MakesTheVertexOfABowtieACorner) {
  const Topology t = topology_of(shapes::bowtie_vertex());
  EXPECT_TRUE(t.corners[0]);
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(topology_of(shapes::two_components(2)).components, 2u);
}

TEST(Topology, FindsInterfacesBetweenGroupsAndWhereTheyMeet) {
  // Three groups: left half, right half below, right half above.
  const Mesh mesh = shapes::grouped(shapes::quad_grid(4), [](std::size_t cell) {
    return cell % 4 < 2 ? 0u : (cell < 8 ? 7u : 9u);
  });
  const Topology t = topology_of(mesh);
  EXPECT_EQ(t.interface_sides, 6u);
  EXPECT_EQ(t.interface, where(mesh, [](const Vec3& p) {
              return p.x() == 0.5 || (p.x() > 0.5 && p.y() == 0.5);
            }));
  EXPECT_TRUE(t.corners[12]);  // all three meet
  EXPECT_TRUE(t.corners[2]);   // an interface ends at the boundary
  EXPECT_FALSE(t.corners[7]);  // goes straight on
  EXPECT_EQ(count(t.corners), 4u + 4u);
}

TEST(Topology, OfVolumesIsThatOfTheirSkin) {
  const auto skin = [](const Vec3& p) { return faces_of_unit_cube(p) >= 1; };
  const auto edges = [](const Vec3& p) { return faces_of_unit_cube(p) >= 2; };
  const auto ends = [](const Vec3& p) { return faces_of_unit_cube(p) == 3; };
  const std::pair<Mesh, std::size_t> cases[] = {{shapes::tet_grid(3), 108},
                                                {shapes::hex_grid(3, 0.2), 54},
                                                {shapes::wedge_grid(3), 36 + 36},
                                                {shapes::pyramid_grid(3), 54}};
  for (const auto& [mesh, faces] : cases) {
    for (const bool left_handed : {false, true}) {
      const Mesh hand = shapes::reversed(mesh, [&](std::size_t) { return left_handed; });
      const Topology t = topology_of(hand);
      EXPECT_EQ(t.boundary_sides, faces);
      EXPECT_EQ(t.boundary, where(mesh, skin));
      EXPECT_EQ(t.features, where(mesh, edges));
      EXPECT_EQ(t.feature_sides, 36u);
      EXPECT_EQ(t.corners, where(mesh, ends));
      EXPECT_EQ(t.non_manifold_sides, 0u);
      EXPECT_EQ(t.components, 1u);
    }
  }
}

TEST(Topology, FindsInterfacesInsideVolumes) {
  const Mesh mesh =
      shapes::grouped(shapes::hex_grid(4), [](std::size_t cell) { return cell < 32 ? 1u : 2u; });
  const Topology t = topology_of(mesh);
  EXPECT_EQ(t.interface_sides, 16u);
  EXPECT_EQ(t.interface, where(mesh, [](const Vec3& p) { return p.z() == 0.5; }));
  EXPECT_EQ(count(t.corners), 8u + 4u);  // where the interface meets the cube's upright edges
}

TEST(Topology, HoldsSurfaceCellsInsideVolumes) {
  Cells cells;
  const Mesh grid = shapes::hex_grid(2);
  for (std::size_t i = 0; i < 8; ++i) cells.add(CellKind::hex, grid.cells().vertices(i));
  cells.add(CellKind::quad, {{9, 10, 13, 12}});  // inside, at z = 1/2
  cells.add(CellKind::quad, {{0, 1, 4, 3}});     // on the skin
  const Mesh mesh({grid.points().begin(), grid.points().end()}, cells);
  const Topology t = topology_of(mesh);
  EXPECT_EQ(t.interface_sides, 1u);
  EXPECT_TRUE(t.interface[13]);
  EXPECT_EQ(count(t.interface), 4u);
}

TEST(Topology, MarksTheEdgeOnWhichTwoBlocksTouch) {
  // Two hexes on the diagonal of a 2 x 2 x 1 arrangement share an edge and no face.
  const Mesh grid = shapes::hex_grid(2);
  Cells cells;
  cells.add(CellKind::hex, grid.cells().vertices(0));
  cells.add(CellKind::hex, grid.cells().vertices(3));
  const Mesh mesh({grid.points().begin(), grid.points().end()}, cells);
  const Topology t = topology_of(mesh, 120.0);  // beyond every dihedral angle of the blocks
  EXPECT_EQ(t.feature_sides, 1u);
  EXPECT_TRUE(t.features[4] && t.features[13]);
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(count(t.used), 14u);
}

TEST(Topology, OfAHexagonPatchHasTheKnownBoundary) {
  // Euler: V - E + F = 1, and 6 F = 2 E - boundary.
  const Mesh mesh = shapes::hexagons(5);
  const Topology t = topology_of(mesh, 90.0);
  EXPECT_EQ(t.boundary_sides, 2 * (mesh.point_count() + 25 - 1) - 6 * 25);
  EXPECT_EQ(t.boundary_sides, count(t.boundary));
}

TEST(Topology, KeepsTheEdgesOfItsCurves) {
  const auto is_on_curve = [](const Topology& t, Index v) {
    return t.boundary[v] || t.features[v] || t.non_manifold[v] || t.interface[v];
  };
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Topology t = topology_of(mesh);
    const bool is_volume = find_orientation(mesh).type == MeshType::volume;
    EXPECT_EQ(t.skin.size(), is_volume ? t.boundary_sides : 0u) << name;
    const std::size_t border = is_volume ? 0 : t.boundary_sides + t.non_manifold_sides;
    EXPECT_EQ(t.curves.size(), border + t.feature_sides) << name;  // every edge has one reason
    std::vector<char> on_curve(mesh.point_count(), 0);
    for (const auto& [a, b] : t.curves) {
      EXPECT_LT(a, b) << name;
      EXPECT_TRUE(is_on_curve(t, a) && is_on_curve(t, b)) << name;
      on_curve[a] = on_curve[b] = 1;
    }
    for (Index v = 0; v < mesh.point_count(); ++v) EXPECT_LE(t.corners[v], on_curve[v]) << name;
  }
}

TEST(Topology, IsTheSameForRenumberedMeshes) {
  for (const auto& [name, plain] : shapes::zoo()) {
    for (const Mesh& mesh :
         {plain, shapes::grouped(plain, [](std::size_t c) { return c < 5 ? 1u : 2u; })}) {
      const Topology a = topology_of(mesh);
      shapes::Renumbering to;
      const Topology b = topology_of(shapes::shuffled(mesh, 13, &to));
      expect_same_counts(a, b, name);
      for (const FlagsOf flags : kFlags) {
        for (std::size_t v = 0; v < mesh.point_count(); ++v) {
          EXPECT_EQ((a.*flags)[v], (b.*flags)[to.vertices[v]]) << name;
        }
      }
    }
  }
}

TEST(Topology, FollowsRigidMotionAndScaling) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Topology a = topology_of(mesh);
    for (const double scale : {1e-140, 1e140}) {
      const Topology b = topology_of(shapes::scaled(
          shapes::moved(shapes::rotated(mesh, Vec3(1, -2, 0.5), 1.2), Vec3(3, -2, 1)), scale));
      expect_same_counts(a, b, name);
      for (const FlagsOf flags : kFlags) EXPECT_EQ(a.*flags, b.*flags) << name;
    }
  }
}

TEST(Topology, FlagsAgreeWithEachOtherAndTheCounts) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Topology t = topology_of(mesh);
    for (const FlagsOf flags : kFlags) {
      ASSERT_EQ((t.*flags).size(), mesh.point_count()) << name;
      for (std::size_t v = 0; v < mesh.point_count(); ++v) {
        EXPECT_LE((t.*flags)[v], t.used[v]) << name;
      }
    }
    EXPECT_EQ(t.boundary_sides == 0, count(t.boundary) == 0) << name;
    EXPECT_EQ(t.feature_sides == 0, count(t.features) == 0) << name;
    EXPECT_EQ(t.non_manifold_sides == 0, count(t.non_manifold) == 0) << name;
  }
}

TEST(Topology, OfATangledPlanarMeshHasNoFeatures) {
  EXPECT_EQ(topology_of(shapes::irregular_triangles(500, 0.3, 1, 0.9)).feature_sides, 0u);
}

TEST(Topology, SurvivesDegenerateInput) {
  EXPECT_EQ(topology_of(Mesh()).components, 0u);
  Cells cells;
  cells.add(CellKind::triangle, {{0, 0, 0}});
  cells.add(CellKind::triangle, {{0, 1, 1}});
  cells.add(CellKind::quad, {{0, 1, 0, 2}});
  cells.add(CellKind::quad, {{2, 2, 3, 3}});
  const std::vector<Vec3> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {7, 7, 7}};
  Topology t = topology_of(Mesh(corner, cells));
  EXPECT_EQ(t.used, (std::vector<char>{1, 1, 1, 1, 0}));
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.feature_sides, 0u);
  EXPECT_TRUE(t.boundary[2]);  // its cell is no neighbour of itself
  cells.add(CellKind::hex, {{0, 0, 0, 0, 1, 1, 1, 1}});
  cells.add(CellKind::pyramid, {{0, 1, 0, 1, 2}});
  t = topology_of(Mesh(corner, cells));
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(topology_of(Mesh(std::vector<Vec3>(5, Vec3(1, 2, 3)), cells)).components, 1u);
}

TEST(Topology, MakesNoFeatureAtACellWithoutArea) {
  Cells cells;
  cells.add(CellKind::triangle, {{0, 1, 2}});
  cells.add(CellKind::triangle, {{1, 0, 3}});  // collinear
  cells.add(CellKind::triangle, {{0, 2, 4}});  // upright
  const Mesh mesh({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, cells);
  const Topology t = topology_of(mesh);
  EXPECT_EQ(t.feature_sides, 1u);
  EXPECT_EQ(t.features, (std::vector<char>{1, 0, 1, 0, 0}));
}

TEST(Topology, LeavesACellListedTwiceItsBoundary) {
  Cells cells;
  for (int i = 0; i < 2; ++i) {
    cells.add(CellKind::triangle, {{0, 1, 2}});
    cells.add(CellKind::tet, {{3, 4, 5, 6}});
  }
  std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                           {1, 0, 1}, {0, 1, 1}, {0, 0, 2}};
  const Topology volume = topology_of(Mesh(points, cells));
  EXPECT_EQ(volume.boundary_sides, 4u);
  Cells triangles;
  triangles.add(CellKind::triangle, {{0, 1, 2}});
  triangles.add(CellKind::triangle, {{2, 0, 1}});
  triangles.add(CellKind::triangle, {{3, 1, 2}});  // so that the mesh is not planar
  const Topology surface = topology_of(Mesh(points, triangles));
  EXPECT_EQ(surface.boundary_sides, 4u);
  EXPECT_EQ(surface.non_manifold_sides, 1u);
  EXPECT_EQ(surface.feature_sides, 0u);
}

TEST(Topology, RejectsAFeatureAngleOutOfRange) {
  const Mesh mesh = shapes::quad_grid(2);
  for (const double angle : {0.0, -1.0, 180.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(topology_of(mesh, angle), InvalidOption) << angle;
  }
}

TEST(MarkCorners, TakesATurnOfExactlyTheLimitAsSmooth) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 1, 0}};
  const std::vector<VertexPair> edges{{0, 1}, {1, 2}, {2, 3}};
  std::vector<char> corners(4, 0);
  mark_corners(points, edges, std::numbers::pi / 4.0, corners);
  EXPECT_EQ(corners, (std::vector<char>{1, 0, 1, 1}));  // 2 and 3 coincide: the turn is unknown
  mark_corners(points, edges, std::numbers::pi / 4.1, corners);
  EXPECT_TRUE(corners[1]);
}

}  // namespace
}  // namespace evenmesh
