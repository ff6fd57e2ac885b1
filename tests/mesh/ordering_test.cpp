// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/ordering.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

template <typename Number>
bool is_permutation_of(const std::vector<Number>& order, std::size_t n) {
  std::vector<Number> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (sorted[i] != i) return false;
  }
  return order.size() == n;
}

// How far apart the numbers of a cell's vertices are, on average.
double mean_span(const Mesh& mesh, const std::vector<Index>& order) {
  std::vector<Index> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<Index>(k);
  double sum = 0.0;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    Index low = ~Index{0};
    Index high = 0;
    for (const Index v : mesh.cells().vertices(c)) {
      low = std::min(low, number[v]);
      high = std::max(high, number[v]);
    }
    sum += high - low;
  }
  return sum / static_cast<double>(mesh.cells().size());
}

std::vector<Index> as_it_is(const Mesh& mesh) {
  std::vector<Index> order(mesh.point_count());
  for (Index v = 0; v < order.size(); ++v) order[v] = v;
  return order;
}

TEST(BreadthFirstOrder, IsAPermutationOfVerticesAndCells) {
  for (const auto& [name, mesh] : shapes::zoo()) {
    const Ordering ordering = breadth_first_order(mesh);
    EXPECT_TRUE(is_permutation_of(ordering.vertices, mesh.point_count())) << name;
    EXPECT_TRUE(is_permutation_of(ordering.cells, mesh.cells().size())) << name;
  }
}

TEST(BreadthFirstOrder, BringsNeighboursTogether) {
  const Mesh mesh = shapes::shuffled(shapes::irregular_triangles(10000), 1);
  const double before = mean_span(mesh, as_it_is(mesh));
  const double after = mean_span(mesh, breadth_first_order(mesh).vertices);
  EXPECT_GT(before, 3000.0);  // half of all vertices, on average
  EXPECT_LT(after, 200.0);    // about the longest front, of 100 to 170 vertices
}

TEST(BreadthFirstOrder, ListsCellsByTheirLeastVertex) {
  const Mesh mesh = shapes::shuffled(shapes::quad_grid(20), 1);
  const Ordering ordering = breadth_first_order(mesh);
  std::vector<Index> number(mesh.point_count());
  for (std::size_t k = 0; k < number.size(); ++k)
    number[ordering.vertices[k]] = static_cast<Index>(k);
  Index last = 0;
  for (const std::uint32_t c : ordering.cells) {
    Index least = ~Index{0};
    for (const Index v : mesh.cells().vertices(c)) least = std::min(least, number[v]);
    EXPECT_GE(least, last);
    last = least;
  }
}

TEST(BreadthFirstOrder, PutsUnusedVerticesLast) {
  Cells cells;
  cells.add(CellKind::triangle, std::vector<Index>{1, 3, 5});
  const Mesh mesh({{9, 9, 9}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-5, 0, 0}, {0, 1, 0}},
                  std::move(cells));
  const Ordering ordering = breadth_first_order(mesh);
  ASSERT_TRUE(is_permutation_of(ordering.vertices, 6));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(ordering.vertices[k] % 2, 1u);
}

TEST(BreadthFirstOrder, IsFineWithPointsInOnePlaceAndAtTheEndsOfTheRange) {
  const Mesh grid = shapes::triangle_grid(5);
  const double most = std::numeric_limits<double>::max();
  for (const double size : {0.0, 1e-310, 1e-160, 1e150, most}) {
    std::vector<Vec3> points(grid.points().begin(), grid.points().end());
    for (Vec3& p : points) p = size * (2.0 * p - Vec3(1, 1, 0));
    const Ordering ordering = breadth_first_order(Mesh(points, grid.cells()));
    EXPECT_TRUE(is_permutation_of(ordering.vertices, grid.point_count())) << size;
    if (size > 1e-300) {
      EXPECT_EQ(ordering.vertices, breadth_first_order(grid).vertices) << size;
    }
  }
}

TEST(BreadthFirstOrder, OfNothingIsNothing) {
  const Ordering ordering = breadth_first_order(Mesh());
  EXPECT_TRUE(ordering.vertices.empty());
  EXPECT_TRUE(ordering.cells.empty());
}

TEST(HasGoodOrder, TellsSweptFromShuffled) {
  const Mesh mesh = shapes::irregular_triangles(20000);
  EXPECT_TRUE(has_good_order(mesh.cells()));
  EXPECT_FALSE(has_good_order(shapes::shuffled(mesh, 1).cells()));
  EXPECT_TRUE(has_good_order(shapes::shuffled(shapes::triangle_grid(40), 1).cells()));  // in cache
  EXPECT_TRUE(has_good_order(Cells()));
}

}  // namespace
}  // namespace evenmesh
