// SPDX-License-Identifier: MIT
#include "evenmesh/plot/raster.h"

#include <limits>
#include <numeric>

namespace evenmesh {
namespace {

constexpr double kEqual = 1e-3;  // pixels of depth that do not count
constexpr double kSlack = 2.0;   // for patches that are smaller than a pixel

Pixel middle_of(std::span<const Pixel> polygon) {
  Pixel sum = Pixel::Zero();
  for (const Pixel& p : polygon) sum += p;
  return sum / static_cast<double>(polygon.size());
}

// The part of [low, high) that pixel centres 0.5, 1.5, ... of a row or column of n lie in.
struct Centres {
  int first, last;
};
Centres centres(double low, double high, int n) {
  const auto clipped = [n](double x) { return static_cast<int>(std::clamp(x, 0.0, double(n))); };
  return {clipped(std::ceil(low - 0.5)), clipped(std::ceil(high - 0.5))};
}

// Where the sides of a polygon cross a horizontal line, from left to right.
void find_cuts(std::span<const Pixel> polygon, double y, std::vector<double>& cuts) {
  cuts.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Pixel& a = polygon[i];
    const Pixel& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    cuts.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(cuts.begin(), cuts.end());
}

// Calls visit(pixel, depth, is_inside) for every pixel whose centre lies in the patch, or for the
// one that its middle is in if there is none.
template <typename Visit>
void for_each_pixel(const PatchList& list, const Patch& patch, RasterSize size,
                    std::vector<double>& cuts, const Visit& visit) {
  const std::span<const Pixel> polygon = list.of(patch);
  const Pixel middle = middle_of(polygon);
  const auto [top, bottom] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const Pixel& a, const Pixel& b) { return a.y() < b.y(); });
  const auto at = [&](int row, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
           static_cast<std::size_t>(column);
  };
  bool any = false;
  const Centres rows = centres(top->y(), bottom->y(), size.height);
  for (int row = rows.first; row < rows.last; ++row) {
    find_cuts(polygon, row + 0.5, cuts);
    for (std::size_t k = 0; k + 1 < cuts.size(); k += 2) {
      const Centres columns = centres(cuts[k], cuts[k + 1], size.width);
      for (int column = columns.first; column < columns.last; ++column) {
        const double off = patch.slope.dot(Pixel(column + 0.5, row + 0.5) - middle);
        visit(at(row, column), patch.depth + std::clamp(off, -patch.reach, patch.reach), true);
        any = true;
      }
    }
  }
  const bool in_picture =
      middle.x() >= 0.0 && middle.x() < size.width && middle.y() >= 0.0 && middle.y() < size.height;
  if (any || !in_picture) return;
  visit(at(static_cast<int>(middle.y()), static_cast<int>(middle.x())), patch.depth, false);
}

std::size_t pixels_of(RasterSize size) {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

struct Nearest {
  std::vector<std::uint32_t> patches;
  std::vector<double> depths;
};

Nearest find_nearest(const PatchList& list, RasterSize size) {
  Nearest nearest{std::vector<std::uint32_t>(pixels_of(size), kNoPatch),
                  std::vector<double>(pixels_of(size), -std::numeric_limits<double>::infinity())};
  std::vector<double> cuts;
  for (std::size_t i = 0; i < list.patches.size(); ++i) {
    for_each_pixel(list, list.patches[i], size, cuts, [&](std::size_t pixel, double depth, bool) {
      if (!(depth > nearest.depths[pixel])) return;
      nearest.depths[pixel] = depth;
      nearest.patches[pixel] = static_cast<std::uint32_t>(i);
    });
  }
  return nearest;
}

// From far to near.
std::vector<std::uint32_t> find_visible(const PatchList& list, RasterSize size) {
  const Nearest nearest = find_nearest(list, size);
  std::vector<std::uint32_t> visible;
  std::vector<double> cuts;
  for (std::size_t i = 0; i < list.patches.size(); ++i) {
    const Patch& patch = list.patches[i];
    bool seen = false;
    for_each_pixel(list, patch, size, cuts, [&](std::size_t pixel, double depth, bool is_inside) {
      // A needle between two centres is seen beside what covers them.
      const double slack = is_inside ? kEqual : kSlack + patch.reach;
      seen = seen || depth >= nearest.depths[pixel] - slack;
    });
    if (seen) visible.push_back(static_cast<std::uint32_t>(i));
  }
  std::stable_sort(visible.begin(), visible.end(), [&](std::uint32_t a, std::uint32_t b) {
    return list.patches[a].depth < list.patches[b].depth;
  });
  return visible;
}

}  // namespace

std::vector<std::uint32_t> nearest_patches(const PatchList& list, RasterSize size) {
  return find_nearest(list, size).patches;
}

std::vector<std::vector<std::uint32_t>> visible_layers(const PatchList& list, RasterSize size) {
  std::vector<std::vector<std::uint32_t>> layers;
  std::vector<std::size_t> top(pixels_of(size), 0);  // how many layers lie on the pixel
  std::vector<double> cuts;
  for (const std::uint32_t i : find_visible(list, size)) {
    std::size_t layer = 0;
    for_each_pixel(list, list.patches[i], size, cuts,
                   [&](std::size_t pixel, double, bool) { layer = std::max(layer, top[pixel]); });
    for_each_pixel(list, list.patches[i], size, cuts,
                   [&](std::size_t pixel, double, bool) { top[pixel] = layer + 1; });
    if (layer == layers.size()) layers.emplace_back();
    layers[layer].push_back(i);
  }
  return layers;
}

}  // namespace evenmesh
