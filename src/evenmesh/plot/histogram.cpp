// SPDX-License-Identifier: MIT
#include "evenmesh/plot/histogram.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "evenmesh/plot/axis.h"
#include "evenmesh/plot/palette.h"
#include "evenmesh/plot/svg.h"

namespace evenmesh {
namespace {

constexpr double kRight = 26.0;
constexpr double kBottom = 58.0;
constexpr double kRow = 24.0;   // of the marks of one mesh
constexpr double kSlot = 26.0;  // the width of a bin outside the range
constexpr double kSlotGap = 10.0;
constexpr double kFont = 13.0;
constexpr double kBeside = 9.0;  // from the middle of a marker to its text
constexpr double kApart = 12.0;  // between two texts
constexpr std::size_t kLongestName = 24;

constexpr const char* kFilled = R"(fill="#b9c6d1" stroke="#8fa1b0" stroke-width="0.6")";
constexpr const char* kOutlined =
    R"(fill="none" stroke="#0b3c5d" stroke-width="2" stroke-linejoin="miter")";

struct Row {
  std::string name;
  QualityBins bins;
  bool any = false;
  double worst = 0.0;
  double mean = 0.0;
};

// Worst and mean over the cells that the metric applies to, inverted ones included.
Row row_of(const HistogramMesh& mesh, Metric metric, const MetricRange& range, int bins) {
  Row row{shortened(mesh.name, kLongestName), count_bins(mesh.quality, metric, range, bins)};
  double sum = 0.0;
  for (const double value : mesh.quality.of(metric)) {
    if (std::isnan(value)) continue;
    if (!row.any || worse(metric, value, row.worst)) row.worst = value;
    row.any = true;
    sum += value;
  }
  if (row.any) row.mean = sum / static_cast<double>(row.bins.total);
  return row;
}

class Histogram {
 public:
  Histogram(const std::vector<HistogramMesh>& meshes, const HistogramOptions& options)
      : options_(options),
        range_(range_of(meshes, options.metric)),
        x_(value_axis()),
        y_(Axis::without_ticks()) {
    double widest = 0.0;
    std::size_t most = 0;
    for (const HistogramMesh& mesh : meshes) {
      rows_.push_back(row_of(mesh, options.metric, range_, options.bins));
      const Row& row = rows_.back();
      widest = std::max(widest, text_width(row.name, kFont));
      has_inverted_ = has_inverted_ || row.bins.inverted > 0;
      has_beyond_ = has_beyond_ || row.bins.beyond > 0;
      most = std::max({most, row.bins.inverted, row.bins.beyond});
      for (const std::size_t count : row.bins.counts) {
        highest_ = std::max(highest_, share(count, row));
      }
      for (const std::size_t count : {row.bins.inverted, row.bins.beyond}) {
        highest_ = std::max(highest_, share(count, row));
      }
    }
    if (highest_ > 0.0) y_ = Axis::from_zero(highest_, 6);
    left_ = std::max(72.0, widest + 42.0);
    top_ = (options.title.empty() ? 10.0 : 36.0) + kRow * static_cast<double>(rows_.size()) + 6.0;
    bottom_ = std::max(options.height - kBottom, top_ + 120.0);
    right_ = std::max(options.width - kRight, left_ + 160.0);
    from_ = left_ + (has_inverted_ ? kSlot + 2.0 * kSlotGap : kSlotGap);
    to_ = right_ - (has_beyond_ ? kSlot + 2.0 * kSlotGap : kSlotGap);
  }

