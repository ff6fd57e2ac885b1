// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/mesh_tracks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "evenmesh/geometry/curve_track.h"
#include "evenmesh/geometry/surface_track.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

MeshTracks tracks_of(const Mesh& mesh, double feature_angle = 45.0) {
  const Orientation orientation = find_orientation(mesh);
  return find_mesh_tracks(mesh, orientation,
                          find_topology(mesh, orientation, {.feature_angle = feature_angle}));
}

std::size_t count(const MeshTracks& tracks, VertexPlace place) {
  return static_cast<std::size_t>(std::count(tracks.place.begin(), tracks.place.end(), place));
}

std::size_t straight_runs(const MeshTracks& tracks) {
  return static_cast<std::size_t>(std::count_if(tracks.runs.begin(), tracks.runs.end(),
                                                [](const auto& run) { return run.straight; }));
}

std::size_t flat_patches(const MeshTracks& tracks) {
  return static_cast<std::size_t>(std::count_if(tracks.patches.begin(), tracks.patches.end(),
                                                [](const auto& patch) { return patch.flat(); }));
}

const SurfaceTrack& surface_of(const MeshTracks& tracks) {
  return dynamic_cast<const SurfaceTrack&>(*tracks.tracks.back());
}

/// The cells of a mesh that are chosen.
Mesh part(const Mesh& mesh, const std::function<bool(std::size_t cell)>& chosen) {
  Cells cells;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    if (chosen(c)) cells.add(mesh.cells().kind(c), mesh.cells().vertices(c));
  }
  return Mesh({mesh.points().begin(), mesh.points().end()}, cells);
}

TEST(MeshTracks, OfACubeAreTwelveStraightEdgesAndSixFlatFaces) {
  const int n = 5;
  for (const Mesh& mesh : {shapes::cube_surface(n), shapes::hex_grid(n)}) {
    const MeshTracks t = tracks_of(mesh);
    EXPECT_EQ(count(t, VertexPlace::corner), 8u);
    EXPECT_EQ(t.runs.size(), 12u);
    EXPECT_EQ(straight_runs(t), 12u);
    EXPECT_EQ(count(t, VertexPlace::run), 12u * (n - 1));
    EXPECT_EQ(t.patches.size(), 6u);
    EXPECT_EQ(flat_patches(t), 6u);
    EXPECT_EQ(count(t, VertexPlace::patch), 6u * (n - 1) * (n - 1));
    EXPECT_EQ(count(t, VertexPlace::inside), mesh.point_count() - 8 - 12 * 4 - 6 * 16);
    for (Index v = 0; v < mesh.point_count(); ++v) {
      const Vec3& p = mesh.points()[v];
      int faces = 0;
      for (int axis = 0; axis < 3; ++axis) faces += p[axis] == 0.0 || p[axis] == 1.0;
      EXPECT_EQ(t.is_on_straight_run(v), faces == 2);
      EXPECT_EQ(t.is_on_flat_patch(v), faces == 1);
    }
  }
}

TEST(MeshTracks, SlideVerticesOfACubeOnTheirEdgesAndFaces) {
  const Mesh mesh = shapes::cube_surface(4);
  const MeshTracks t = tracks_of(mesh);
  shapes::Random random(1);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (t.place[v] == VertexPlace::corner) continue;
    const Vec3& x = mesh.points()[v];
    const Vec3 by(random.signed_unit(), random.signed_unit(), random.signed_unit());
    const TrackPoint to = t.tracks[t.track[v]]->nearest(x + by, t.start[v]);
    for (int axis = 0; axis < 3; ++axis) {
      const bool held = x[axis] == 0.0 || x[axis] == 1.0;
      const double wanted = held ? x[axis] : std::clamp(x[axis] + by[axis], 0.0, 1.0);
      EXPECT_NEAR(to.position[axis], wanted, 1e-15);
    }
  }
}

TEST(MeshTracks, OfACylindersSideAreTwoClosedRuns) {
  const Mesh mesh = shapes::cylinder_side(16, 3);
  const MeshTracks t = tracks_of(mesh);
  EXPECT_EQ(count(t, VertexPlace::corner), 0u);
  ASSERT_EQ(t.runs.size(), 2u);
  for (const auto& run : t.runs) {
    EXPECT_TRUE(run.closed);
    EXPECT_FALSE(run.straight);
    EXPECT_EQ(run.vertices.size(), 16u);
  }
  EXPECT_EQ(count(t, VertexPlace::run), 32u);
  EXPECT_EQ(t.patches.size(), 1u);
  EXPECT_EQ(flat_patches(t), 0u);
  // Once round along the rim.
  TrackPoint at = t.start[0];
  for (int i = 0; i < 63; ++i) at = t.tracks[0]->nearest(at.position + 0.1 * at.direction, at);
  EXPECT_LT((at.position - mesh.points()[0]).norm(), 0.2);
}

