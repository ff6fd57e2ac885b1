// SPDX-License-Identifier: MIT
#include "evenmesh/plot/convergence.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include <fmt/format.h>

#include "evenmesh/plot/axis.h"
#include "evenmesh/plot/palette.h"
#include "evenmesh/plot/svg.h"

namespace evenmesh {
namespace {

constexpr double kLeft = 84.0;
constexpr double kRight = 22.0;
constexpr double kBottom = 54.0;
constexpr double kTitle = 30.0;
constexpr double kRow = 20.0;      // of the legend
constexpr double kMarkRow = 17.0;  // of labels of marks
constexpr double kStrip = 86.0;    // the frame of counts
constexpr double kGap = 16.0;      // between the frames
constexpr double kInset = 9.0;     // markers stay off the frame
constexpr double kSample = 34.0;   // of a line in the legend
constexpr double kFont = 13.0;
constexpr std::size_t kAllMarkers = 30;  // of more iterations only some are marked
constexpr std::size_t kSomeMarkers = 15;
constexpr std::size_t kMostRestarts = 40;
constexpr std::size_t kLongestName = 64;

struct Box {
  double left, top, width, height;

  double bottom() const { return top + height; }
  double right() const { return left + width; }
};

struct Bounds {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;

  bool empty() const { return !(low <= high); }
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

bool has_place(double value, Scale scale) {
  return std::isfinite(value) && (scale == Scale::linear || value > 0.0);
}

Bounds values_of(std::span<const Curve> curves, Scale scale) {
  Bounds bounds;
  for (const Curve& curve : curves) {
    for (const double y : curve.y) {
      if (has_place(y, scale)) bounds.add(y);
    }
  }
  return bounds;
}

void add_iterations(std::span<const Curve> curves, Bounds& bounds) {
  for (const Curve& curve : curves) {
    if (curve.y.empty()) continue;
    bounds.add(curve.first);
    bounds.add(curve.first + static_cast<double>(curve.y.size()) - 1.0);
  }
}

void draw_marker(Svg& svg, const Pixel& p, std::size_t style) {
  const std::string look = fmt::format("fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.6\"",
                                       kLineStyles[style % kLineStyles.size()].colour);
  const auto outline = [&](std::initializer_list<Pixel> offsets) {
    std::vector<Pixel> places;
    for (const Pixel& offset : offsets) places.push_back(p + offset);
    svg.polygon(places, look);
  };
  switch (style % 7) {
    case 0:
      return svg.circle(p, 3.6, look);
    case 1:
      return svg.rectangle(p - Pixel(3.3, 3.3), Pixel(6.6, 6.6), look);
    case 2:
      return outline({{0, -4.4}, {4.2, 3.2}, {-4.2, 3.2}});
    case 3:
      return outline({{0, -4.8}, {4.8, 0}, {0, 4.8}, {-4.8, 0}});
    case 4:
      return outline({{0, 4.4}, {4.2, -3.2}, {-4.2, -3.2}});
    case 5:
      return outline({{-3, -4.4}, {3, -4.4}, {0, 0}, {3, 4.4}, {-3, 4.4}, {0, 0}});  // hourglass
    default:
      return outline({{0, -4.6}, {4.4, -1.4}, {2.7, 3.8}, {-2.7, 3.8}, {-4.4, -1.4}});
  }
}

std::string line_look(std::size_t style) {
  const auto [colour, dashes] = kLineStyles[style % kLineStyles.size()];
  return fmt::format(R"(fill="none" stroke="{}" stroke-width="1.8" stroke-linejoin="round"{})",
                     colour,
                     *dashes == '\0' ? "" : fmt::format(" stroke-dasharray=\"{}\"", dashes));
}

// One frame with its vertical axis and the curves in it.
class Frame {
 public:
  Frame(Svg& svg, const Box& box, const Axis& x, const Axis& y)
      : svg_(svg), box_(box), x_(x), y_(y) {}

  double across(double iteration) const {
    return box_.left + inset(x_.place(iteration), box_.width);
  }
  double down(double place) const { return box_.bottom() - inset(place, box_.height); }

