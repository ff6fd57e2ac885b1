// SPDX-License-Identifier: MIT
//
// A cost that somebody else writes, the whole way through.
#include <set>

#include <gtest/gtest.h>

#include "evenmesh/solver/smooth.h"
#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

// sum over cells and their vertices of |x - centroid of the cell|^2
class Compact final : public Cost {
 public:
  std::string_view name() const override { return "compact"; }
  double evaluate(const CellBlock& cells, Points x, double weight,
                  std::span<Vec3> gradient) const override {
    double sum = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      Vec3 centroid = Vec3::Zero();
      for (const Index v : cells.cell(i)) centroid += x[v] / cells.vertices_per_cell;
      for (const Index v : cells.cell(i)) {
        sum += (x[v] - centroid).squaredNorm();
        if (!gradient.empty()) gradient[v] += 2.0 * weight * (x[v] - centroid);
      }
    }
    return weight * sum;
  }
  bool can_collapse() const override { return true; }
};

// On triangles it is a third of the sum of squared edge lengths, an interior edge counted twice:
// at the minimum every interior vertex is the mean of its neighbours.
TEST(OwnCost, BringsEveryVertexToTheMeanOfItsNeighbours) {
  Mesh mesh = shapes::irregular_triangles(500, 0.3);
  Problem problem = testing_setup::problem_of(mesh);
  problem.terms = {{2.0, std::make_shared<Compact>()}};
  Options options;
  options.tolerance = 1e-9;
  options.judge = Judge::inversion;
  const Report report = smooth(mesh, problem, options);
  EXPECT_EQ(report.stop, Stop::converged);
  ASSERT_EQ(report.held, 0u);

  std::vector<std::set<Index>> neighbours(mesh.point_count());
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    for (const Index v : mesh.cells().vertices(c)) {
      neighbours[v].insert(mesh.cells().vertices(c).begin(), mesh.cells().vertices(c).end());
    }
  }
  for (std::size_t v = 0; v < mesh.point_count(); ++v) {
    if (problem.motion.freedom(static_cast<Index>(v)) == Motion::Freedom::fixed) continue;
    Vec3 mean = Vec3::Zero();
    for (const Index w : neighbours[v]) mean += mesh.points()[w];
    mean = (mean - mesh.points()[v]) / static_cast<double>(neighbours[v].size() - 1);
    EXPECT_NEAR((mesh.points()[v] - mean).norm(), 0.0, 1e-7) << "vertex " << v;
  }
}

TEST(OwnCost, MixesWithTheOthers) {
  Mesh mesh = shapes::quad_grid(8, 1.0, 0.3);
  Problem problem = testing_setup::problem_of(mesh);
  problem.terms.push_back({0.1, std::make_shared<Compact>()});
  const Report report = smooth(mesh, problem);
  EXPECT_EQ(report.stop, Stop::converged);
  EXPECT_LE(testing_setup::farthest(mesh.points(), shapes::quad_grid(8).points()), 1e-5);
}

}  // namespace
}  // namespace evenmesh