TEST(MeshTracks, OfASquareWithHolesAreItsStraightSides) {
  // 7 x 7 cells with two holes of one and two cells.
  const Mesh mesh = part(shapes::quad_grid(7), [](std::size_t c) {
    return c != 1 * 7 + 1 && c != 4 * 7 + 3 && c != 4 * 7 + 4;
  });
  const MeshTracks t = tracks_of(mesh);
  EXPECT_EQ(t.runs.size(), 12u);
  EXPECT_EQ(t.tracks.size(), 12u);  // nothing but runs
  EXPECT_EQ(straight_runs(t), 12u);
  EXPECT_EQ(count(t, VertexPlace::corner), 12u);
  EXPECT_EQ(count(t, VertexPlace::run), 4u * 6 + 2u);
  EXPECT_EQ(count(t, VertexPlace::inside), 64u - 12 - 26);
  EXPECT_TRUE(t.patches.empty());
}

TEST(MeshTracks, OfARingAreCurved) {
  const Mesh side = shapes::cylinder_side(24, 2);
  std::vector<Vec3> points;
  for (const Vec3& p : side.points()) points.push_back((1.0 + p.z()) * Vec3(p.x(), p.y(), 0.0));
  const MeshTracks t = tracks_of(Mesh(points, side.cells()));
  EXPECT_EQ(t.runs.size(), 2u);
  EXPECT_EQ(straight_runs(t), 0u);
  EXPECT_EQ(count(t, VertexPlace::inside), 24u);
}

TEST(MeshTracks, CutCurvesWhereGroupsMeet) {
  const Mesh mesh =
      shapes::grouped(shapes::quad_grid(6), [](std::size_t c) { return c % 6 < 3 ? 1u : 2u; });
  const MeshTracks t = tracks_of(mesh);
  EXPECT_EQ(t.runs.size(), 7u);  // four halves, two whole sides and the interface
  EXPECT_EQ(straight_runs(t), 7u);
  EXPECT_EQ(count(t, VertexPlace::corner), 6u);
}

TEST(MeshTracks, HoldInterfacesInsideVolumes) {
  const Mesh mesh =
      shapes::grouped(shapes::hex_grid(4), [](std::size_t cell) { return cell < 32 ? 1u : 2u; });
  const MeshTracks t = tracks_of(mesh);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    const Vec3& p = mesh.points()[v];
    const bool on_skin = (p.array() == 0.0 || p.array() == 1.0).any();
    if (p.z() != 0.5) continue;
    // On the skin the interface's rim is a run, inside it is held.
    const bool at_upright_edge = on_skin && p.x() * (1.0 - p.x()) + p.y() * (1.0 - p.y()) == 0.0;
    const bool held = !on_skin || at_upright_edge;
    EXPECT_EQ(t.place[v], held ? VertexPlace::corner : VertexPlace::run);
  }
  EXPECT_EQ(t.runs.size(), 8u + 8u + 4u);
  EXPECT_EQ(flat_patches(t), 2u + 8u);
}

TEST(MeshTracks, OfAMoebiusStripAreOneRunAndOnePatch) {
  const MeshTracks t = tracks_of(shapes::moebius_strip(40));
  ASSERT_EQ(t.runs.size(), 1u);
  EXPECT_EQ(t.runs[0].vertices.size(), 80u);
  EXPECT_EQ(t.patches.size(), 1u);
}

TEST(MeshTracks, OfThreeTrianglesOnAnEdgeAreAllCorners) {
  const MeshTracks t = tracks_of(shapes::fan_of_three());
  EXPECT_EQ(count(t, VertexPlace::corner), 5u);
  EXPECT_EQ(t.runs.size(), 7u);
  EXPECT_EQ(straight_runs(t), 7u);
  EXPECT_EQ(t.patches.size(), 3u);
  EXPECT_EQ(flat_patches(t), 3u);
}

