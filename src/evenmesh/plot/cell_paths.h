// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "evenmesh/plot/raster.h"

namespace evenmesh {

/// How a cell is painted: one of a few classes of quality and of light, so that cells that look
/// alike share an element of the picture.
struct Paint {
  int quality = 0;  // class, 0 the worst; kInverted: turned over
  int light = 0;    // class, kUnlit: as it is

  bool operator==(const Paint&) const = default;
  auto operator<=>(const Paint&) const = default;
};

inline constexpr int kInverted = -1;
inline constexpr int kUnlit = -1;
inline constexpr int kQualityClasses = 20;
inline constexpr int kLightClasses = 6;

/// @param light  cosine between the light and the normal, [0, 1]; negative: unlit
Paint paint_of(bool inverted, double goodness, double light);

/// "#rrggbb"
std::string fill(const Paint& paint);

enum class Edges { drawn, left_out };

/// SVG paths of patches, layer by layer; those of one paint in a layer share a path. Coordinates
/// are whole tenths of a pixel.
std::string cell_paths(const PatchList& list, std::span<const Paint> paints,
                       std::span<const std::vector<std::uint32_t>> layers, Edges edges,
                       double line_width);

/// SVG paths of a raster, one per paint, of horizontal runs of pixels.
std::string pixel_paths(std::span<const std::uint32_t> patches, std::span<const Paint> paints,
                        RasterSize size);

}  // namespace evenmesh
