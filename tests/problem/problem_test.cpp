// SPDX-License-Identifier: MIT
#include "evenmesh/problem/problem.h"

#include <limits>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/cost/global.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

Problem make(const Mesh& mesh, const std::vector<Index>& fixed, const ProblemOptions& options) {
  std::vector<char> flags(mesh.point_count(), 0);
  for (const Index v : fixed) flags[v] = 1;
  return make_problem(mesh, find_orientation(mesh), flags, options);
}

ProblemOptions costs(std::vector<CostChoice> choices) {
  ProblemOptions options;
  options.costs = std::move(choices);
  return options;
}

std::string message_of(const Mesh& mesh, const std::vector<Index>& fixed,
                       const ProblemOptions& options) {
  try {
    make(mesh, fixed, options);
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "";
}

std::string words_of(const std::vector<Term>& terms) {
  std::string result;
  for (const Term& term : terms) {
    result += std::string(term.cost->name()) + "=" + std::to_string(term.weight).substr(0, 3) + " ";
  }
  return result;
}

std::string untangling_words(const Mesh& mesh) {
  return words_of(untangling_terms(mesh, make(mesh, {0, 1}, {})));
}

TEST(DefaultCosts, AreShape) {
  EXPECT_EQ(words_of(make(shapes::triangle_grid(2), {0, 1}, {}).terms), "shape=1.0 ");
  EXPECT_EQ(words_of(make(shapes::hex_grid(1), {0, 1}, {}).terms), "shape=1.0 ");
}

TEST(UntanglingTerms, AreLocalWhereEdgeLengthsDetermineACell) {
  EXPECT_EQ(untangling_words(shapes::triangle_grid(2)), "local=1.0 ");
  EXPECT_EQ(untangling_words(shapes::tet_grid(1)), "local=1.0 ");
  EXPECT_EQ(untangling_words(shapes::sphere_triangles(1)), "local=1.0 ");
}

TEST(UntanglingTerms, AddBarycenterWhereTheyDoNot) {
  const std::string both = "local=0.3 barycenter=0.3 ";
  EXPECT_EQ(untangling_words(shapes::quad_grid(2)), both);
  EXPECT_EQ(untangling_words(shapes::hexagons(3)), both);
  EXPECT_EQ(untangling_words(shapes::mixed_surface(3)), both);
  EXPECT_EQ(untangling_words(shapes::hex_grid(1)), both);
  EXPECT_EQ(untangling_words(shapes::wedge_grid(1)), both);
  EXPECT_EQ(untangling_words(shapes::pyramid_grid(1)), both);
}

TEST(UntanglingTerms, CannotCollapseWhereNothingIsFixed) {
  const Mesh mesh = shapes::triangle_grid(2);
  const Problem held = make(mesh, {0, 1}, {});
  EXPECT_TRUE(untangling_terms(mesh, held)[0].cost->can_collapse());
  const Problem loose = make(mesh, {}, {});
  EXPECT_FALSE(untangling_terms(mesh, loose)[0].cost->can_collapse());
}

TEST(MakeProblem, KeepsTheChosenCostsAndWeights) {
  const Problem problem =
      make(shapes::quad_grid(2), {0, 1}, costs({{"global", 2.5}, {"local", 1}}));
  ASSERT_EQ(problem.terms.size(), 2u);
  EXPECT_EQ(problem.terms[0].cost->name(), "global");
  EXPECT_EQ(problem.terms[0].weight, 2.5);
}

TEST(MakeProblem, NamesWhatItKnowsWhenACostIsUnknown) {
  const std::string message = message_of(shapes::quad_grid(2), {0, 1}, costs({{"locale", 1}}));
  EXPECT_NE(message.find("'locale'"), std::string::npos) << message;
  for (const std::string& name : cost_names()) {
    EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}

TEST(MakeProblem, RefusesWeightsThatAreNotPositiveAndFinite) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_NE(message_of(shapes::quad_grid(2), {0, 1}, costs({{"local", bad}})).find("weight"),
              std::string::npos);
  }
}

TEST(MakeProblem, RefusesACommonLengthThatIsNotPositiveAndFinite) {
  for (const double bad :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    ProblemOptions options = costs({{"global", 1.0}});
    options.global_length = bad;
    EXPECT_NE(message_of(shapes::quad_grid(2), {0, 1}, options), "");
  }
}

TEST(MakeProblem, HasNoTermsWhereNothingMoves) {
  const Mesh mesh = shapes::triangle_grid(1);
  EXPECT_TRUE(make(mesh, {0, 1, 2, 3}, {}).terms.empty());
  EXPECT_TRUE(make(Mesh(), {}, {}).terms.empty());
}

// ---- L of the cost global ----

double length_of(const Mesh& mesh) {
  const Problem problem = make(mesh, {0, 1}, costs({{"global", 1.0}}));
  return dynamic_cast<const Global&>(*problem.terms[0].cost).length();
}