TEST(MeshTracks, HoldAVertexInWhichTwoSheetsTouch) {
  // Two tetrahedra's surfaces, smooth by decree, share vertex 0.
  Cells cells;
  for (const Index base : {0u, 3u}) {
    const std::array<Index, 4> v{0, base + 1, base + 2, base + 3};
    for (const auto& [a, b, c] : {VertexTriple{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
      cells.add(CellKind::triangle, {{v[a], v[b], v[c]}});
    }
  }
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                  cells);
  const MeshTracks t = tracks_of(mesh, 179.0);
  EXPECT_EQ(t.patches.size(), 2u);
  EXPECT_EQ(t.place[0], VertexPlace::corner);
  EXPECT_EQ(count(t, VertexPlace::patch), 6u);
}

TEST(MeshTracks, CutQuadsAlikeWhicheverCornerComesFirst) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  for (Index first = 0; first < 4; ++first) {
    Cells cells;
    cells.add(CellKind::quad, {{first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4}});
    const MeshTracks t = tracks_of(Mesh(points, cells));
    const SurfaceTrack& surface = surface_of(t);
    EXPECT_EQ(surface.triangles(), 4u);
    EXPECT_EQ(surface.position(4), Vec3(0.5, 0.5, 0.5));
    // Up from the middle of two opposite sides, and down to the same height.
    EXPECT_EQ(surface.nearest({0.5, 0.25, 0.5}, surface.at(0, 2)).position, Vec3(0.5, 0.25, 0.5));
    EXPECT_EQ(surface.nearest({0.25, 0.5, 0.5}, surface.at(0, 2)).position, Vec3(0.25, 0.5, 0.5));
    EXPECT_EQ(flat_patches(t), 0u);
  }
}

TEST(MeshTracks, DoNotFillTheNotchOfAConcaveFace) {
  // A dart and an arrow of five corners; the notch is at (0.9, 0). A tip off the plane makes the
  // mesh a surface.
  const std::vector<Vec3> points{{0, -1, 0}, {0.9, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
  for (Index first = 0; first < 4; ++first) {
    Cells cells;
    const std::array<Index, 4> dart{0, 3, 2, 1};
    std::array<Index, 4> v{};
    for (Index i = 0; i < 4; ++i) v[i] = dart[(first + i) % 4];
    cells.add(CellKind::quad, v);
    cells.add(CellKind::triangle, {{2, 3, 4}});
    const MeshTracks tracks = tracks_of(Mesh(points, cells), 179.0);
    const SurfaceTrack& surface = surface_of(tracks);
    EXPECT_EQ(surface.triangles(), 3u);
    for (std::uint32_t t = 0; t < 2; ++t) {
      for (std::size_t j = 0; j < 3; ++j) EXPECT_LT(surface.vertices(t)[j], 4u);
      EXPECT_GT(surface.at(t, 0).direction.z(), 0.0);
    }
    const Vec3 found = surface.nearest({0.4, 0.0, 0.0}, surface.at(0, 0)).position;
    EXPECT_GT(std::abs(found.y()), 0.1);  // on one of the wings
  }
}

TEST(MeshTracks, StartWhereTheVerticesAre) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const MeshTracks t = tracks_of(mesh);
    ASSERT_EQ(t.place.size(), mesh.point_count());
    for (Index v = 0; v < mesh.point_count(); ++v) {
      EXPECT_EQ(t.start[v].position, mesh.points()[v]) << name;
      const bool on_track = t.place[v] == VertexPlace::run || t.place[v] == VertexPlace::patch;
      EXPECT_EQ(t.track[v] != MeshTracks::kNone, on_track) << name;
      EXPECT_EQ(t.patch[v] != MeshTracks::kNone, t.place[v] == VertexPlace::patch) << name;
      if (!on_track) continue;
      const Track& track = *t.tracks[t.track[v]];
      EXPECT_EQ(track.dimension(), t.place[v] == VertexPlace::run ? 1 : 2) << name;
      const TrackPoint again = track.nearest(mesh.points()[v], t.start[v]);
      EXPECT_EQ(again.position, mesh.points()[v]) << name;
      EXPECT_NEAR(again.direction.norm(), 1.0, 1e-14) << name;
    }
  }
}

TEST(MeshTracks, HaveEveryEdgeOfTheCurvesInOneRun) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Orientation orientation = find_orientation(mesh);
    Topology topology = find_topology(mesh, orientation);
    std::vector<VertexPair> edges;
    for (const auto& run : find_mesh_tracks(mesh, orientation, topology).runs) {
      for (std::size_t k = 0; k + (run.closed ? 0 : 1) < run.vertices.size(); ++k) {
        const auto [a, b] =
            std::minmax(run.vertices[k], run.vertices[(k + 1) % run.vertices.size()]);
        edges.push_back({a, b});
      }
    }
    std::sort(edges.begin(), edges.end());
    std::sort(topology.curves.begin(), topology.curves.end());
    EXPECT_EQ(edges, topology.curves) << name;
  }
}

