// SPDX-License-Identifier: MIT
//
// Surfaces, on which vertices slide, and volumes.
#include <gtest/gtest.h>

#include "evenmesh/geometry/bvh.h"
#include "evenmesh/solver/smooth.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_setup::copy_of;
using testing_setup::displaced;
using testing_setup::problem_of;
using testing_setup::with_points;

Mesh uneven_sphere(int levels) {
  const Mesh sphere = shapes::sphere_triangles(levels);
  const double h = std::pow(0.5, levels);
  std::vector<Vec3> points = displaced(sphere, problem_of(sphere).motion, 0.3 * h, 6);
  for (Vec3& p : points) p.normalize();
  return with_points(sphere, std::move(points));
}

// Of triangles; quads count as what their corners' mean divides them into.
void expect_on_surface(const Mesh& before, const Mesh& after) {
  std::vector<Vec3> points = copy_of(before.points());
  std::vector<VertexTriple> triangles;
  for (std::size_t c = 0; c < before.cells().size(); ++c) {
    const auto cell = before.cells().vertices(c);
    if (cell.size() == 3) {
      triangles.push_back({cell[0], cell[1], cell[2]});
      continue;
    }
    Vec3 sum = Vec3::Zero();
    for (const Index v : cell) sum += before.points()[v];
    const auto centre = static_cast<Index>(points.size());
    points.emplace_back(sum / static_cast<double>(cell.size()));
    for (std::size_t i = 0; i < cell.size(); ++i) {
      triangles.push_back({cell[i], cell[(i + 1) % cell.size()], centre});
    }
  }
  const Bvh bvh(points, triangles);
  for (const Vec3& p : after.points()) EXPECT_LE(bvh.closest(p).distance, 1e-12);
}

TEST(Surfaces, ASphereBecomesEvenAndStaysWhatItIs) {
  Mesh mesh = uneven_sphere(3);
  const Mesh input = mesh;
  const Problem problem = problem_of(mesh);
  ASSERT_EQ(problem.motion.moving(), mesh.point_count());
  const Report report = smooth(mesh, problem);
  expect_on_surface(input, mesh);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  EXPECT_GT(report.quality_after.of(Metric::shape).mean,
            report.quality_before.of(Metric::shape).mean + 0.01);
  EXPECT_GE(report.quality_after.of(Metric::min_angle).worst,
            report.quality_before.of(Metric::min_angle).worst);
}

TEST(Surfaces, AMixedSurfaceImprovesAndStaysWhatItIs) {
  Mesh mesh = shapes::mixed_surface(12);
  const Mesh input = mesh;
  const Problem problem = problem_of(mesh);
  const Report report = smooth(mesh, problem);
  expect_on_surface(input, mesh);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  EXPECT_GT(report.moved, 50u);
  EXPECT_GT(report.quality_after.of(Metric::shape).mean,
            report.quality_before.of(Metric::shape).mean);
}

TEST(Surfaces, TheFacesOfACubeBecomeSquaresAgain) {
  const Mesh cube = shapes::cube_surface(5);
  const Problem problem = problem_of(cube);
  ASSERT_EQ(problem.motion.moving(), 6u * 4u * 4u);
  Mesh mesh = with_points(cube, displaced(cube, problem.motion, 0.06, 2));
  smooth(mesh, problem_of(mesh));
  EXPECT_LE(testing_setup::farthest(mesh.points(), cube.points()), 1e-4);
}

TEST(Surfaces, OddOnesAreNoTrouble) {
  for (const Mesh& shape : {shapes::moebius_strip(16), shapes::fan_of_three(),
                            shapes::bowtie_vertex(), shapes::cylinder_side(12, 4)}) {
    for (const char* fixed : {"boundary+features", "corners", "none"}) {
      Mesh mesh = shape;
      ProblemOptions options = testing_setup::only("global");
      const Report report = smooth(mesh, problem_of(mesh, options, fixed));
      EXPECT_LE(report.quality_after.inverted, report.quality_before.inverted);
      for (const Vec3& p : mesh.points()) EXPECT_TRUE(p.allFinite());
    }
  }
}

TEST(Volumes, JitteredHexesBecomeCubes) {
  Mesh mesh = shapes::hex_grid(6, 0.25);
  const Report report = smooth(mesh, problem_of(mesh));
  EXPECT_EQ(report.quality_after.inverted, 0u);
  EXPECT_GT(report.quality_after.of(Metric::shape).mean,
            report.quality_before.of(Metric::shape).mean);
  EXPECT_GT(report.quality_after.of(Metric::scaled_jacobian).worst,
            report.quality_before.of(Metric::scaled_jacobian).worst);
}

TEST(Volumes, EveryKindKeepsThePromise) {
  for (const Mesh& grid : {shapes::tet_grid(4), shapes::wedge_grid(4), shapes::pyramid_grid(3)}) {
    const Problem inside = problem_of(grid);
    Mesh mesh = with_points(grid, displaced(grid, inside.motion, 0.05, 3));
    const Report report = smooth(mesh, problem_of(mesh));
    EXPECT_EQ(report.quality_before.inverted, 0u);
    EXPECT_EQ(report.quality_after.inverted, 0u);
    EXPECT_GE(report.quality_after.of(Metric::shape).worst,
              report.quality_before.of(Metric::shape).worst);
    EXPECT_GT(report.quality_after.of(Metric::shape).mean,
              report.quality_before.of(Metric::shape).mean);
    EXPECT_LT(report.cost_after, report.cost_before);
  }
}

}  // namespace
}  // namespace evenmesh
