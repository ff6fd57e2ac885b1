// SPDX-License-Identifier: MIT
#include "apps/evenmesh/gallery/meshes.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/quality/quality.h"

namespace evenmesh::gallery {
namespace {

struct Named {
  const char* name;
  Mesh (*make)();
  std::size_t triangles, quads, boundary;
};

const Named kMeshes[] = {
    {"four_triangles", [] { return four_triangles(1).start; }, 4, 0, 4},
    {"four_quads", [] { return four_quads(1).start; }, 0, 4, 8},
    {"square_of_quads", [] { return square_of_quads(1).start; }, 0, 36, 24},
    {"teardrop", [] { return teardrop(); }, 176, 0, 38},
    {"quad_block", [] { return quad_block(); }, 0, 140, 48},
    {"trapezoid_and_annulus", [] { return trapezoid_and_annulus(); }, 0, 216, 84},
    {"curved_sheet", [] { return curved_sheet(); }, 72, 63, 40},
};

class StartMesh : public testing::TestWithParam<Named> {};

QualitySummary quality_of(const Mesh& mesh) {
  Workers workers(1);
  return summarize(workers, measure_cells(workers, mesh, mesh.points(), find_orientation(mesh)));
}

std::size_t count(const std::vector<char>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), char{1}));
}

TEST_P(StartMesh, IsValidAndWoundAlike) {
  const Mesh mesh = GetParam().make();
  EXPECT_EQ(quality_of(mesh).inverted, 0u);
  EXPECT_EQ(find_orientation(mesh).against_majority, 0u);
  // Counterclockwise as it is drawn, too.
  const auto corner = mesh.cells().vertices(0);
  const Points x = mesh.points();
  EXPECT_GT((x[corner[1]] - x[corner[0]]).cross(x[corner[2]] - x[corner[0]]).z(), 0.0);
}

TEST_P(StartMesh, HasTheCellsOfItsFigure) {
  const Mesh mesh = GetParam().make();
  const auto kinds = mesh.cells().kinds();
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), CellKind::triangle), GetParam().triangles);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), CellKind::quad), GetParam().quads);
  const Topology topology = find_topology(mesh, find_orientation(mesh));
  EXPECT_EQ(count(topology.boundary), GetParam().boundary);
  EXPECT_EQ(count(topology.used), mesh.point_count());
  EXPECT_EQ(topology.components, 1u);
}

TEST_P(StartMesh, IsTheSameEveryTime) {
  const Mesh a = GetParam().make();
  const Mesh b = GetParam().make();
  EXPECT_TRUE(std::equal(a.points().begin(), a.points().end(), b.points().begin()));
  EXPECT_TRUE(std::equal(a.cells().corners().begin(), a.cells().corners().end(),
                         b.cells().corners().begin()));
}

INSTANTIATE_TEST_SUITE_P(All, StartMesh, testing::ValuesIn(kMeshes),
                         [](const auto& variant) { return variant.param.name; });

double farthest(Points a, Points b) {
  double most = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, (a[v] - b[v]).norm());
  return most;
}

TEST(KnownMeshes, AreDisplacedAsFarAsTheySay) {
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const KnownMesh five = four_triangles(seed);
    EXPECT_NEAR(farthest(five.start.points(), five.optimum), 0.4, 1e-15);
    const KnownMesh seven = four_quads(seed);
    EXPECT_NEAR(farthest(seven.start.points(), seven.optimum), 0.2, 1e-15);
    const KnownMesh nine = square_of_quads(seed);
    for (std::size_t v = 0; v < nine.optimum.size(); ++v) {
      most = std::max(most, (nine.start.points()[v] - nine.optimum[v]).cwiseAbs().maxCoeff());
    }
  }
  EXPECT_LE(most, 0.4 / 6.0);
  EXPECT_GE(most, 0.39 / 6.0);
}

TEST(KnownMeshes, DifferFromSeedToSeed) {
  EXPECT_NE(four_triangles(1).start.points()[4], four_triangles(2).start.points()[4]);
  EXPECT_NE(square_of_quads(1).start.points()[8], square_of_quads(2).start.points()[8]);
}

// More slender quads than that fold under every weighting of the costs.
TEST(TrapezoidAndAnnulus, HasNoCellTwiceAsLongAsWide) {
  EXPECT_LT(quality_of(trapezoid_and_annulus()).of(Metric::edge_ratio).worst, 2.0);
}

TEST(CurvedSheet, LiesOnItsSphereWithTrianglesAtTheBoundaryOnly) {
  const Mesh mesh = curved_sheet();
  const Orientation orientation = find_orientation(mesh);
  EXPECT_EQ(orientation.type, MeshType::surface);
  for (const Vec3& p : mesh.points()) EXPECT_NEAR(p.norm(), kSheetRadius, 1e-14);
  const std::vector<char> boundary = find_topology(mesh, orientation).boundary;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const auto corners = mesh.cells().vertices(c);
    const auto fixed =
        std::count_if(corners.begin(), corners.end(), [&](Index v) { return boundary[v] != 0; });
    EXPECT_EQ(mesh.cells().kind(c) == CellKind::quad, fixed == 0) << c;
    EXPECT_LT(fixed, 3) << c;  // something of it can move
  }
}

TEST(Tangled, TurnsCellsOverAndLeavesTheBoundary) {
  const Mesh mesh = teardrop();
  const std::vector<char> boundary = find_topology(mesh, find_orientation(mesh)).boundary;
  const Mesh after = tangled(mesh, boundary, 0.25, 1);
  EXPECT_GT(quality_of(after).inverted, 20u);
  for (std::size_t v = 0; v < boundary.size(); ++v) {
    EXPECT_EQ(after.points()[v] == mesh.points()[v], boundary[v] != 0) << v;
  }
}

}  // namespace
}  // namespace evenmesh::gallery