TEST(MeshTracks, AreTheSameForRenumberedMeshes) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const MeshTracks a = tracks_of(mesh);
    shapes::Renumbering to;
    const MeshTracks b = tracks_of(shapes::shuffled(mesh, 5, &to));
    EXPECT_EQ(a.runs.size(), b.runs.size()) << name;
    EXPECT_EQ(straight_runs(a), straight_runs(b)) << name;
    EXPECT_EQ(a.patches.size(), b.patches.size()) << name;
    EXPECT_EQ(flat_patches(a), flat_patches(b)) << name;
    for (Index v = 0; v < mesh.point_count(); ++v) {
      EXPECT_EQ(a.place[v], b.place[to.vertices[v]]) << name;
    }
  }
}

TEST(MeshTracks, FollowScaling) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const MeshTracks a = tracks_of(mesh);
    for (const double scale : {1e-140, 1e140}) {
      const MeshTracks b = tracks_of(shapes::scaled(mesh, scale));
      EXPECT_EQ(a.place, b.place) << name;
      EXPECT_EQ(straight_runs(a), straight_runs(b)) << name;
      EXPECT_EQ(flat_patches(a), flat_patches(b)) << name;
    }
  }
}

TEST(MeshTracks, SurviveDegenerateInput) {
  EXPECT_TRUE(tracks_of(Mesh()).tracks.empty() || tracks_of(Mesh()).runs.empty());
  Cells cells;
  cells.add(CellKind::triangle, {{0, 0, 0}});
  cells.add(CellKind::triangle, {{0, 1, 1}});
  cells.add(CellKind::quad, {{0, 1, 0, 2}});
  cells.add(CellKind::quad, {{2, 2, 3, 3}});
  cells.add(CellKind::triangle, {{5, 5, 5}});
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {7, 7, 7}, {2, 1, 0}};
  const MeshTracks t = tracks_of(Mesh(points, cells));
  EXPECT_EQ(t.place[4], VertexPlace::unused);
  EXPECT_EQ(t.place[5], VertexPlace::corner);
  for (std::size_t v = 0; v < 6; ++v) {
    EXPECT_EQ(t.track[v] == MeshTracks::kNone,
              t.place[v] != VertexPlace::run && t.place[v] != VertexPlace::patch);
  }
  cells.add(CellKind::hex, {{0, 0, 0, 0, 1, 1, 1, 1}});
  cells.add(CellKind::pyramid, {{0, 1, 0, 1, 2}});
  EXPECT_EQ(tracks_of(Mesh(points, cells)).place.size(), 6u);
  EXPECT_EQ(tracks_of(Mesh(std::vector<Vec3>(6, Vec3(1, 2, 3)), cells)).place.size(), 6u);
}

TEST(IsStraight, AllowsRoundingAndNoMore) {
  const Vec3 a(1, 2, 3);
  const Vec3 b(4, 0, 5);
  const Vec3 up = Vec3(2, 3, 0).normalized() * (b - a).norm();  // perpendicular to b - a
  for (const double unit : {1e-140, 1.0, 1e140}) {
    const auto straight = [&](double t, double s, double off) {
      const Vec3 points[] = {unit * a, unit * (a + t * (b - a) + off * up),
                             unit * (a + s * (b - a)), unit * b};
      return is_straight(points);
    };
    EXPECT_TRUE(straight(0.3, 0.6, 0.0));
    EXPECT_TRUE(straight(0.3, 0.6, 0.9e-7));
    EXPECT_FALSE(straight(0.3, 0.6, 1.1e-7));
    EXPECT_FALSE(straight(0.6, 0.3, 0.0));   // goes back
    EXPECT_FALSE(straight(-0.1, 0.3, 0.0));  // starts the wrong way
    EXPECT_FALSE(straight(0.3, 1.1, 0.0));   // goes beyond its end
  }
  EXPECT_TRUE(is_straight(std::vector<Vec3>{a, b}));
  EXPECT_FALSE(is_straight(std::vector<Vec3>{a, b, a}));
  EXPECT_FALSE(is_straight(std::vector<Vec3>{a, a}));
}

}  // namespace
}  // namespace evenmesh
