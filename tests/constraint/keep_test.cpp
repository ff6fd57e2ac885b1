// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/keep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/measure.h"
#include "tests/constraint/differences.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using Group = std::optional<std::uint32_t>;

std::shared_ptr<const Function> keep(const Mesh& mesh, Keep what, Group group = {}) {
  return keep_function(mesh, find_orientation(mesh), what, group);
}

double total(const Mesh& mesh, Keep what, Group group = {}) {
  return keep(mesh, what, group)->at(mesh.points());
}

std::string complaint(const Mesh& mesh, Keep what, Group group = {},
                      std::optional<double> value = {}) {
  try {
    make_keep(mesh, find_orientation(mesh), what, group, value);
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// All points displaced at random, in the plane of a planar mesh too.
std::vector<Vec3> disturbed(const Mesh& mesh, double by, std::uint64_t seed = 3) {
  shapes::Random random(seed);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  for (Vec3& p : points) {
    for (double& coordinate : p) coordinate += by * random.signed_unit();
  }
  return points;
}

/// A hexagonal prism of height 1: two polygons and six quads, outward.
Mesh prism() {
  std::vector<Vec3> points;
  for (const double z : {0.0, 1.0}) {
    for (int i = 0; i < 6; ++i) {
      const double angle = i * std::numbers::pi / 3.0;
      points.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  }
  Cells cells;
  cells.add(CellKind::polygon, std::array<Index, 6>{5, 4, 3, 2, 1, 0});
  cells.add(CellKind::polygon, std::array<Index, 6>{6, 7, 8, 9, 10, 11});
  for (Index i = 0; i < 6; ++i) {
    const Index j = (i + 1) % 6;
    cells.add(CellKind::quad, std::array<Index, 4>{i, j, j + 6, i + 6});
  }
  return Mesh(points, cells);
}

Mesh join(const Mesh& a, const Mesh& b) {
  std::vector<Vec3> points(a.points().begin(), a.points().end());
  points.insert(points.end(), b.points().begin(), b.points().end());
  Cells cells = a.cells();
  for (std::size_t c = 0; c < b.cells().size(); ++c) {
    std::vector<Index> vertices(b.cells().vertices(c).begin(), b.cells().vertices(c).end());
    for (Index& v : vertices) v += static_cast<Index>(a.point_count());
    cells.add(b.cells().kind(c), vertices, 1);
  }
  return Mesh(points, cells);
}

TEST(Keep, KnowsSquaresCubesAndPrisms) {
  EXPECT_NEAR(total(shapes::irregular_triangles(500), Keep::area), 1.0, 1e-14);
  EXPECT_NEAR(total(shapes::quad_grid(7, 3.0, 0.3), Keep::area), 9.0, 1e-13);
  EXPECT_NEAR(total(shapes::hexagons(4), Keep::area), 16 * 1.5 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(total(shapes::cube_surface(3), Keep::area), 6.0, 1e-14);
  EXPECT_NEAR(total(shapes::cube_surface(3), Keep::volume), 1.0, 1e-14);
  EXPECT_NEAR(total(prism(), Keep::area), 6.0 + 3.0 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(total(prism(), Keep::volume), 1.5 * std::sqrt(3.0), 1e-14);
  for (const Mesh& mesh : {shapes::tet_grid(2), shapes::hex_grid(3, 0.2), shapes::wedge_grid(2),
                           shapes::pyramid_grid(2)}) {
    EXPECT_NEAR(total(mesh, Keep::volume), 1.0, 1e-14);
  }
}

TEST(Keep, TendsToTheSphere) {
  const Mesh coarse = shapes::sphere_triangles(3);
  const Mesh fine = shapes::sphere_triangles(4);
  const double area = 4.0 * std::numbers::pi;
  const double volume = area / 3.0;
  // Errors of second order: a quarter per level.
  EXPECT_NEAR((area - total(coarse, Keep::area)) / (area - total(fine, Keep::area)), 4.0, 0.05);
  EXPECT_NEAR((volume - total(coarse, Keep::volume)) / (volume - total(fine, Keep::volume)), 4.0,
              0.05);
  EXPECT_NEAR(total(fine, Keep::volume), volume, 0.02);
}

// The sums over boundary and skin against the plain sums over cells, away from the input too.
TEST(Keep, IsTheSumOverCells) {
  int meshes = 0;
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Orientation orientation = find_orientation(mesh);
    const bool is_volume = orientation.type == MeshType::volume;
    const auto function = keep(mesh, is_volume ? Keep::volume : Keep::area);
    for (const double by : {0.0, 0.3}) {
      Mesh other = mesh;
      other.set_points(disturbed(mesh, by));
      double sum = 0.0;
      double size = 0.0;
      for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
        const double its = oriented_size(other, orientation, c);
        sum += its;
        size += std::abs(its);
      }
      EXPECT_NEAR(function->at(other.points()), sum, 1e-12 * (1.0 + size)) << name;
    }
    ++meshes;
  }
  EXPECT_GT(meshes, 10);
}

TEST(Keep, HasTrueGradients) {
  const auto check = [](const Mesh& mesh, Keep what) {
    const auto function = keep(mesh, what);
    expect_true_gradient(*function, disturbed(mesh, 0.1), 1e-7);
  };
  check(shapes::irregular_triangles(60), Keep::area);
  check(shapes::quad_grid(4, 1.0, 0.3), Keep::area);
  check(shapes::hexagons(3), Keep::area);
  for (const Mesh& mesh : {shapes::sphere_triangles(1), shapes::cube_surface(2), prism()}) {
    check(mesh, Keep::area);
    check(mesh, Keep::volume);
  }
  check(shapes::mixed_surface(4), Keep::area);
  check(shapes::hex_grid(2, 0.2), Keep::volume);
  check(shapes::wedge_grid(2), Keep::volume);
  check(shapes::pyramid_grid(1), Keep::volume);
}

TEST(Keep, DependsOnTheOutlineAloneWhereItCan) {
  const Mesh plane = shapes::quad_grid(5);
  EXPECT_EQ(keep(plane, Keep::area)->vertices().size(), 20u);
  const Mesh block = shapes::hex_grid(4);
  EXPECT_EQ(keep(block, Keep::volume)->vertices().size(), 125u - 27u);
  const auto shuffled = keep(shapes::shuffled(block, 5), Keep::volume);
  const auto vertices = shuffled->vertices();
  EXPECT_TRUE(std::is_sorted(vertices.begin(), vertices.end()));
}

TEST(Keep, DoesNotChangeUnderRigidMotion) {
  const auto moved = [](const Mesh& mesh) {
    return shapes::moved(shapes::rotated(mesh, Vec3(1, 2, 3), 0.8), Vec3(1e3, -2e3, 5e2));
  };
  const Mesh sphere = shapes::sphere_triangles(2);
  const Mesh plane = shapes::triangle_grid(5, 1.0, 0.2);
  const Mesh block = shapes::hex_grid(2, 0.2);
  EXPECT_NEAR(total(moved(sphere), Keep::volume) / total(sphere, Keep::volume), 1.0, 1e-12);
  EXPECT_NEAR(total(moved(sphere), Keep::area) / total(sphere, Keep::area), 1.0, 1e-12);
  EXPECT_NEAR(total(moved(plane), Keep::area), 1.0, 1e-12);
  EXPECT_NEAR(total(moved(block), Keep::volume), 1.0, 1e-12);
  // The gradient makes no net force and so no translation changes the total.
  const auto function = keep(sphere, Keep::volume);
  std::vector<Vec3> gradient(function->vertices().size());
  function->at(sphere.points(), gradient);
  Vec3 sum = Vec3::Zero();
  for (const Vec3& g : gradient) sum += g;
  EXPECT_LT(sum.norm(), 1e-13);
}

TEST(Keep, DoesNotDependOnWinding) {
  const auto third = [](std::size_t cell) { return cell % 3 == 0; };
  const auto every = [](std::size_t) { return true; };
  const Mesh sphere = shapes::sphere_triangles(2);
  const Mesh plane = shapes::triangle_grid(5, 1.0, 0.2);
  const Mesh block = shapes::tet_grid(2);
  EXPECT_NEAR(total(shapes::reversed(sphere, third), Keep::volume), total(sphere, Keep::volume),
              1e-13);
  EXPECT_NEAR(total(shapes::reversed(sphere, every), Keep::volume), total(sphere, Keep::volume),
              1e-13);
  EXPECT_NEAR(total(shapes::reversed(plane, third), Keep::area), 1.0, 1e-13);
  EXPECT_NEAR(total(shapes::reversed(block, third), Keep::volume), 1.0, 1e-13);
}

TEST(Keep, SubtractsCavities) {
  const Mesh outer = shapes::scaled(shapes::cube_surface(2), 3.0);
  const Mesh inner = shapes::moved(shapes::cube_surface(2), Vec3(1, 1, 1));
  EXPECT_NEAR(total(join(outer, inner), Keep::volume), 28.0, 1e-13);
  const Mesh inward = shapes::reversed(inner, [](std::size_t) { return true; });
  EXPECT_NEAR(total(join(outer, inward), Keep::volume), 26.0, 1e-13);
}

TEST(Keep, TakesAGroup) {
  const Mesh plane = shapes::grouped(shapes::quad_grid(4), [](std::size_t c) { return c % 4 / 2; });
  EXPECT_NEAR(total(plane, Keep::area, 0), 0.5, 1e-14);
  EXPECT_NEAR(total(plane, Keep::area, 1), 0.5, 1e-14);
  EXPECT_EQ(keep(plane, Keep::area, 1)->vertices().size(), 12u);
  expect_true_gradient(*keep(plane, Keep::area, 1), disturbed(plane, 0.1));
  const Mesh block = shapes::grouped(shapes::hex_grid(2), [](std::size_t c) { return c == 3; });
  EXPECT_NEAR(total(block, Keep::volume, 1), 0.125, 1e-14);
  EXPECT_NEAR(total(block, Keep::volume, 0), 0.875, 1e-14);
  const Mesh two = join(shapes::cube_surface(2), shapes::sphere_triangles(1));
  EXPECT_NEAR(total(two, Keep::volume, 0), 1.0, 1e-14);
}

TEST(Keep, SumsSurfaceCellsBesideVolumeCells) {
  const Mesh block = shapes::hex_grid(1);
  Cells cells = block.cells();
  cells.add(CellKind::quad, std::array<Index, 4>{0, 1, 3, 2}, 4);
  const Mesh mesh({block.points().begin(), block.points().end()}, cells);
  EXPECT_DOUBLE_EQ(total(mesh, Keep::area), 1.0);
  EXPECT_DOUBLE_EQ(total(mesh, Keep::volume), 1.0);
  EXPECT_TRUE(has(complaint(mesh, Keep::volume, 4), "the group has no volume cells"));
}

TEST(Keep, BoundsTheTotalOfTheInputOrAGivenOne) {
  const Mesh sphere = shapes::sphere_triangles(2);
  const Orientation orientation = find_orientation(sphere);
  const Bound bound = make_keep(sphere, orientation, Keep::volume);
  EXPECT_TRUE(bound.is_equation());
  EXPECT_EQ(bound.lower, bound.function->at(sphere.points()));
  EXPECT_EQ(bound.function->name(), "volume");
  EXPECT_EQ(make_keep(sphere, orientation, Keep::area, {}, 12.5).upper, 12.5);
}

TEST(Keep, HasNoSlopeAtACellWithoutArea) {
  Cells cells;
  cells.add(CellKind::triangle, std::array<Index, 3>{0, 1, 2});
  cells.add(CellKind::triangle, std::array<Index, 3>{3, 4, 5});
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {2, 2, 1}}, cells);
  const auto function = keep(mesh, Keep::area);
  std::vector<Vec3> gradient(6);
  EXPECT_DOUBLE_EQ(function->at(mesh.points(), gradient), 0.5);
  EXPECT_TRUE(gradient[4].isZero(0.0));
}

TEST(Keep, SaysWhatCannotBeKept) {
  EXPECT_TRUE(has(complaint(shapes::quad_grid(2), Keep::volume), "planar"));
  EXPECT_TRUE(has(complaint(shapes::cylinder_side(6, 2), Keep::volume), "12 boundary edges"));
  EXPECT_TRUE(has(complaint(shapes::moebius_strip(8), Keep::volume), "not closed"));
  EXPECT_TRUE(has(complaint(shapes::hex_grid(2), Keep::area), "no surface cells; try volume"));
  EXPECT_TRUE(has(complaint(shapes::sphere_triangles(1), Keep::area, 7), "the group has no"));
  EXPECT_TRUE(has(complaint(Mesh(), Keep::area), "no surface cells"));
  for (const double value : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_TRUE(has(complaint(shapes::quad_grid(2), Keep::area, {}, value), "positive and finite"));
  }
}

// A Klein bottle is closed but has no inside: a grid on a torus, glued with a flip one way round.
TEST(Keep, SaysWhereASurfaceHasNoInside) {
  constexpr Index n = 6;
  const auto number = [](Index i, Index j) {
    if (i == n) return (n - j) % n;
    return i * n + j % n;
  };
  std::vector<Vec3> points;
  shapes::Random random(1);
  for (Index i = 0; i < n * n; ++i) {
    points.emplace_back(random.signed_unit(), random.signed_unit(), random.signed_unit());
  }
  Cells cells;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      cells.add(CellKind::quad, std::array<Index, 4>{number(i, j), number(i + 1, j),
                                                     number(i + 1, j + 1), number(i, j + 1)});
    }
  }
  EXPECT_TRUE(has(complaint(Mesh(points, cells), Keep::volume), "no inside and outside"));
}

}  // namespace
}  // namespace evenmesh
