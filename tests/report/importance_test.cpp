// SPDX-License-Identifier: MIT
#include "evenmesh/report/importance.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "evenmesh/report/run_record.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

Importance rank(const Mesh& mesh) {
  Workers workers;
  const Orientation orientation = find_orientation(mesh);
  const CellQuality quality = measure_cells(workers, mesh, mesh.points(), orientation);
  return rank_cells({.before = mesh, .orientation = orientation, .quality_before = quality});
}

TEST(Importance, ListsEveryCellOnce) {
  for (const Mesh& mesh : {shapes::triangle_grid(40, 1.0, 0.3), shapes::tet_grid(9), Mesh()}) {
    Importance importance = rank(mesh);
    std::sort(importance.cells.begin(), importance.cells.end());
    ASSERT_EQ(importance.cells.size(), mesh.cells().size());
    for (std::size_t c = 0; c < importance.cells.size(); ++c) EXPECT_EQ(importance.cells[c], c);
  }
}

TEST(Importance, BeginsWithTheWorst) {
  const Mesh mesh = shapes::triangle_grid(60, 1.0, 0.3);
  const Importance importance = rank(mesh);
  Workers workers;
  const std::vector<std::size_t> worst =
      worst_cells(measure_cells(workers, mesh, mesh.points(), find_orientation(mesh)),
                  important(mesh.cells().size()));
  EXPECT_TRUE(std::equal(worst.begin(), worst.end(), importance.cells.begin()));
}

TEST(Importance, PutsTheInsideOfVolumesLast) {
  const Mesh mesh = shapes::hex_grid(20);
  const Importance importance = rank(mesh);
  // All are equally good, so the worst are the first in the file, at one side.
  EXPECT_GE(importance.outer, 20 * 20 * 20 - 18 * 18 * 18);
  EXPECT_LT(importance.outer, mesh.cells().size());
  const auto inside = [](std::uint32_t cell) {
    for (const std::uint32_t at : {cell % 20, cell / 20 % 20, cell / 400}) {
      if (at == 0 || at == 19) return false;
    }
    return true;
  };
  EXPECT_TRUE(std::all_of(importance.cells.begin() + static_cast<int>(importance.outer),
                          importance.cells.end(), inside));
}

TEST(Importance, SpreadsTheRestEvenly) {
  const Mesh mesh = shapes::quad_grid(100);
  const Importance importance = rank(mesh);
  EXPECT_EQ(importance.outer, mesh.cells().size());
  // Of a quarter of the cells, a quarter is in each quarter of the file.
  std::array<int, 4> in_quarter{};
  const std::size_t first = 600;
  for (std::size_t i = first; i < first + 2500; ++i) ++in_quarter[importance.cells[i] / 2500];
  for (const int q : {1, 2, 3}) EXPECT_NEAR(in_quarter[static_cast<std::size_t>(q)], 700, 150);
}

}  // namespace
}  // namespace evenmesh
