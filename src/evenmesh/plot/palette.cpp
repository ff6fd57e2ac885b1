// SPDX-License-Identifier: MIT
#include "evenmesh/plot/palette.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace evenmesh {
namespace {

// Lightness rises evenly, and hue with it, so that print in grey and every kind of colour vision
// keep the order.
constexpr std::array<std::array<int, 3>, 6> kStops = {{{0x36, 0x12, 0x5f},
                                                       {0x3d, 0x4a, 0x8f},
                                                       {0x2b, 0x7d, 0x8c},
                                                       {0x46, 0xab, 0x7b},
                                                       {0xa9, 0xd5, 0x66},
                                                       {0xff, 0xf1, 0xa8}}};

}  // namespace

std::string quality_colour(double goodness, double light) {
  const double place = std::clamp(goodness, 0.0, 1.0) * (kStops.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const double part = place - static_cast<double>(k);
  std::array<long, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double dim = i < 2 ? light : (1.0 + light) / 2.0;  // blue shadows, or yellow turns to mud
    rgb[i] = std::lround((kStops[k][i] + part * (kStops[k + 1][i] - kStops[k][i])) * dim);
  }
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

}  // namespace evenmesh
