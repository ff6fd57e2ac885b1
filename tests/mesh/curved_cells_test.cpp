// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/curved_cells.h"

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

/// A mesh of one cell of second order with straight edges, its nodes behind the corners in the
/// order edges, quads, whole.
struct OneCell {
  explicit OneCell(CellKind kind, bool with_middles = false) {
    const CellTraits& row = traits(kind);
    std::vector<Index> corners;
    std::vector<Vec3> points;
    for (const auto& p : row.ideal) {
      corners.push_back(static_cast<Index>(points.size()));
      points.emplace_back(p[0], p[1], p[2]);
    }
    const auto add = [&](const std::vector<Index>& leaders) {
      Vec3 middle = Vec3::Zero();
      for (const Index v : leaders) middle += points[v] / static_cast<double>(leaders.size());
      followers.add(static_cast<Index>(points.size()), leaders);
      points.push_back(middle);
    };
    for (const auto edge : row.edges) add({edge.a, edge.b});
    for (const auto& face : row.faces) {
      if (with_middles && face.count == 4) add({face.vertices.begin(), face.vertices.end()});
    }
    if (with_middles && (kind == CellKind::quad || kind == CellKind::hex)) add(corners);
    Cells cells;
    cells.add(kind, corners);
    mesh = Mesh(points, std::move(cells));
    orientation = find_orientation(mesh);
  }
  std::vector<Vec3> points() const { return {mesh.points().begin(), mesh.points().end()}; }
  /// The node in the middle of the first edge.
  Index first_middle() const { return followers.vertex(0); }

  Mesh mesh;
  Followers followers;
  Orientation orientation;
};

constexpr CellKind kJudged[] = {CellKind::triangle, CellKind::quad, CellKind::tet, CellKind::hex,
                                CellKind::wedge};

TEST(CurvedCells, StraightOnesAreNone) {
  for (const CellKind kind : kJudged) {
    for (const bool with_middles : {false, true}) {
      const OneCell one(kind, with_middles);
      EXPECT_EQ(CurvedCells(one.mesh, one.followers, one.orientation).size(), 0u)
          << traits(kind).name;
    }
  }
}

TEST(CurvedCells, ANodeBeyondTheQuarterOfItsEdgeInvertsTheCorner) {
  // Along an edge of length 1 from 0 the map is x = 2 u^2 (1 - 2 m) + u (4 m - 1) with its node at
  // m: its derivative at the end is negative for m < 1/4, whatever the kind (Barsoum, 1976, puts
  // nodes there to make a crack's singularity).
  for (const CellKind kind : kJudged) {
    SCOPED_TRACE(traits(kind).name);
    OneCell one(kind);
    const Vec3 a = one.mesh.points()[one.followers.leaders(0)[0]];
    const Vec3 b = one.mesh.points()[one.followers.leaders(0)[1]];
    for (const double m : {0.24, 0.26, 0.4, 0.74, 0.76}) {
      std::vector<Vec3> points = one.points();
      points[one.first_middle()] = (1 - m) * a + m * b;
      Mesh bent = one.mesh;
      bent.set_points(points);
      const CurvedCells curved(bent, one.followers, one.orientation);
      ASSERT_EQ(curved.size(), 1u);
      EXPECT_EQ(curved.inverted(points).size(), m < 0.25 || m > 0.75 ? 1u : 0u) << m;
    }
  }
}

TEST(CurvedCells, AParabolaMayBendSoFar) {
  // A unit square whose lower edge is bent up to a parabola of height h: the determinant at the
  // corners is 1 -+ 0, in the middle of the lower edge 1 - h, and at the middle of the square with
  // a straight middle node 1 - h as well; the edge reaches the top at h = 1.
  for (const double h : {0.9, 1.1}) {
    const OneCell one(CellKind::quad);
    std::vector<Vec3> points = one.points();
    points[one.first_middle()].y() += h;
    Mesh bent = one.mesh;
    bent.set_points(points);
    const CurvedCells curved(bent, one.followers, one.orientation);
    EXPECT_EQ(curved.inverted(points).size(), h > 1 ? 1u : 0u) << h;
  }
}

TEST(CurvedCells, MiddlesOfFacesCountWhereTheyAre) {
  // Following its bent edges a quad's own middle may go along, and then nothing is inverted.
  const OneCell one(CellKind::quad, true);
  std::vector<Vec3> points = one.points();
  points[4].y() += 0.4;
  points[6].y() += 0.4;
  Mesh bent = one.mesh;
  bent.set_points(points);
  std::vector<Vec3> with_middle = points;
  with_middle[8].y() += 0.4;
  const CurvedCells curved(bent, one.followers, one.orientation);
  EXPECT_TRUE(curved.inverted(with_middle).empty());
  with_middle[8].y() += 0.6;  // beyond
  EXPECT_EQ(curved.inverted(with_middle).size(), 1u);
}

TEST(CurvedCells, MapsAreThoseOfTheUsualShapeFunctions) {
  // A map of second order x(u) = u + q(u) puts the nodes of a 27-node hex where it takes them; its
  // determinant, known by hand, changes its sign where CurvedCells says so.
  const OneCell one(CellKind::hex, true);
  for (const double c : {0.45, 0.55}) {
    std::vector<Vec3> points = one.points();
    for (Vec3& p : points) p.x() -= c * p.x() * p.x() * p.y();  // determinant 1 - 2 c x y
    Mesh bent = one.mesh;
    bent.set_points(points);
    const CurvedCells curved(bent, one.followers, one.orientation);
    ASSERT_EQ(curved.size(), 1u);
    EXPECT_EQ(curved.inverted(points).size(), c > 0.5 ? 1u : 0u) << c;
  }
}

TEST(CurvedCells, SpoiltIsWhatWasBetterBefore) {
  const OneCell one(CellKind::triangle);
  std::vector<Vec3> points = one.points();
  points[one.first_middle()].y() += 0.3;
  Mesh bent = one.mesh;
  bent.set_points(points);
  const CurvedCells curved(bent, one.followers, one.orientation);
  EXPECT_TRUE(curved.spoilt(points).empty());
  points[2].y() = 0.5;  // the third corner comes down to the bent edge
  one.followers.follow(bent.points(), points);
  EXPECT_EQ(curved.spoilt(points), std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace evenmesh