  std::string draw() const {
    Svg svg(right_ + kRight, bottom_ + kBottom);
    if (!options_.title.empty()) {
      svg.text({(left_ + right_) / 2.0, 24.0}, shortened(options_.title, 80),
               R"(font-size="16" font-weight="bold" text-anchor="middle")");
    }
    draw_shares(svg);
    draw_filled(svg, rows_.front());
    if (rows_.size() > 1) draw_outlined(svg, rows_.back());
    draw_values(svg);
    if (highest_ == 0.0) {
      svg.text({(left_ + right_) / 2.0, (top_ + bottom_) / 2.0}, "no cell has this measure",
               R"(font-size="14" text-anchor="middle" fill="#666")");
    }
    svg.rectangle({left_, top_}, {right_ - left_, bottom_ - top_},
                  R"(fill="none" stroke="#222" stroke-width="1.2")");
    for (std::size_t i = 0; i < rows_.size(); ++i) draw_marks(svg, rows_[i], i);
    return std::move(svg).finish();
  }

 private:
  static MetricRange range_of(const std::vector<HistogramMesh>& meshes, Metric metric) {
    std::vector<const CellQuality*> all;
    for (const HistogramMesh& mesh : meshes) all.push_back(&mesh.quality);
    return metric_range(metric, all);
  }

  Axis value_axis() const { return Axis::linear(range_.low, range_.high, 10); }

  // In percent of the row's cells.
  static double share(std::size_t count, const Row& row) {
    return row.bins.total == 0
               ? 0.0
               : 100.0 * static_cast<double>(count) / static_cast<double>(row.bins.total);
  }

  double across(double value) const {
    return from_ + std::clamp(x_.place(value), 0.0, 1.0) * (to_ - from_);
  }
  // Where a value is marked: beyond the range in the middle of its slot.
  double mark_place(double value) const {
    if (has_beyond_ && value > range_.high) return to_ + kSlotGap + kSlot / 2.0;
    return across(value);
  }
  double up(double percent) const { return bottom_ - y_.place(percent) * (bottom_ - top_); }
  double edge(std::size_t bin) const {
    return from_ + (to_ - from_) * static_cast<double>(bin) / options_.bins;
  }

  void draw_shares(Svg& svg) const {
    for (const Tick& tick : y_.ticks()) {
      const double y = bottom_ - tick.place * (bottom_ - top_);
      svg.line({left_, y}, {right_, y}, R"(stroke="#e4e4e4")");
      svg.text({left_ - 8.0, y + 4.5}, tick.label,
               fmt::format("font-size=\"{}\" text-anchor=\"end\"", kFont), tick.raised);
    }
    const Pixel middle(left_ - 50.0, (top_ + bottom_) / 2.0);
    svg.text(middle, "share of the cells (%)",
             fmt::format(R"--(font-size="14" text-anchor="middle" transform="rotate(-90 {} {})")--",
                         svg_number(middle.x()), svg_number(middle.y())));
  }

  void draw_filled(Svg& svg, const Row& row) const {
    const auto bar = [&](double left, double right, std::size_t count, std::string_view look) {
      if (count == 0) return;
      const double y = up(share(count, row));
      svg.rectangle({left, y}, {right - left, bottom_ - y}, look);
    };
    for (std::size_t i = 0; i < row.bins.counts.size(); ++i) {
      bar(edge(i), edge(i + 1), row.bins.counts[i], kFilled);
    }
    const double slot = left_ + kSlotGap;
    bar(slot, slot + kSlot, row.bins.inverted,
        fmt::format(R"(fill="{}" fill-opacity="0.45" stroke="none")", kInvertedColour));
    bar(to_ + kSlotGap, to_ + kSlotGap + kSlot, row.bins.beyond, kFilled);
  }

  void draw_outlined(Svg& svg, const Row& row) const {
    const auto outline = [&](double left, double right, std::size_t count, std::string_view look) {
      if (count == 0) return;
      const double y = up(share(count, row));
      svg.polyline(std::vector<Pixel>{{left, bottom_}, {left, y}, {right, y}, {right, bottom_}},
                   look);
    };
    std::vector<Pixel> steps;
    for (std::size_t i = 0; i < row.bins.counts.size(); ++i) {
      const double y = up(share(row.bins.counts[i], row));
      steps.emplace_back(edge(i), y);
      steps.emplace_back(edge(i + 1), y);
    }
    steps.insert(steps.begin(), Pixel(from_, bottom_));
    steps.emplace_back(to_, bottom_);
    svg.polyline(steps, kOutlined);
    const double slot = left_ + kSlotGap;
    outline(slot, slot + kSlot, row.bins.inverted,
            fmt::format(R"(fill="none" stroke="{}" stroke-width="2")", kInvertedColour));
    outline(to_ + kSlotGap, to_ + kSlotGap + kSlot, row.bins.beyond, kOutlined);
  }

  void draw_values(Svg& svg) const {
    svg.open(fmt::format("font-size=\"{}\" text-anchor=\"middle\"", kFont));
    for (const Tick& tick : x_.ticks()) {
      const double x = from_ + tick.place * (to_ - from_);
      svg.line({x, bottom_}, {x, bottom_ + 5.0}, R"(stroke="#222")");
      svg.text({x, bottom_ + 20.0}, tick.label, "", tick.raised);
    }
    if (has_inverted_) {
      svg.text({left_ + kSlotGap + kSlot / 2.0, bottom_ + 38.0}, "inverted",
               fmt::format("fill=\"{}\"", kInvertedColour));
    }
    if (has_beyond_) {
      svg.text({to_ + kSlotGap + kSlot / 2.0, bottom_ + 38.0}, "> " + svg_number(range_.high), "");
    }
    svg.close();
    svg.text({(from_ + to_) / 2.0, bottom_ + 44.0}, axis_title(options_.metric),
             R"(font-size="14" text-anchor="middle")");
  }

  // A line above the frame: which mesh, and where its worst cell and its mean are.
  void draw_marks(Svg& svg, const Row& row, std::size_t i) const {
    const double y = top_ - 6.0 - kRow * static_cast<double>(rows_.size() - i) + kRow / 2.0;
    const bool filled = i == 0;
    svg.rectangle({8.0, y - 6.0}, {16.0, 12.0}, filled ? kFilled : kOutlined);
    svg.text({31.0, y + 4.5}, row.name, fmt::format("font-size=\"{}\"", kFont));
    if (!row.any) return;
    svg.line({left_, y}, {right_, y}, R"(stroke="#ccc" stroke-width="1")");

    const double worst = mark_place(row.worst);
    const double mean = mark_place(row.mean);
    const std::string worst_text = "worst " + shown_value(options_.metric, row.worst);
    const std::string mean_text = "mean " + shown_value(options_.metric, row.mean);
    const std::string look = filled ? R"(fill="#8fa1b0" stroke="#56697a")"
                                    : R"(fill="#fff" stroke="#0b3c5d" stroke-width="1.6")";
    svg.polygon(
        std::vector<Pixel>{{worst, y + 5.5}, {worst - 5.0, y - 4.0}, {worst + 5.0, y - 4.0}}, look);
    svg.polygon(std::vector<Pixel>{{mean, y - 6}, {mean + 6, y}, {mean, y + 6}, {mean - 6, y}},
                look);
    place_texts(svg, y, {worst, worst_text}, {mean, mean_text});
  }

  struct Text {
    double x;  // of its marker
    std::string text;
  };

  // Each beside its marker, on the side away from the other marker if there is room.
  void place_texts(Svg& svg, double y, const Text& a, const Text& b) const {
    const Text& first = a.x <= b.x ? a : b;
    const Text& second = a.x <= b.x ? b : a;
    const double w1 = text_width(first.text, kFont);
    const double w2 = text_width(second.text, kFont);
    double x1 = first.x - kBeside - w1;  // left of its marker
    double x2 = second.x + kBeside;      // right of its marker
    const bool fits_left = x1 >= left_;
    const bool fits_right = x2 + w2 <= right_ + kRight - 4.0;
    const double between = second.x - first.x - 2.0 * kBeside;
    if (!fits_left && !fits_right && w1 + w2 + kApart <= between) {
      x1 = first.x + kBeside;
      x2 = second.x - kBeside - w2;
    } else if (!fits_left && w1 <= between) {
      x1 = first.x + kBeside;
    } else if (!fits_right && w2 <= between) {
      x2 = second.x - kBeside - w2;
    } else if (!fits_left) {  // both to the right, one after the other
      x1 = second.x + kBeside;
      x2 = x1 + w1 + kApart;
    } else if (!fits_right) {
      x2 = first.x - kBeside - w2;
      x1 = x2 - kApart - w1;
    }
    draw_text(svg, y, x1, w1, first);
    draw_text(svg, y, x2, w2, second);
  }

  // Against its marker, whatever its real width.
  static void draw_text(Svg& svg, double y, double x, double width, const Text& text) {
    svg.rectangle({x - 2.0, y - 7.0}, {width + 4.0, 14.0}, R"(fill="#fff")");
    const bool is_left = x < text.x;
    svg.text({is_left ? x + width : x, y + 4.5}, text.text,
             fmt::format("font-size=\"{}\" text-anchor=\"{}\"", kFont, is_left ? "end" : "start"));
  }

  const HistogramOptions& options_;
  MetricRange range_;
  Axis x_, y_;
  std::vector<Row> rows_;
  bool has_inverted_ = false;
  bool has_beyond_ = false;
  double highest_ = 0.0;  // share in percent
  double left_ = 0.0, right_ = 0.0, top_ = 0.0, bottom_ = 0.0;
  double from_ = 0.0, to_ = 0.0;  // where the range lies between left and right
};

}  // namespace

QualityBins count_bins(const CellQuality& quality, Metric metric, const MetricRange& range,
                       int bins) {
  assert(bins > 0 && range.low < range.high);
  QualityBins result;
  result.counts.resize(static_cast<std::size_t>(bins));
  const std::vector<double>& values = quality.of(metric);
  for (std::size_t c = 0; c < values.size(); ++c) {
    if (std::isnan(values[c])) continue;
    ++result.total;
    const double place = (values[c] - range.low) / (range.high - range.low);
    // A few bits above the end are rounding: an angle of 60 degrees may be that.
    if (quality.inverted[c] != 0) {
      ++result.inverted;
    } else if (place < -1e-9 || place > 1.0 + 1e-9) {
      ++result.beyond;
    } else {
      const auto bin = static_cast<std::size_t>(std::max(place, 0.0) * bins);
      ++result.counts[std::min(bin, result.counts.size() - 1)];
    }
  }
  return result;
}

std::string quality_histogram(const std::vector<HistogramMesh>& meshes,
                              const HistogramOptions& options) {
  assert(meshes.size() == 1 || meshes.size() == 2);
  return Histogram(meshes, options).draw();
}

}  // namespace evenmesh
