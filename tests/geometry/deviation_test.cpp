// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/deviation.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "evenmesh/mesh/mesh.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

struct Surface {
  std::vector<Vec3> points;
  std::vector<VertexTriple> triangles;

  explicit Surface(const Mesh& mesh) : points(mesh.points().begin(), mesh.points().end()) {
    for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
      const auto v = mesh.cells().vertices(c);
      triangles.push_back({v[0], v[1], v[2]});
    }
  }
};

Deviation between(const Surface& a, const Surface& b, int threads = 1) {
  Workers workers(threads);
  return deviation_between(a.points, a.triangles, b.points, b.triangles, workers);
}

TEST(Deviation, OfASurfaceFromItselfIsZero) {
  const Surface sphere(shapes::sphere_triangles(3));
  const Deviation d = between(sphere, sphere);
  EXPECT_LE(d.greatest(), 1e-15);
  EXPECT_LE(d.a_from_b.mean, 1e-15);
  EXPECT_EQ(d.a_from_b.of_triangle.size(), sphere.triangles.size());
}

TEST(Deviation, OfParallelPlanesIsTheirDistance) {
  const Surface low(shapes::triangle_grid(6, 1.0, 0.2));
  Surface high(shapes::triangle_grid(9, 1.0, 0.1));
  for (Vec3& p : high.points) p.z() = 0.25;
  const Deviation d = between(low, high);
  for (const OneSidedDeviation* side : {&d.a_from_b, &d.b_from_a}) {
    EXPECT_NEAR(side->greatest, 0.25, 1e-15);
    EXPECT_NEAR(side->mean, 0.25, 1e-15);
    for (const double of_triangle : side->of_triangle) EXPECT_NEAR(of_triangle, 0.25, 1e-15);
  }
}

TEST(Deviation, TellsTheTrianglesThatDeviate) {
  const Surface flat(shapes::triangle_grid(8));
  Surface bump = flat;
  bump.points[40].z() = 0.5;  // in the middle
  const Deviation d = between(bump, flat);
  for (std::size_t t = 0; t < bump.triangles.size(); ++t) {
    const auto& v = bump.triangles[t];
    const bool raised = v[0] == 40 || v[1] == 40 || v[2] == 40;
    EXPECT_EQ(d.a_from_b.of_triangle[t], raised ? 0.5 : 0.0);
  }
  EXPECT_EQ(d.a_from_b.greatest, 0.5);
  EXPECT_GT(d.b_from_a.greatest, 0.1);
  EXPECT_LT(d.b_from_a.greatest, 0.5);  // the flat one is nearer to the bump's side than to its tip
}

TEST(Deviation, SeesWhatOnlyOneOfTheTwoHas) {
  const Surface whole(shapes::triangle_grid(8));
  Surface part = whole;
  part.triangles.resize(part.triangles.size() / 2);  // rows 0 to 3
  const Deviation d = between(part, whole);
  EXPECT_EQ(d.a_from_b.greatest, 0.0);
  EXPECT_EQ(d.b_from_a.greatest, 0.5);
}

TEST(Deviation, SeesTheMiddlesOfEdgesAndFaces) {
  // A chord of a bent line, then a cap over a pyramid: the corners lie on each other.
  Workers workers;
  const std::vector<Vec3> points{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}};
  const std::vector<VertexTriple> chord{{0, 2, 2}};
  const std::vector<VertexTriple> bent{{0, 0, 1}, {1, 2, 1}};
  const Deviation d = deviation_between(points, chord, points, bent, workers);
  EXPECT_NEAR(d.a_from_b.greatest, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(d.a_from_b.mean, std::sqrt(0.5) / 3.0, 1e-15);
  EXPECT_EQ(d.b_from_a.greatest, 1.0);
  EXPECT_NEAR(d.b_from_a.mean, 0.5, 1e-15);

  const std::vector<Vec3> corners{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, -2}};
  const std::vector<VertexTriple> lid{{0, 1, 2}};
  const std::vector<VertexTriple> sides{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Deviation hollow = deviation_between(corners, lid, corners, sides, workers);
  EXPECT_GT(hollow.a_from_b.greatest, 0.5);
  EXPECT_EQ(hollow.b_from_a.greatest, 2.0);
}

TEST(Deviation, HasTheSameBitsForAnyNumberOfThreads) {
  const Surface a(shapes::irregular_triangles(20000));
  Surface b(shapes::irregular_triangles(3000, 0.3, 2));
  for (Vec3& p : b.points) p.z() = 0.01 * std::sin(20.0 * p.x());
  const Deviation one = between(a, b, 1);
  const Deviation three = between(a, b, 3);
  EXPECT_EQ(one.a_from_b.of_triangle, three.a_from_b.of_triangle);
  EXPECT_EQ(one.a_from_b.mean, three.a_from_b.mean);
  EXPECT_EQ(one.b_from_a.mean, three.b_from_a.mean);
  EXPECT_NEAR(one.b_from_a.greatest, 0.01, 1e-4);
}

TEST(Deviation, FromNothingIsInfiniteAndOfNothingZero) {
  const Surface sphere(shapes::sphere_triangles(0));
  const Surface nothing{Mesh()};
  const Deviation d = between(nothing, sphere);
  EXPECT_EQ(d.a_from_b.greatest, 0.0);
  EXPECT_EQ(d.a_from_b.mean, 0.0);
  EXPECT_EQ(d.b_from_a.greatest, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace evenmesh
