// SPDX-License-Identifier: MIT
//
// What the paper says of the methods it compares with, on the look-alike of its Fig. 12.
#include <gtest/gtest.h>

#include "apps/evenmesh/gallery/figures.h"
#include "apps/evenmesh/gallery/run.h"
#include "evenmesh/solver/smooth.h"

namespace evenmesh::gallery {
namespace {

Report smooth_teardrop(Method method, Judge judge) {
  const Case& fixed_boundary = *find_cases("fig15a").at(0);
  Mesh mesh = start_mesh(fixed_boundary);
  Problem problem = problem_of(fixed_boundary, Way::paper, mesh);
  return smooth(mesh, problem, {.method = method, .judge = judge});
}

class ForceMethods : public testing::TestWithParam<Method> {};

TEST_P(ForceMethods, FoldTheTeardropUnlessGuarded) {
  const Report alone = smooth_teardrop(GetParam(), Judge::nothing);
  EXPECT_EQ(alone.quality_before.inverted, 0u);
  EXPECT_GT(alone.quality_after.inverted, 0u);
  RecordProperty("inverted", static_cast<int>(alone.quality_after.inverted));

  const Report guarded = smooth_teardrop(GetParam(), Judge::quality_and_inversion);
  EXPECT_EQ(guarded.quality_after.inverted, 0u);
  EXPECT_EQ(guarded.inverted_unguarded, alone.quality_after.inverted);
  EXPECT_GE(guarded.quality_after.of(Metric::shape).worst,
            guarded.quality_before.of(Metric::shape).worst);
}

INSTANTIATE_TEST_SUITE_P(All, ForceMethods,
                         testing::Values(Method::lennard_jones, Method::lennard_jones_printed,
                                         Method::pliant),
                         [](const auto& variant) { return std::string(name(variant.param)); });

TEST(Laplacian, ComesAsCloseOnTheTeardropAsTheLocalCost) {
  const Report laplacian = smooth_teardrop(Method::laplacian, Judge::nothing);
  const Report local = smooth_teardrop(Method::lagrange_newton, Judge::quality_and_inversion);
  EXPECT_EQ(laplacian.quality_after.inverted, 0u);
  EXPECT_NEAR(laplacian.quality_after.of(Metric::shape).mean,
              local.quality_after.of(Metric::shape).mean, 0.01);
  EXPECT_GT(laplacian.cost_after, local.cost_after);
}

}  // namespace
}  // namespace evenmesh::gallery
