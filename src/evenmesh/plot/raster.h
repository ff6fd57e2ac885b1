// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "evenmesh/plot/svg.h"

namespace evenmesh {

/// A polygon of a picture, with what decides where several lie on top of each other.
struct Patch {
  std::size_t first, last;  // its places in PatchList::places
  double depth;             // towards the viewer, pixels; of planar pictures: the greater wins
  Pixel slope;              // of the depth to the right and down
  double reach;             // by how much depth varies over the polygon
};

struct PatchList {
  std::vector<Pixel> places;
  std::vector<Patch> patches;

  std::span<const Pixel> of(const Patch& patch) const {
    return {places.data() + patch.first, places.data() + patch.last};
  }
};

struct RasterSize {
  int width, height;  // pixels
};

inline constexpr std::uint32_t kNoPatch = 0xFFFFFFFF;

/// Per pixel, row by row, the patch that is nearest to the viewer at its centre. One that covers no
/// centre counts for the pixel that its own middle is in.
std::vector<std::uint32_t> nearest_patches(const PatchList& list, RasterSize size);

/// The patches that can be seen, in layers from far to near: within a layer none covers another.
std::vector<std::vector<std::uint32_t>> visible_layers(const PatchList& list, RasterSize size);

}  // namespace evenmesh
