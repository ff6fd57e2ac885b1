// SPDX-License-Identifier: MIT
//
// Surfaces, on which vertices keep to the input's tangent planes, and volumes.
#include <gtest/gtest.h>

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

void expect_in_tangent_planes(const Mesh& before, const Mesh& after, const Motion& motion) {
  for (std::size_t v = 0; v < before.point_count(); ++v) {
    const Vec3 move = after.points()[v] - before.points()[v];
    EXPECT_LE(std::abs(motion.normal(static_cast<Index>(v)).dot(move)), 1e-14) << "vertex " << v;
  }
}

TEST(Surfaces, ASphereBecomesEvenWithinItsTangentPlanes) {
  Mesh mesh = uneven_sphere(3);
  const Mesh input = mesh;
  const Problem problem = problem_of(mesh);
  ASSERT_EQ(problem.motion.moving(), mesh.point_count());
  const Report report = smooth(mesh, problem);
  expect_in_tangent_planes(input, mesh, problem.motion);
  EXPECT_EQ(report.quality_after.inverted, 0u);
  EXPECT_GT(report.quality_after.of(Metric::shape).mean,
            report.quality_before.of(Metric::shape).mean + 0.01);
  EXPECT_GE(report.quality_after.of(Metric::min_angle).worst,
            report.quality_before.of(Metric::min_angle).worst);
}

TEST(Surfaces, AMixedSurfaceImprovesWithinItsTangentPlanes) {
  Mesh mesh = shapes::mixed_surface(12);
  const Mesh input = mesh;
  const Problem problem = problem_of(mesh);
  const Report report = smooth(mesh, problem);
  expect_in_tangent_planes(input, mesh, problem.motion);
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
