// SPDX-License-Identifier: MIT
#include "tests/support/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "evenmesh/base/timer.h"

namespace evenmesh {
namespace {

double doubled_area_xy(const Mesh& mesh, std::size_t cell) {
  const auto v = mesh.cells().vertices(cell);
  double sum = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec3 a = mesh.points()[v[i]];
    const Vec3 b = mesh.points()[v[(i + 1) % v.size()]];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

double least_corner_determinant(const Mesh& mesh, std::size_t cell) {
  const auto v = mesh.cells().vertices(cell);
  const auto x = mesh.points();
  double least = 1e300;
  for (const auto& corner : traits(mesh.cells().kind(cell)).corners) {
    const Vec3 a = x[v[corner.neighbours[0]]] - x[v[corner.vertex]];
    const Vec3 b = x[v[corner.neighbours[1]]] - x[v[corner.vertex]];
    const Vec3 c = x[v[corner.neighbours[2]]] - x[v[corner.vertex]];
    least = std::min(least, a.cross(b).dot(c));
  }
  return least;
}

double radius(const Vec3& p) { return std::hypot(p.x(), p.y()); }

bool on_unit_circle(const Vec3& p) { return std::abs(radius(p) - 1.0) < 1e-15; }

std::size_t inverted_share_percent(const Mesh& mesh) {
  std::size_t inverted = 0;
  for (std::size_t i = 0; i < mesh.cells().size(); ++i) inverted += doubled_area_xy(mesh, i) <= 0.0;
  return 100 * inverted / mesh.cells().size();
}

/// Per vertex: true if a side of only one cell ends there.
std::vector<char> boundary_vertices(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, int> sides;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const auto v = mesh.cells().vertices(c);
    for (std::size_t i = 0; i < v.size(); ++i) {
      ++sides[std::minmax(v[i], v[(i + 1) % v.size()])];
    }
  }
  std::vector<char> boundary(mesh.point_count(), 0);
  for (const auto& [side, count] : sides) {
    EXPECT_LE(count, 2);
    if (count == 1) boundary[side.first] = boundary[side.second] = 1;
  }
  return boundary;
}

TEST(Shapes, PlanarCellsArePositiveAndFillTheirDomain) {
  for (const Mesh& mesh :
       {shapes::fig5(0.2, 0.1), shapes::quad_grid(7, 1.0, 0.2), shapes::triangle_grid(7, 1.0, 0.2),
        shapes::irregular_triangles(9), shapes::irregular_triangles(10, 0.4),
        shapes::irregular_triangles(1000, 0.4, 3), shapes::irregular_triangles(5000)}) {
    double area = 0.0;
    for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
      EXPECT_GT(doubled_area_xy(mesh, i), 0.0) << i;
      area += doubled_area_xy(mesh, i) / 2.0;
    }
    EXPECT_NEAR(area, 1.0, 1e-12);
  }
}

TEST(Shapes, HexagonsAreRegular) {
  const Mesh mesh = shapes::hexagons(3);
  for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
    EXPECT_NEAR(doubled_area_xy(mesh, i) / 2.0, 1.5 * std::sqrt(3.0), 1e-12);
  }
  const auto corners = mesh.cells().corners();
  EXPECT_EQ(std::set<Index>(corners.begin(), corners.end()).size(), mesh.point_count());
}

TEST(Shapes, VolumeCellsArePositiveAtEveryCorner) {
  for (const Mesh& mesh : {shapes::tet_grid(2), shapes::hex_grid(3, 0.1), shapes::wedge_grid(2),
                           shapes::pyramid_grid(2)}) {
    for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
      EXPECT_GT(least_corner_determinant(mesh, i), 0.0);
    }
    const Mesh turned = shapes::reversed(mesh, [](std::size_t) { return true; });
    for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
      EXPECT_LT(least_corner_determinant(turned, i), 0.0);
    }
  }
}

TEST(Shapes, IrregularTrianglesHaveUnevenValenceAndTheCountAskedFor) {
  const Mesh mesh = shapes::irregular_triangles(10000);
  EXPECT_NEAR(static_cast<double>(mesh.point_count()), 10000.0, 200.0);
  std::size_t border = 0;
  for (const Vec3& p : mesh.points()) {
    border += p.x() == 0.0 || p.x() == 1.0 || p.y() == 0.0 || p.y() == 1.0;
  }
  EXPECT_EQ(mesh.cells().size(), 2 * mesh.point_count() - 2 - border);  // Euler
  std::map<Index, int> valence;
  for (const Index v : mesh.cells().corners()) ++valence[v];
  std::map<int, int> count;
  for (const auto& [v, n] : valence) ++count[n];
  EXPECT_GT(count[5], 100);
  EXPECT_GT(count[7], 100);
}

TEST(Shapes, NoiseTurnsTrianglesOver) {
  const Mesh mesh = shapes::irregular_triangles(10000, 0.3, 1, 0.8);
  EXPECT_GE(inverted_share_percent(mesh), 10u);
  EXPECT_LT(inverted_share_percent(mesh), 50u);
}

