// SPDX-License-Identifier: MIT
#include "evenmesh/plot/raster.h"

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

// A level rectangle.
void add(PatchList& list, const Pixel& low, const Pixel& high, double depth) {
  const std::size_t first = list.places.size();
  for (const Pixel& p : {low, Pixel(high.x(), low.y()), high, Pixel(low.x(), high.y())}) {
    list.places.push_back(p);
  }
  list.patches.push_back({first, first + 4, depth, Pixel::Zero(), 0.0});
}

using Layers = std::vector<std::vector<std::uint32_t>>;

TEST(NearestPatches, CoverThePixelsWhoseCentresAreInside) {
  PatchList list;
  add(list, {1.4, 0.6}, {3.5, 2.0}, 0.0);
  const std::uint32_t o = kNoPatch;
  // Of the centres 1.5 and 2.5 across and 1.5 down; 3.5 is the next patch's, 0.5 is above.
  EXPECT_EQ(nearest_patches(list, {4, 3}),
            (std::vector<std::uint32_t>{o, o, o, o, o, 0, 0, o, o, o, o, o}));
}

TEST(NearestPatches, OfNeighboursShareNoPixelAndLeaveNone) {
  PatchList list;
  add(list, {0.0, 0.0}, {1.5, 2.0}, 0.0);
  add(list, {1.5, 0.0}, {3.0, 2.0}, 0.0);
  EXPECT_EQ(nearest_patches(list, {3, 2}), (std::vector<std::uint32_t>{0, 1, 1, 0, 1, 1}));
}

TEST(NearestPatches, FollowTheSlope) {
  // Two patches that cross: one level, one that comes nearer to the right.
  PatchList list;
  add(list, {0, 0}, {4, 1}, 0.0);
  add(list, {0, 0}, {4, 1}, 0.0);
  list.patches[1].slope = {1.0, 0.0};
  list.patches[1].reach = 2.0;
  EXPECT_EQ(nearest_patches(list, {4, 1}), (std::vector<std::uint32_t>{0, 0, 1, 1}));
}

TEST(VisibleLayers, LeaveOutWhatIsHidden) {
  PatchList list;
  add(list, {0, 0}, {4, 4}, 1.0);
  add(list, {1, 1}, {3, 3}, 0.0);
  EXPECT_EQ(visible_layers(list, {4, 4}), (Layers{{0}}));
}

TEST(VisibleLayers, PutTheNearerOnTop) {
  PatchList list;
  add(list, {2, 0}, {6, 4}, 5.0);
  add(list, {0, 0}, {4, 4}, 0.0);
  add(list, {6, 0}, {8, 4}, 9.0);  // beside both
  EXPECT_EQ(visible_layers(list, {8, 4}), (Layers{{1, 2}, {0}}));
}

TEST(VisibleLayers, KeepWhatIsSmallerThanAPixel) {
  PatchList list;
  add(list, {0, 0}, {4, 4}, 0.0);
  add(list, {1.1, 1.1}, {1.3, 1.3}, 0.0);
  EXPECT_EQ(visible_layers(list, {4, 4}), (Layers{{0}, {1}}));
}

TEST(VisibleLayers, OfWhatLiesOutsideAreNone) {
  PatchList list;
  add(list, {-9, -9}, {-1, -1}, 0.0);
  add(list, {1e9, 0}, {2e9, 3}, 0.0);
  EXPECT_TRUE(visible_layers(list, {4, 4}).empty());
}

}  // namespace
}  // namespace evenmesh
