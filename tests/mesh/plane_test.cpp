// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/plane.h"

#include <numeric>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace evenmesh {
namespace {

std::vector<Index> all(const std::vector<Vec3>& points) {
  std::vector<Index> vertices(points.size());
  std::iota(vertices.begin(), vertices.end(), Index{0});
  return vertices;
}

/// Points at random in a box of that size around a place, turned by a rotation.
std::vector<Vec3> cloud(const Vec3& size, const Vec3& place, const Eigen::Matrix3d& turn) {
  shapes::Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) {
    const Vec3 p(random.signed_unit(), random.signed_unit(), random.signed_unit());
    points.push_back(turn * p.cwiseProduct(size) + place);
  }
  return points;
}

const Eigen::Matrix3d kStraight = Eigen::Matrix3d::Identity();
const Eigen::Matrix3d kTurned =
    Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();

TEST(CommonPlane, HasAnExactNormalWhereACoordinateIsConstant) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 size(1, 1, 1);
    size[axis] = 0.0;
    const auto points = cloud(size, Vec3(0.1, 0.1, 0.1), kStraight);
    EXPECT_EQ(common_plane(points, all(points), 1e-7), Vec3(Vec3::Unit(axis)));
  }
}

TEST(CommonPlane, IsFoundThroughThinHugeTinyAndDistantPoints) {
  const Vec3 expected = kTurned * Vec3(0, 0, 1);
  for (const Vec3& size : {Vec3(1, 1, 0), Vec3(1, 1e-5, 0), Vec3(1e-3, 1, 0)}) {
    for (const double scale : {1e-150, 1.0, 1e150}) {
      const auto points = cloud(scale * size, Vec3(5, 6, 7) * scale, kTurned);
      const auto normal = common_plane(points, all(points), 1e-7);
      ASSERT_TRUE(normal);
      EXPECT_NEAR((*normal - expected).norm(), 0.0, 1e-9) << size.transpose() << " " << scale;
    }
  }
}

TEST(CommonPlane, ForgivesAsMuchAsTheTolerance) {
  const auto flat = cloud(Vec3(1, 1, 3e-8), Vec3::Zero(), kTurned);
  EXPECT_TRUE(common_plane(flat, all(flat), 1e-7));
  const auto bumpy = cloud(Vec3(1, 1, 3e-6), Vec3::Zero(), kTurned);
  EXPECT_FALSE(common_plane(bumpy, all(bumpy), 1e-7));
  const auto solid = cloud(Vec3(1, 1, 1), Vec3::Zero(), kTurned);
  EXPECT_FALSE(common_plane(solid, all(solid), 1e-7));
}

TEST(CommonPlane, ExistsForPointsOnALineAndForOnePoint) {
  const auto line = cloud(Vec3(1, 0, 0), Vec3(1, 1, 1), kTurned);
  const auto normal = common_plane(line, all(line), 1e-7);
  ASSERT_TRUE(normal);
  EXPECT_NEAR(normal->dot(kTurned * Vec3(1, 0, 0)), 0.0, 1e-9);
  EXPECT_NEAR(normal->norm(), 1.0, 1e-15);
  const std::vector<Vec3> one{{3, 4, 5}};
  EXPECT_EQ(common_plane(one, all(one), 1e-7), Vec3(0, 0, 1));
  EXPECT_FALSE(common_plane({}, {}, 1e-7));
}

TEST(CommonPlane, LooksAtTheGivenVerticesOnly) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 9}};
  const std::vector<Index> three{0, 1, 2};
  EXPECT_EQ(common_plane(points, three, 1e-7), Vec3(0, 0, 1));
  const std::vector<Vec3> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_FALSE(common_plane(tetrahedron, all(tetrahedron), 1e-7));
}

}  // namespace
}  // namespace evenmesh
