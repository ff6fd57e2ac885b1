// SPDX-License-Identifier: MIT
#include "evenmesh/plot/cell_paths.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "evenmesh/plot/palette.h"

namespace evenmesh {
namespace {

constexpr double kUnits = 10.0;  // per pixel
constexpr double kDarkest = 0.66;
// Far outside the picture: enough for a polygon that reaches there, not too much for a renderer.
constexpr double kFarthest = 1e6;

// Numbers with a space between them, which a minus sign makes needless.
void append(std::string& data, long number) {
  if (number >= 0 && !data.empty() && data.back() >= '0' && data.back() <= '9') data += ' ';
  fmt::format_to(std::back_inserter(data), "{}", number);
}

// Starts absolute and goes on relative: shorter.
void append_polygon(std::string& data, std::span<const Pixel> polygon) {
  const auto whole = [](double x) {
    return std::lround(std::clamp(x, -kFarthest, kFarthest) * kUnits);
  };
  long x = 0;
  long y = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const long px = whole(polygon[i].x());
    const long py = whole(polygon[i].y());
    if (i < 2) data += i == 0 ? 'M' : 'l';
    append(data, px - x);
    append(data, py - y);
    x = px;
    y = py;
  }
  data += 'z';
}

std::string path(const Paint& paint, const std::string& data, Edges edges, double line_width) {
  const std::string colour = fill(paint);
  std::string look = fmt::format("fill=\"{}\"", colour);
  if (edges == Edges::left_out) {
    look += fmt::format(" stroke=\"{}\"", colour);  // or white shines through between neighbours
  } else if (paint.quality == kInverted) {
    look += fmt::format(R"( stroke="{}" stroke-opacity="1" stroke-width="{}")", kInvertedEdge,
                        svg_number(std::max(1.6 * line_width, 0.5) * kUnits));
  }
  return fmt::format("<path {} d=\"{}\"/>\n", look, data);
}

}  // namespace

Paint paint_of(bool inverted, double goodness, double light) {
  const auto class_of = [](double x, int classes) {
    return std::clamp(static_cast<int>(x * classes), 0, classes - 1);
  };
  return {inverted ? kInverted : class_of(goodness, kQualityClasses),
          light < 0.0 ? kUnlit : class_of(light, kLightClasses)};
}

std::string fill(const Paint& paint) {
  if (paint.quality == kInverted) return kInvertedColour;
  const double part = (paint.light + 1.0) / kLightClasses;
  const double light = paint.light == kUnlit ? 1.0 : kDarkest + (1.0 - kDarkest) * part;
  return quality_colour((paint.quality + 0.5) / kQualityClasses, light);
}

std::string cell_paths(const PatchList& list, std::span<const Paint> paints,
                       std::span<const std::vector<std::uint32_t>> layers, Edges edges,
                       double line_width) {
  const std::string stroke =
      edges == Edges::drawn
          ? fmt::format(R"(stroke="#1b1b1b" stroke-opacity=".55" stroke-width="{}")",
                        svg_number(line_width * kUnits))
          : std::string(R"(stroke-width="4")");
  std::string result = fmt::format("<g transform=\"scale({})\" stroke-linejoin=\"round\" {}>\n",
                                   svg_number(1.0 / kUnits), stroke);
  for (const std::vector<std::uint32_t>& layer : layers) {
    std::map<Paint, std::string, std::greater<>> data;  // the worst last: never covered
    for (const std::uint32_t i : layer) append_polygon(data[paints[i]], list.of(list.patches[i]));
    for (const auto& [paint, polygons] : data) result += path(paint, polygons, edges, line_width);
  }
  return result + "</g>\n";
}

std::string pixel_paths(std::span<const std::uint32_t> patches, std::span<const Paint> paints,
                        RasterSize size) {
  struct Runs {
    std::string data;
    long x = 0, y = 0;  // where the last one ended
  };
  std::map<Paint, Runs> all;
  const auto width = static_cast<std::size_t>(size.width);
  for (std::size_t start = 0; start < patches.size();) {
    const std::size_t row_end = (start / width + 1) * width;
    std::size_t end = start + 1;
    const auto paint = [&](std::size_t pixel) { return paints[patches[pixel]]; };
    const bool empty = patches[start] == kNoPatch;
    while (end < row_end && (patches[end] == kNoPatch) == empty &&
           (empty || paint(end) == paint(start))) {
      ++end;
    }
    if (!empty) {
      Runs& runs = all[paint(start)];
      const long x = static_cast<long>(start % width);
      const long y = static_cast<long>(start / width);
      runs.data += 'm';
      append(runs.data, x - runs.x);
      append(runs.data, y - runs.y);
      runs.data += 'h';
      append(runs.data, static_cast<long>(end - start));
      runs.x = x + static_cast<long>(end - start);
      runs.y = y;
    }
    start = end;
  }
  std::string result = "<g transform=\"translate(0 .5)\" fill=\"none\" stroke-width=\"1.02\">\n";
  for (const auto& [paint, runs] : all) {
    result += fmt::format("<path stroke=\"{}\" d=\"{}\"/>\n", fill(paint), runs.data);
  }
  return result + "</g>\n";
}

}  // namespace evenmesh
