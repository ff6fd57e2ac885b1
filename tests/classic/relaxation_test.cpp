// SPDX-License-Identifier: MIT
#include "evenmesh/classic/relaxation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/classic/worst_shape.h"
#include "evenmesh/geometry/analytic_tracks.h"
#include "evenmesh/mesh/topology.h"
#include "tests/classic/star_of.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing_classic::Around;
using testing_classic::fan;
using testing_classic::l_shape;

// Those that go from vertex to vertex.
std::vector<Method> methods() {
  std::vector<Method> all;
  for (const std::string_view word : method_names()) {
    const Method method = method_of(std::string(word));
    if (method == Method::lagrange_newton || method == Method::global_laplacian) continue;
    all.push_back(method);
  }
  return all;
}

// A mesh, and what a relaxation of it needs; vertices on the boundary are fixed.
struct Bench {
  explicit Bench(Mesh mesh_, double length_ = 0.1)
      : mesh(std::move(mesh_)), orientation(find_orientation(mesh)), length(length_) {
    motion = Motion(mesh, orientation, find_topology(mesh, orientation).boundary);
  }
  std::vector<Vec3> after(Method method, int sweeps, int threads = 1) const {
    const auto relaxation = make_relaxation(method, {mesh, orientation, motion, length});
    Workers workers(threads);
    std::vector<Vec3> x(mesh.points().begin(), mesh.points().end());
    Motion::Places places = motion.start();
    for (int i = 0; i < sweeps; ++i) relaxation->sweep(workers, x, places);
    return x;
  }

  Mesh mesh;
  Orientation orientation;
  Motion motion;
  double length;
};

double farthest(Points a, Points b) {
  double most = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, (a[v] - b[v]).norm());
  return most;
}

TEST(Relaxation, MovesEveryVertexThatMayAndNoOther) {
  const Bench bench(shapes::irregular_triangles(200, 0.3));
  for (const Method method : methods()) {
    const std::vector<Vec3> x = bench.after(method, 1);
    std::size_t moved = 0;
    for (Index v = 0; v < x.size(); ++v) {
      const bool same = x[v] == bench.mesh.points()[v];
      moved += !same;
      if (bench.motion.freedom(v) == Motion::Freedom::fixed) {
        EXPECT_TRUE(same) << name(method) << v;
      }
    }
    EXPECT_GT(moved, bench.motion.moving() / 2) << name(method);
  }
}

TEST(Relaxation, FollowsTurnsShiftsAndScales) {
  // Nearly regular: forces amplify the rounding of the input where edges are short.
  const Mesh mesh = shapes::irregular_triangles(200, 0.1);
  const Bench bench(mesh, 0.08);
  const auto changed = [](const Mesh& m) {
    return shapes::scaled(shapes::moved(shapes::rotated(m, Vec3(1, 2, 3), 0.7), Vec3(1, -2, 3)),
                          3.0);
  };
  const Bench other(changed(mesh), 0.24);
  for (const Method method : methods()) {
    Mesh expected = mesh;
    expected.set_points(bench.after(method, 2));
    EXPECT_LT(farthest(other.after(method, 2), changed(expected).points()), 1e-8) << name(method);
  }
}

TEST(Relaxation, HasTheSameBitsForAnyNumberOfThreads) {
  const Bench bench(shapes::irregular_triangles(3000, 0.3), 0.02);
  for (const Method method : methods()) {
    EXPECT_EQ(bench.after(method, 3, 1), bench.after(method, 3, 2)) << name(method);
  }
}

TEST(Relaxation, KeepsVerticesOnTheirLineAndCircle) {
  Mesh mesh = shapes::disk_triangles(200);
  const Orientation orientation = find_orientation(mesh);
  const Topology topology = find_topology(mesh, orientation);
  std::vector<char> fixed(mesh.point_count(), 0);
  Motion motion(mesh, orientation, fixed);
  const auto circle = std::make_shared<CircleTrack>(Vec3(0, 0, 0), Vec3(0, 0, 1), 1.0);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    const Vec3& p = mesh.points()[v];
    if (topology.boundary[v] != 0) {
      motion.put_on_track(v, circle, circle->nearest(p, {p, Vec3::Zero(), 0}));
    }
  }
  motion.keep_on_line(3, mesh.points()[3], Vec3(1, 0, 0));
  for (const Method method : methods()) {
    const auto relaxation = make_relaxation(method, {mesh, orientation, motion, 0.1});
    Workers workers;
    std::vector<Vec3> x(mesh.points().begin(), mesh.points().end());
    Motion::Places places = motion.start();
    for (int i = 0; i < 3; ++i) relaxation->sweep(workers, x, places);
    EXPECT_EQ(x[3][1], mesh.points()[3][1]) << name(method);
    EXPECT_NE(x[3][0], mesh.points()[3][0]) << name(method);
    double off = 0.0;
    bool moved = false;
    for (Index v = 0; v < x.size(); ++v) {
      if (topology.boundary[v] == 0) continue;
      off = std::max(off, std::abs(x[v].norm() - 1.0));
      moved = moved || x[v] != mesh.points()[v];
    }
    EXPECT_LT(off, 1e-14) << name(method);
    EXPECT_TRUE(moved) << name(method);
  }
}