TEST(GlobalLength, IsTheMeanEdgeOfTheInput) {
  const Mesh mesh = shapes::quad_grid(8, 1.0, 0.2);
  EXPECT_DOUBLE_EQ(length_of(mesh), mean_edge_length(mesh));
}

TEST(GlobalLength, ComesFromTheAreaWhenTheInputIsTangled) {
  const Mesh mesh = shapes::quad_grid(8, 1.0, 1.5);
  ASSERT_GT(mean_edge_length(mesh), 0.15);
  EXPECT_NEAR(length_of(mesh), 0.125, 1e-12);
}

TEST(GlobalLength, ComesFromTheAreaWhicheverWayCellsAreWound) {
  const auto third = [](std::size_t cell) { return cell % 3 == 0; };
  EXPECT_NEAR(length_of(shapes::reversed(shapes::quad_grid(8, 1.0, 1.5), third)), 0.125, 1e-12);
  EXPECT_NEAR(length_of(shapes::reversed(shapes::hex_grid(4, 2.0), third)), 0.25, 1e-12);
}

TEST(GlobalLength, DoesNotTakeSurfaceCellsOfAVolumeForInverted) {
  // A jittered block with its bottom listed as quads, as solvers want loads to be.
  const Mesh block = shapes::hex_grid(3, 0.2);
  Cells cells;
  for (std::size_t c = 0; c < block.cells().size(); ++c) {
    cells.add(CellKind::hex, block.cells().vertices(c));
  }
  for (std::size_t c = 0; c < 9; ++c) {
    cells.add(CellKind::quad, block.cells().vertices(c).subspan(0, 4));
  }
  const Mesh mesh({block.points().begin(), block.points().end()}, std::move(cells));
  EXPECT_DOUBLE_EQ(length_of(mesh), mean_edge_length(mesh));
}

// ---- collapse ----

TEST(Collapse, IsRefusedWithTheRemedy) {
  const std::string message = message_of(shapes::triangle_grid(3), {}, costs({{"local", 1.0}}));
  for (const char* remedy : {"--fix boundary", "global", "--scale-free"}) {
    EXPECT_NE(message.find(remedy), std::string::npos) << message;
  }
}

TEST(Collapse, IsRefusedWithOneFixedVertex) {
  EXPECT_NE(message_of(shapes::triangle_grid(3), {5}, costs({{"local", 1.0}})), "");
  EXPECT_NE(message_of(shapes::quad_grid(3), {5}, costs({{"barycenter", 1.0}})), "");
  EXPECT_NE(message_of(shapes::tet_grid(2), {5}, costs({{"local", 1.0}})), "");
  EXPECT_EQ(message_of(shapes::tet_grid(2), {5}, {}), "");  // shape knows no lengths
}

TEST(Collapse, IsRefusedWithTwoFixedVerticesInTheSamePlace) {
  const Mesh grid = shapes::triangle_grid(3);
  std::vector<Vec3> points(grid.points().begin(), grid.points().end());
  points[6] = points[5];
  EXPECT_NE(message_of(Mesh(points, grid.cells()), {5, 6}, costs({{"local", 1.0}})), "");
}

TEST(Collapse, IsRefusedWhenOneOfTwoPiecesIsFree) {
  const Mesh mesh = shapes::two_components(3);
  EXPECT_NE(message_of(mesh, {0, 1, 2}, costs({{"local", 1.0}})), "");
  const auto last = static_cast<Index>(mesh.point_count() - 1);
  EXPECT_EQ(message_of(mesh, {0, 1, last - 1, last}, costs({{"local", 1.0}})), "");
}

TEST(Collapse, CannotHappenWithTwoFixedPlacesOrACostThatHolds) {
  const Mesh mesh = shapes::triangle_grid(3);
  EXPECT_EQ(message_of(mesh, {0, 5}, costs({{"local", 1.0}})), "");
  EXPECT_EQ(message_of(mesh, {}, costs({{"global", 1.0}})), "");
  EXPECT_EQ(message_of(mesh, {}, costs({{"local", 1.0}, {"global", 0.01}})), "");
  ProblemOptions free = costs({{"local", 1.0}, {"barycenter", 1.0}});
  free.scaling = Scaling::scale_free;
  EXPECT_EQ(message_of(mesh, {}, free), "");
  EXPECT_EQ(message_of(shapes::sphere_triangles(1), {}, {}), "");
}

TEST(Collapse, IgnoresVerticesThatNoCellUses) {
  const Mesh grid = shapes::triangle_grid(2);
  std::vector<Vec3> points(grid.points().begin(), grid.points().end());
  points.emplace_back(9, 9, 0);
  EXPECT_EQ(message_of(Mesh(points, grid.cells()), {0, 1}, {}), "");
}

}  // namespace
}  // namespace evenmesh