TEST(Shapes, DiskTrianglesArePositiveAndFillThePolygonOnTheCircle) {
  for (const std::size_t vertices : {19, 50, 200, 1000, 10000}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Mesh mesh = shapes::disk_triangles(vertices, seed);
      double area = 0.0;
      for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
        EXPECT_GT(doubled_area_xy(mesh, i), 0.0) << i;
        area += doubled_area_xy(mesh, i) / 2.0;
      }
      double rim = 0.0;
      const std::vector<char> boundary = boundary_vertices(mesh);
      for (Index v = 0; v < mesh.point_count(); ++v) {
        EXPECT_EQ(on_unit_circle(mesh.points()[v]), boundary[v] == 1) << v;
        rim += boundary[v];
      }
      const double turn = 2.0 * std::numbers::pi / rim;
      EXPECT_NEAR(area, 0.5 * rim * std::sin(turn), 1e-12);
      EXPECT_EQ(static_cast<double>(mesh.cells().size()),
                2.0 * static_cast<double>(mesh.point_count()) - 2.0 - rim);  // Euler
    }
  }
}

TEST(Shapes, DiskTrianglesComeInTheNumberAskedForAndAreDelaunay) {
  EXPECT_EQ(shapes::disk_triangles(1000).point_count(), 1027u);
  EXPECT_EQ(shapes::disk_triangles(1000).cells().size(), 1944u);
  EXPECT_EQ(shapes::disk_triangles(10000).point_count(), 9919u);

  const Mesh mesh = shapes::disk_triangles(200);
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const auto v = mesh.cells().vertices(c);
    const Vec3 a = mesh.points()[v[0]];
    const Vec3 b = mesh.points()[v[1]] - a;
    const Vec3 d = mesh.points()[v[2]] - a;
    const double det = 2.0 * (b.x() * d.y() - b.y() * d.x());
    const Vec3 centre = a + Vec3(d.y() * b.squaredNorm() - b.y() * d.squaredNorm(),
                                 b.x() * d.squaredNorm() - d.x() * b.squaredNorm(), 0.0) /
                                det;
    for (const Vec3& p : mesh.points()) {
      EXPECT_GE((p - centre).norm(), (a - centre).norm() * (1.0 - 1e-8));
    }
  }
}

TEST(Shapes, NoiseTanglesDiskTrianglesAndKeepsTheOrderOnTheCircle) {
  const Mesh smooth = shapes::disk_triangles(1000, 7);
  const Mesh mesh = shapes::disk_triangles(1000, 7, 1.0);
  const auto corners = mesh.cells().corners();
  EXPECT_TRUE(std::equal(corners.begin(), corners.end(), smooth.cells().corners().begin()));
  EXPECT_GE(inverted_share_percent(mesh), 15u);
  EXPECT_LE(inverted_share_percent(mesh), 35u);
  EXPECT_GE(inverted_share_percent(shapes::disk_triangles(1000, 7, 2.0)), 35u);

  const std::vector<char> boundary = boundary_vertices(mesh);
  double last = -1.0;  // turns
  int moved = 0;
  for (Index v = 0; v < mesh.point_count(); ++v) {
    if (boundary[v] == 0) continue;
    const Vec3 p = mesh.points()[v];
    EXPECT_NEAR(radius(p), 1.0, 1e-15);
    const Vec3 before = smooth.points()[v];
    const double slide = std::atan2(before.cross(p).z(), before.dot(p)) / (2.0 * std::numbers::pi);
    double turns = std::atan2(before.y(), before.x()) / (2.0 * std::numbers::pi);
    turns += slide + (turns < -1e-9 ? 1.0 : 0.0);
    EXPECT_GT(turns, last);
    last = turns;
    moved += std::abs(slide) > 1e-5;
  }
  EXPECT_GT(moved, 90);
}

TEST(Shapes, AMillionDiskVerticesTakeSeconds) {
  const double before = cpu_seconds();
  EXPECT_GT(shapes::disk_triangles(1000000).point_count(), 990000u);
  EXPECT_LT(cpu_seconds() - before, 20.0);  // generous: sanitizers
}

TEST(Shapes, AMillionIrregularVerticesTakeSeconds) {
  const double before = cpu_seconds();
  EXPECT_GT(shapes::irregular_triangles(1000000).point_count(), 990000u);
  EXPECT_LT(cpu_seconds() - before, 20.0);  // generous: sanitizers
}

TEST(Shapes, ShuffledMeshesHaveTheSameCells) {
  const Mesh mesh = shapes::mixed_surface(4);
  shapes::Renumbering to;
  const Mesh other = shapes::shuffled(mesh, 5, &to);
  for (std::size_t cell = 0; cell < mesh.cells().size(); ++cell) {
    const auto a = mesh.cells().vertices(cell);
    const auto b = other.cells().vertices(to.cells[cell]);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(to.vertices[a[i]], b[i]);
      EXPECT_EQ(mesh.points()[a[i]], other.points()[b[i]]);
    }
  }
}

}  // namespace
}  // namespace evenmesh