  void draw_grid(const std::string& title) const {
    svg_.open(R"(stroke="#e4e4e4")");
    for (const Tick& tick : y_.ticks()) {
      if (!tick.label.empty()) {
        svg_.line({box_.left, down(tick.place)}, {box_.right(), down(tick.place)}, "");
      }
    }
    for (const Tick& tick : x_.ticks()) {
      const double x = box_.left + inset(tick.place, box_.width);
      svg_.line({x, box_.top}, {x, box_.bottom()}, "");
    }
    svg_.close();
    svg_.open(fmt::format("font-size=\"{}\" text-anchor=\"end\"", kFont));
    for (const Tick& tick : y_.ticks()) {
      const double y = down(tick.place);
      const double length = tick.label.empty() ? 3.0 : 6.0;
      svg_.line({box_.left, y}, {box_.left + length, y}, R"(stroke="#222")");
      if (tick.label.empty()) continue;
      svg_.text({box_.left - 8.0, y + 4.5}, tick.label, "", tick.raised);
    }
    svg_.close();
    const Pixel middle(18.0, box_.top + box_.height / 2.0);
    svg_.text(
        middle, shortened(title, static_cast<std::size_t>(box_.height / 6.0)),
        fmt::format(R"--(font-size="14" text-anchor="middle" transform="rotate(-90 {} {})")--",
                    svg_number(middle.x()), svg_number(middle.y())));
  }

  void draw_border() const {
    svg_.rectangle({box_.left, box_.top}, {box_.width, box_.height},
                   R"(fill="none" stroke="#222" stroke-width="1.2")");
  }

  void draw_line_at(double iteration, const std::string& look) const {
    svg_.line({across(iteration), box_.top}, {across(iteration), box_.bottom()}, look);
  }

  void draw_curve(const Curve& curve, std::size_t style, Scale scale,
                  std::span<const double> restarts) const {
    std::vector<Pixel> piece;
    std::vector<Pixel> marked;
    const std::size_t n = curve.y.size();
    const std::size_t stride = n <= kAllMarkers ? 1 : (n + kSomeMarkers - 1) / kSomeMarkers;
    const auto end_piece = [&] {
      if (piece.size() > 1) svg_.polyline(piece, line_look(style));
      // Without a line to be part of, a point must be marked to be seen.
      if (piece.size() == 1) marked.push_back(piece.front());
      piece.clear();
    };
    for (std::size_t i = 0; i < n; ++i) {
      const double iteration = curve.first + static_cast<double>(i);
      if (std::find(restarts.begin(), restarts.end(), iteration) != restarts.end()) end_piece();
      if (!has_place(curve.y[i], scale)) {
        end_piece();
        continue;
      }
      const Pixel p(across(iteration), down(y_.place(curve.y[i])));
      piece.push_back(p);
      // Curves on top of each other show their markers in turn.
      if ((i + style * stride / 3) % stride == 0) marked.push_back(p);
    }
    end_piece();
    for (const Pixel& p : marked) draw_marker(svg_, p, style);
  }

  void say(const std::string& what) const {
    svg_.text({box_.left + box_.width / 2.0, box_.top + box_.height / 2.0}, what,
              R"(font-size="14" text-anchor="middle" fill="#666")");
  }

 private:
  static double inset(double place, double length) {
    return kInset + place * (length - 2.0 * kInset);
  }

  Svg& svg_;
  Box box_;
  const Axis& x_;
  const Axis& y_;
};

// ---- what stands above the frame ----------------------------------------------------------------

struct Placed {
  double x;
  int row;
};

// Names from left to right, as many in a row as fit.
std::vector<Placed> place_in_rows(std::span<const std::string> names, double width) {
  std::vector<Placed> result;
  double x = 0.0;
  int row = 0;
  for (const std::string& name : names) {
    const double needed = kSample + 8.0 + text_width(name, kFont);
    if (x > 0.0 && x + needed > width) {
      x = 0.0;
      ++row;
    }
    result.push_back({x, row});
    x += needed + 22.0;
  }
  return result;
}

struct MarkLabel {
  double x;  // of the line
  std::string text;
  double left = 0.0;  // of the text
  int row = 0;        // counted upwards from the frame
};

// From right to left: a line that goes up to its label has only labels of lines to its right
// beside it.
std::vector<MarkLabel> place_labels(std::vector<MarkLabel> labels, double right) {
  std::stable_sort(labels.begin(), labels.end(),
                   [](const MarkLabel& a, const MarkLabel& b) { return a.x > b.x; });
  for (std::size_t i = 0; i < labels.size(); ++i) {
    MarkLabel& label = labels[i];
    const double width = text_width(label.text, kFont);
    label.left = std::max(4.0, std::min(label.x + 5.0, right - width));
    const auto is_taken = [&](const MarkLabel& other) {
      return other.row == label.row &&
             label.left < other.left + text_width(other.text, kFont) + 8 &&
             other.left < label.left + width + 8;
    };
    const auto placed = labels.begin() + static_cast<std::ptrdiff_t>(i);
    while (std::any_of(labels.begin(), placed, is_taken)) ++label.row;
  }
  return labels;
}

class Plot {
 public:
  Plot(std::span<const Curve> curves, const ConvergenceOptions& options)
      : curves_(curves),
        options_(options),
        x_(iteration_axis()),
        y_(value_axis()),
        counts_(Axis::from_zero(std::max(1.0, values_of(options.counts, Scale::linear).high), 3,
                                true)) {
    for (const Curve& curve : curves) names_.push_back(shortened(curve.name, kLongestName));
    for (const Curve& curve : options.counts) names_.push_back(shortened(curve.name, kLongestName));
    if (shows_restarts()) names_.push_back(shortened(options.restarts_title, kLongestName));
    legend_ = place_in_rows(names_, options.width - kLeft - kRight);
    const double head = options.title.empty() ? 12.0 : kTitle + 8.0;
    legend_top_ = head;
    const double legend = legend_.empty() ? 0.0 : kRow * (1.0 + legend_.back().row) + 4.0;
    frame_ = {kLeft, head + legend, std::max(options.width - kLeft - kRight, 100.0), 0.0};
    place_marks();
    frame_.height = std::max(options.height - frame_.top - kBottom, 120.0);
  }

  std::string draw() const {
    const Box strip{frame_.left, frame_.bottom() + kGap, frame_.width, kStrip};
    const double bottom = options_.counts.empty() ? frame_.bottom() : strip.bottom();
    Svg svg(frame_.right() + kRight, bottom + kBottom);
    draw_head(svg);
    draw_frame(Frame(svg, frame_, x_, y_), options_.y_title, curves_, 0, options_.scale);
    if (!options_.counts.empty()) {
      draw_frame(Frame(svg, strip, x_, counts_), options_.counts_title, options_.counts,
                 curves_.size(), Scale::linear);
    }
    draw_labels(svg);
    draw_iterations(svg, bottom);
    return std::move(svg).finish();
  }

 private:
  Axis iteration_axis() const {
    Bounds bounds;
    add_iterations(curves_, bounds);
    add_iterations(options_.counts, bounds);
    for (const Mark& mark : options_.marks) {
      if (std::isfinite(mark.iteration)) bounds.add(mark.iteration);
    }
    if (bounds.empty()) bounds.add(0.0);
    if (bounds.low == bounds.high)
      return Axis::linear(bounds.low - 0.5, bounds.high + 0.5, 3, true);
    return Axis::linear(bounds.low, bounds.high, 9, true);
  }

  Axis value_axis() const {
    const Bounds bounds = values_of(curves_, options_.scale);
    if (bounds.empty()) return Axis::without_ticks();
    if (options_.scale == Scale::logarithmic) return Axis::logarithmic(bounds.low, bounds.high);
    if (bounds.low >= 0.0) return Axis::from_zero(bounds.high, 6);
    return Axis::linear(bounds.low, bounds.high, 6);
  }

  bool shows_restarts() const {
    return !options_.restarts.empty() && options_.restarts.size() <= kMostRestarts;
  }

  // Labels above the frame push it down.
  void place_marks() {
    const Box box = frame_;
    std::vector<MarkLabel> labels;
    for (const Mark& mark : options_.marks) {
      if (!std::isfinite(mark.iteration) || mark.label.empty()) continue;
      const double x = box.left + kInset + x_.place(mark.iteration) * (box.width - 2.0 * kInset);
      labels.push_back({x, shortened(mark.label, kLongestName)});
    }
    labels_ = place_labels(std::move(labels), box.right() + kRight - 4.0);
    int rows = 0;
    for (const MarkLabel& label : labels_) rows = std::max(rows, label.row + 1);
    frame_.top += kMarkRow * rows + (rows > 0 ? 4.0 : 0.0);
  }

  void draw_head(Svg& svg) const {
    if (!options_.title.empty()) {
      svg.text({frame_.left + frame_.width / 2.0, 24.0}, shortened(options_.title, 80),
               R"(font-size="16" font-weight="bold" text-anchor="middle")");
    }
    for (std::size_t i = 0; i < legend_.size(); ++i) {
      const Pixel p(frame_.left + legend_[i].x, legend_top_ + kRow * legend_[i].row + 8.0);
      const Pixel end = p + Pixel(kSample, 0.0);
      if (i < curves_.size() + options_.counts.size()) {
        svg.line(p, end, line_look(i));
        draw_marker(svg, (p + end) / 2.0, i);
      } else {
        const Pixel middle = (p + end) / 2.0;
        svg.line(middle - Pixel(0.0, 8.0), middle + Pixel(0.0, 8.0), kRestartLook);
      }
      svg.text(end + Pixel(7.0, 4.5), names_[i], fmt::format("font-size=\"{}\"", kFont));
    }
  }

  void draw_frame(const Frame& frame, const std::string& title, std::span<const Curve> curves,
                  std::size_t style, Scale scale) const {
    frame.draw_grid(title);
    if (shows_restarts()) {
      for (const double at : options_.restarts) frame.draw_line_at(at - 0.5, kRestartLook);
    }
    for (const Mark& mark : options_.marks) {
      if (std::isfinite(mark.iteration)) frame.draw_line_at(mark.iteration, kMarkLook);
    }
    if (values_of(curves, scale).empty()) frame.say(why_empty(curves));
    frame.draw_border();
    for (std::size_t i = 0; i < curves.size(); ++i) {
      frame.draw_curve(curves[i], style + i, scale, options_.restarts);
    }
  }

  static std::string why_empty(std::span<const Curve> curves) {
    const bool any = std::any_of(curves.begin(), curves.end(),
                                 [](const Curve& curve) { return !curve.y.empty(); });
    return any ? "no values above zero" : "no iterations";
  }

  void draw_labels(Svg& svg) const {
    for (const MarkLabel& label : labels_) {
      const double base = frame_.top - 6.0 - kMarkRow * label.row;
      if (label.left > label.x) svg.line({label.x, base - 11.0}, {label.x, frame_.top}, kMarkLook);
      svg.text({label.left, base}, label.text, fmt::format("font-size=\"{}\"", kFont));
    }
  }

  void draw_iterations(Svg& svg, double bottom) const {
    svg.open(fmt::format("font-size=\"{}\" text-anchor=\"middle\"", kFont));
    for (const Tick& tick : x_.ticks()) {
      const double x = frame_.left + kInset + tick.place * (frame_.width - 2.0 * kInset);
      svg.line({x, bottom}, {x, bottom - 6.0}, R"(stroke="#222")");
      svg.text({x, bottom + 18.0}, tick.label, "", tick.raised);
    }
    svg.close();
    svg.text({frame_.left + frame_.width / 2.0, bottom + 41.0}, shortened(options_.x_title, 60),
             R"(font-size="14" text-anchor="middle")");
  }

  static constexpr const char* kRestartLook = R"(stroke="#999" stroke-width="1")";
  static constexpr const char* kMarkLook =
      R"(stroke="#444" stroke-width="1.4" stroke-dasharray="5 3")";

  std::span<const Curve> curves_;
  const ConvergenceOptions& options_;
  Axis x_, y_, counts_;
  std::vector<std::string> names_;
  std::vector<Placed> legend_;
  std::vector<MarkLabel> labels_;
  double legend_top_ = 0.0;
  Box frame_{};
};

// ---- the standard plot of a run ----

// What there is left to lose in each stage, as part of what there was at its start.
Curve remaining_cost(const std::vector<Iteration>& history) {
  Curve curve{"cost above its least", {}, 0};
  for (std::size_t first = 0; first < history.size();) {
    std::size_t last = first;
    double least = history[first].cost;
    for (; last < history.size() && history[last].function == history[first].function; ++last) {
      least = std::min(least, history[last].cost);
    }
    const double whole = history[first].cost - least;
    for (std::size_t i = first; i < last; ++i) {
      curve.y.push_back(whole > 0.0 ? (history[i].cost - least) / whole : 0.0);
    }
    first = last;
  }
  return curve;
}

}  // namespace

std::string convergence_plot(std::span<const Curve> curves, const ConvergenceOptions& options) {
  return Plot(curves, options).draw();
}

Curve above_least(std::string name, std::span<const double> values) {
  Curve curve{std::move(name), {values.begin(), values.end()}, 0};
  const double least = values_of({&curve, 1}, Scale::linear).low;
  for (double& y : curve.y) y -= least;
  return curve;
}

std::string convergence_plot(const Report& report, ConvergenceOptions options) {
  Curve gradient{"gradient", {}, 0};
  Curve inverted{"inverted cells", {}, 0};
  options.restarts.clear();
  for (std::size_t i = 0; i < report.history.size(); ++i) {
    const Iteration& iteration = report.history[i];
    gradient.y.push_back(iteration.gradient);
    inverted.y.push_back(static_cast<double>(iteration.inverted));
    if (i > 0 && iteration.function != report.history[i - 1].function) {
      options.restarts.push_back(static_cast<double>(i));
    }
  }
  const std::vector<Curve> curves = {std::move(gradient), remaining_cost(report.history)};
  options.scale = Scale::logarithmic;
  options.y_title = "relative to the start";
  options.restarts_title = "new penalty or multipliers";
  options.counts.clear();
  const bool ever_inverted =
      std::any_of(inverted.y.begin(), inverted.y.end(), [](double count) { return count > 0.0; });
  if (ever_inverted) options.counts.push_back(std::move(inverted));
  options.counts_title = "cells";
  return convergence_plot(std::span<const Curve>(curves), options);
}

}  // namespace evenmesh