TEST(Relaxation, TakesTiedVerticesAlong) {
  Mesh mesh = shapes::quad_grid(3, 3.0);
  std::vector<Vec3> x(mesh.points().begin(), mesh.points().end());
  x[4] += Vec3(0, 0.3, 0);  // and its image
  x[7] += Vec3(0, 0.3, 0);
  mesh.set_points(x);
  const Orientation orientation = find_orientation(mesh);
  std::vector<char> fixed(16, 1);
  fixed[4] = fixed[7] = 0;
  Motion motion(mesh, orientation, fixed);
  motion.tie(7, 4, mesh.points());
  const auto relaxation = make_relaxation(Method::laplacian, {mesh, orientation, motion, 1.0});
  Workers workers;
  Motion::Places places = motion.start();
  relaxation->sweep(workers, x, places);
  // Three neighbours each; those inside pull to the left at one end and to the right at the other.
  EXPECT_NEAR((x[4] - Vec3(0, 1, 0)).norm(), 0.0, 1e-15);
  EXPECT_EQ(x[7] - x[4], mesh.points()[7] - mesh.points()[4]);
}

TEST(Relaxation, SmartIsPlainWhereEveryMoveHelps) {
  const Bench bench(shapes::fig5(0.3, 0.1));
  EXPECT_EQ(bench.after(Method::smart_laplacian, 1), bench.after(Method::laplacian, 1));
}

TEST(Relaxation, SmartAndCombinedDoNotFollowAMeanThatLiesOutside) {
  const Bench bench(fan(Vec3(0.3, 0.4, 0), l_shape()), 1.0);
  const auto worst = [&](Points x) {
    const Around around(bench.mesh, 0);
    return WorstShape(around.mesh(), around.orientation()).of(around.star(), x).shape;
  };
  EXPECT_EQ(worst(bench.after(Method::laplacian, 1)), 0.0) << "plain smoothing did not fold";
  EXPECT_EQ(bench.after(Method::smart_laplacian, 1)[0], bench.mesh.points()[0]);
  EXPECT_GT(worst(bench.after(Method::combined, 1)), worst(bench.mesh.points()) + 1e-3);
  EXPECT_GT(worst(bench.after(Method::combined, 20)), worst(bench.after(Method::combined, 1)));
}

TEST(Relaxation, SmartAndCombinedNeverLowerTheWorstShape) {
  const Bench bench(shapes::irregular_triangles(500, 0.4));
  for (const Method method : {Method::smart_laplacian, Method::combined}) {
    const auto relaxation =
        make_relaxation(method, {bench.mesh, bench.orientation, bench.motion, 0.0});
    Workers workers;
    const WorstShape shapes(bench.mesh, bench.orientation);
    std::vector<Vec3> x(bench.mesh.points().begin(), bench.mesh.points().end());
    Motion::Places places;
    double before = 0.0;
    for (int i = 0; i < 10; ++i) {
      relaxation->sweep(workers, x, places);
      double worst = 1.0;
      for (std::uint32_t c = 0; c < bench.mesh.cells().size(); ++c) {
        worst = std::min(worst, shapes.of_cell(c, x));
      }
      EXPECT_GE(worst, before);
      before = worst;
    }
  }
}

TEST(Relaxation, LaplacianLowersTheSumOfSquaredEdges) {
  const Bench bench(shapes::irregular_triangles(300, 0.3));
  const auto sum = [&](Points x) {
    const Stars stars(bench.mesh,
                      Motion(bench.mesh, bench.orientation, std::vector<char>(x.size(), 0)));
    double total = 0.0;
    for (Index v = 0; v < x.size(); ++v) {
      for (const Link& link : stars.of(v).links) total += (x[link.to] - x[v]).squaredNorm();
    }
    return total;
  };
  double before = sum(bench.mesh.points());
  for (int sweeps = 1; sweeps < 6; ++sweeps) {
    const double now = sum(bench.after(Method::laplacian, sweeps));
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST(Relaxation, OfCellsItDoesNotKnowIsRefusedByName) {
  const auto message = [](Method method, const Mesh& mesh) -> std::string {
    try {
      check_cells(method, mesh.cells());
    } catch (const InvalidOption& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message(Method::angle_based, shapes::hex_grid(1))
                .find("the method angle_based is for triangles, and cell 0 is a hex"),
            std::string::npos);
  EXPECT_NE(
      message(Method::optimal_delaunay, shapes::quad_grid(2))
          .find("the method optimal_delaunay is for triangles and tets, and cell 0 is a quad"),
      std::string::npos);
  EXPECT_EQ(message(Method::optimal_delaunay, shapes::tet_grid(1)), "");
  EXPECT_EQ(message(Method::angle_based, shapes::sphere_triangles(0)), "");
  EXPECT_NE(message(Method::angle_based, shapes::mixed_surface(6)), "");
  for (const Method method : {Method::laplacian, Method::combined, Method::pliant}) {
    EXPECT_EQ(message(method, shapes::pyramid_grid(1)), "");
  }
}

}  // namespace
}  // namespace evenmesh
