// SPDX-License-Identifier: MIT
#include "evenmesh/solver/layout.h"

#include <chrono>
#include <mutex>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "tests/solver/setup.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

std::vector<shapes::Named> meshes() {
  std::vector<shapes::Named> all = shapes::zoo();
  const Mesh large = shapes::irregular_triangles(20000);
  all.push_back({"large", large});
  all.push_back({"shuffled", shapes::shuffled(large, 1)});
  all.push_back({"empty", Mesh()});
  return all;
}

TEST(Layout, HasEveryCellOnce) {
  for (const auto& [name, mesh] : meshes()) {
    const Layout layout(mesh.cells(), mesh.point_count());
    std::vector<int> seen(mesh.cells().size(), 0);
    std::vector<int> places(mesh.cells().size(), 0);
    Workers workers;
    layout.for_blocks(workers, [&](std::size_t, const Layout::Block& block) {
      ASSERT_EQ(block.cells.size(), block.cells.numbers.size());
      for (std::size_t i = 0; i < block.cells.size(); ++i) {
        const std::uint32_t number = block.cells.numbers[i];
        ++seen.at(number);
        ++places.at(block.first + i);
        const auto cell = block.cells.cell(i);
        const auto original = mesh.cells().vertices(number);
        EXPECT_EQ(block.cells.kind, mesh.cells().kind(number));
        EXPECT_TRUE(std::equal(cell.begin(), cell.end(), original.begin(), original.end()));
      }
    });
    EXPECT_EQ(seen, std::vector<int>(seen.size(), 1)) << name;
    EXPECT_EQ(places, seen) << name;
    EXPECT_EQ(layout.cells(), mesh.cells().size()) << name;
  }
}

TEST(Layout, NeverLetsThreadsMeetInAVertex) {
  for (const auto& [name, mesh] : meshes()) {
    if (mesh.point_count() < 1000) continue;
    const Layout layout(mesh.cells(), mesh.point_count());
    std::mutex mutex;
    std::vector<std::size_t> busy(mesh.point_count(), 0);  // 0: nobody, else the chunk + 1
    bool met = false;
    Workers workers(4);
    layout.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
      {
        const std::lock_guard lock(mutex);
        for (const Index v : block.cells.vertices) {
          if (busy[v] != 0 && busy[v] != chunk + 1) met = true;
          busy[v] = chunk + 1;
        }
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      const std::lock_guard lock(mutex);
      for (const Index v : block.cells.vertices) busy[v] = 0;
    });
    EXPECT_FALSE(met) << name;
  }
}

TEST(Layout, RunsChunksOfAGoodOrderTogether) {
  const Mesh mesh = shapes::irregular_triangles(20000);
  const Layout layout(mesh.cells(), mesh.point_count());
  std::mutex mutex;
  std::set<std::thread::id> threads;
  Workers workers(4);
  layout.for_blocks(workers, [&](std::size_t, const Layout::Block&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_GT(threads.size(), 1u);
}

// All cells meet in one vertex, numbered last: no two chunks may run together.
TEST(Layout, TakesAHubThatEveryCellUses) {
  const Index rim = 10000;
  Cells cells;
  for (Index v = 0; v < rim; ++v) {
    cells.add(CellKind::triangle, std::vector<Index>{v, (v + 1) % rim, rim});
  }
  const Layout layout(cells, rim + 1);
  std::mutex mutex;
  std::size_t running = 0;
  bool together = false;
  Workers workers(4);
  layout.for_blocks(workers, [&](std::size_t, const Layout::Block&) {
    {
      const std::lock_guard lock(mutex);
      together = together || running++ > 0;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const std::lock_guard lock(mutex);
    --running;
  });
  EXPECT_FALSE(together);
}

TEST(ColourItems, GivesItemsWithACommonResourceDifferentColours) {
  shapes::Random random(1);
  std::vector<std::vector<std::uint32_t>> resources(200);
  for (auto& own : resources) {
    for (int k = 0; k < 4; ++k) own.push_back(static_cast<std::uint32_t>(random.below(100)));
  }
  const auto colours = colour_items(resources, 100);
  std::size_t items = 0;
  for (const auto& colour : colours) {
    EXPECT_TRUE(std::is_sorted(colour.begin(), colour.end()));
    std::vector<int> owner(100, -1);
    for (const std::uint32_t item : colour) {
      ++items;
      for (const std::uint32_t r : resources[item]) {
        EXPECT_TRUE(owner[r] == -1 || owner[r] == static_cast<int>(item));
        owner[r] = static_cast<int>(item);
      }
    }
  }
  EXPECT_EQ(items, resources.size());
}

TEST(ColourItems, NeedsTwoColoursForAChain) {
  const std::vector<std::vector<std::uint32_t>> chain{{0}, {0, 1}, {1, 2}, {2, 3}, {3}};
  EXPECT_EQ(colour_items(chain, 4), (std::vector<std::vector<std::uint32_t>>{{0, 2, 4}, {1, 3}}));
}

TEST(ColourItems, PutsItemsWithoutResourcesTogether) {
  EXPECT_EQ(colour_items(std::vector<std::vector<std::uint32_t>>(3), 0).size(), 1u);
  EXPECT_TRUE(colour_items({}, 0).empty());
}

}  // namespace
}  // namespace evenmesh
