// SPDX-License-Identifier: MIT
#include "tests/cli/promise.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "evenmesh/io/mesh_file.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/problem/constraints.h"
#include "evenmesh/quality/quality.h"
#include "tests/io/patch_checker.h"
#include "tests/io/temporary_folder.h"

namespace evenmesh::testing {
namespace {

void expect_same_cells(const Cells& a, const Cells& b) {
  EXPECT_TRUE(std::ranges::equal(a.corners(), b.corners()));
  EXPECT_TRUE(std::ranges::equal(a.offsets(), b.offsets()));
}

void expect_fixed_vertices_have_their_bits(const Mesh& before, const Mesh& after,
                                           const Orientation& orientation,
                                           const Followers& followers) {
  Problem problem;
  problem.orientation = orientation;
  apply(before, find_topology(before, orientation), {}, problem);
  std::vector<char> follows(before.point_count(), 0);
  for (std::size_t i = 0; i < followers.size(); ++i) follows[followers.vertex(i)] = 1;
  for (Index v = 0; v < before.point_count(); ++v) {
    if (follows[v] || problem.motion.freedom(v) != Motion::Freedom::fixed) continue;
    ASSERT_EQ(std::memcmp(&before.points()[v], &after.points()[v], sizeof(Vec3)), 0)
        << "vertex " << v;
  }
}

void expect_no_worse(const Mesh& before, const Mesh& after, const Orientation& orientation) {
  Workers workers(1);
  const auto measured = [&](const Mesh& mesh) {
    return summarize(workers, measure_cells(workers, mesh, mesh.points(), orientation));
  };
  const QualitySummary a = measured(before);
  const QualitySummary b = measured(after);
  EXPECT_LE(b.inverted, a.inverted);
  const bool untangled = a.inverted > 0 && b.inverted == 0;
  if (!untangled) {
    EXPECT_GE(b.of(Metric::shape).mean, a.of(Metric::shape).mean);
  }
  for (const Metric metric : kMetrics) {
    if (a.inverted > 0) break;  // getting rid of those comes first
    EXPECT_FALSE(worse(metric, b.of(metric).worst, a.of(metric).worst)) << name(metric);
  }
}

}  // namespace

void expect_promise(const std::filesystem::path& before, const std::filesystem::path& after) {
  SCOPED_TRACE(before.string());
  const MeshFile a = read_mesh(before);
  const MeshFile b = read_mesh(after);
  ASSERT_EQ(a.mesh.point_count(), b.mesh.point_count());
  expect_same_cells(a.mesh.cells(), b.mesh.cells());
  EXPECT_EQ(difference_of_files(a, b.mesh.points(), before, after), "");
  const Orientation orientation = find_orientation(a.mesh);
  expect_fixed_vertices_have_their_bits(a.mesh, b.mesh, orientation, a.followers);
  expect_no_worse(a.mesh, b.mesh, orientation);
}

}  // namespace evenmesh::testing
