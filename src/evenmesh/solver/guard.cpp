// SPDX-License-Identifier: MIT
#include "evenmesh/solver/guard.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "evenmesh/mesh/measure.h"
#include "evenmesh/mesh/whole_cell.h"

namespace evenmesh {
namespace {

constexpr int kShape = static_cast<int>(Metric::shape);
// The parts of their move that vertices are left with, one after the other.
constexpr double kLeft[] = {1.0, 0.5, 0.25, 0.0};
constexpr int kAllTheWay = 3;
// The same values added up in another order, as after renumbering, differ by about this much.
constexpr double kSumRounding = 1e-14;

// The same sum as in QualitySummary, to the bit: what is judged is what reports show.
double mean_shape(Workers& workers, const CellQuality& quality) {
  const std::vector<double>& values = quality.values[kShape];
  const double sum = sum_over_ranges(workers, values.size(), [&](std::size_t i, std::size_t last) {
    double part = 0.0;
    for (; i < last; ++i) part += values[i];
    return part;
  });
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

}  // namespace

Guard::Guard(Workers& workers, const Mesh& input, const Orientation& orientation)
    : input_(input),
      orientation_(orientation),
      quality_(measure_cells(workers, input, input.points(), orientation)),
      summary_(summarize(workers, quality_)) {}

double Guard::least_corner_of(std::size_t cell, Points points) const {
  const auto vertices = input_.cells().vertices(cell);
  return least_corner(
      input_.cells().kind(cell), static_cast<int>(vertices.size()),
      [&](int i) -> const Vec3& { return points[vertices[i]]; }, orientation_.up(cell),
      orientation_.sign(cell));
}

double Guard::least_determinant_of(std::size_t cell, Points points) const {
  const auto vertices = input_.cells().vertices(cell);
  std::array<Vec3, 8> corners;
  std::transform(vertices.begin(), vertices.end(), corners.begin(),
                 [&](Index v) { return points[v]; });
  return least_determinant(input_.cells().kind(cell), {corners.data(), vertices.size()},
                           orientation_.sign(cell));
}

// Of a cell that is inverted before and after.
bool Guard::is_further_over(std::size_t cell, Points points) const {
  const double before = least_corner_of(cell, input_.points());
  const double after = least_corner_of(cell, points);
  const CellKind kind = input_.cells().kind(cell);
  const bool is_between_corners =
      before > 0.0 && after > 0.0 && (kind == CellKind::hex || kind == CellKind::wedge);
  if (!is_between_corners) return after < before;
  return least_determinant_of(cell, points) < least_determinant_of(cell, input_.points());
}

bool Guard::offends(const CellQuality& quality, std::size_t cell, Points points,
                    Judge judge) const {
  if (judge == Judge::nothing) return false;
  if (quality.inverted[cell]) {
    if (!quality_.inverted[cell]) return true;
    if (is_further_over(cell, points)) return true;
  }
  // Cells that are not inverted any more outweigh what the worst value of a tangled mesh is worth.
  if (judge == Judge::inversion || summary_.inverted > 0) return false;
  for (const Metric metric : kMetrics) {
    const double value = quality.of(metric)[cell];
    if (applies(metric, input_.cells().kind(cell)) &&
        worse(metric, value, summary_.of(metric).worst)) {
      return true;
    }
  }
  return false;
}

// Cells that were perfect beside cells that were turned over make room for these.
bool Guard::mean_counts(const CellQuality& quality) const {
  const bool any_inverted = std::any_of(quality.inverted.begin(), quality.inverted.end(),
                                        [](char flag) { return flag != 0; });
  return any_inverted || summary_.inverted == 0;
}

double Guard::mean_shape_at(Workers& workers, Points points) const {
  const Cells& cells = input_.cells();
  const double sum =
      sum_over_ranges(workers, cells.size(), [&](std::size_t first, std::size_t last) {
        std::vector<Vec3> corners;
        double part = 0.0;
        for (std::size_t cell = first; cell < last; ++cell) {
          corners.clear();
          for (const Index v : cells.vertices(cell)) corners.push_back(points[v]);
          part += measure(Metric::shape, cells.kind(cell), corners, orientation_.up(cell),
                          orientation_.sign(cell));
        }
        return part;
      });
  return cells.empty() ? 0.0 : sum / static_cast<double>(cells.size());
}

std::string Guard::find_breach(Workers& workers, Points points, Judge judge) const {
  const CellQuality quality = measure_cells(workers, input_, points, orientation_);
  for (std::size_t cell = 0; cell < input_.cells().size(); ++cell) {
    if (!offends(quality, cell, points, judge)) continue;
    return quality.inverted[cell]
               ? fmt::format("cell {} would be inverted or more so than before", cell)
               : fmt::format("cell {} would be worse than the worst was before", cell);
  }
  if (limit_ != nullptr && judge != Judge::nothing) {
    const double found = limit_->measure(workers, points);
    if (found > limit_->limit()) {
      return fmt::format("the shape would be {:.3g} away from the input's", found);
    }
  }
  if (judge == Judge::quality_and_inversion && mean_counts(quality) &&
      mean_shape(workers, quality) < (1.0 - kSumRounding) * summary_.metrics[kShape].mean) {
    return "the mean of shape would be lower than before";
  }
  return {};
}

// Positions on their way back to the input, and the quality that goes with them.
class Guard::Retreat {
 public:
  Retreat(Workers& workers, const Guard& guard, std::vector<Vec3>& points, Judge judge,
          const Rounding& rounding, const Spoilt& spoilt)
      : workers_(workers),
        guard_(guard),
        points_(points),
        judge_(judge),
        rounding_(rounding),
        spoilt_(spoilt),
        target_(points),
        stage_(points.size(), 0),
        marked_(points.size(), 0) {
    round(points_);
    quality_ = measure_cells(workers_, guard_.input_, points_, guard_.orientation_);
    inverted_unguarded_ =
        static_cast<std::size_t>(std::count_if(quality_.inverted.begin(), quality_.inverted.end(),
                                               [](auto inverted) { return inverted != 0; }));
  }

  void run() {
    while (true) {
      while (mark_offenders()) retreat();
      if (mark_deviating()) {
        retreat();
        continue;
      }
      if (judge_ == Judge::inversion || !guard_.mean_counts(quality_)) return;
      if (mean_shape(workers_, quality_) >= guard_.summary_.metrics[kShape].mean) return;
      mean_fell_ = true;
      if (!mark_where_shape_fell()) return;
      retreat();
    }
  }

  void measure_deviation() {
    if (guard_.limit_ != nullptr) deviation_ = guard_.limit_->measure(workers_, points_);
  }

  std::size_t pulled_back() const {
    return static_cast<std::size_t>(
        std::count_if(stage_.begin(), stage_.end(), [](int stage) { return stage > 0; }));
  }
  std::size_t inverted_unguarded() const { return inverted_unguarded_; }
  bool mean_fell() const { return mean_fell_; }
  double deviation() const { return deviation_; }
  QualitySummary summary() const { return summarize(workers_, quality_); }

 private:
  const Cells& cells() const { return guard_.input_.cells(); }
  bool may_go_back(Index v) const {
    return stage_[v] < kAllTheWay && points_[v] != guard_.input_.points()[v];
  }

  void round(std::vector<Vec3>& points) const {
    if (rounding_) points = rounding_(points);
  }

  bool mark_offenders() {
    bool any = false;
    for (std::size_t cell = 0; cell < cells().size(); ++cell) {
      if (!guard_.offends(quality_, cell, points_, judge_)) continue;
      for (const Index v : cells().vertices(cell)) {
        if (!may_go_back(v)) continue;
        marked_[v] = 1;
        any = true;
      }
    }
    if (!spoilt_) return any;
    for (const Index v : spoilt_(points_)) {
      if (!may_go_back(v)) continue;
      marked_[v] = 1;
      any = true;
    }
    return any;
  }

  bool mark_deviating() {
    if (guard_.limit_ == nullptr) return false;
    deviation_ = guard_.limit_->mark(workers_, points_, marked_);
    bool any = false;
    for (std::size_t v = 0; v < marked_.size(); ++v) {
      if (marked_[v] && !may_go_back(static_cast<Index>(v))) marked_[v] = 0;
      any = any || marked_[v];
    }
    return any;
  }

  // Marks vertices whose incident cells together have less shape than in the input: the worst half
  // of them, or if the loss lies only between them, the vertices of cells that lost.
  bool mark_where_shape_fell() {
    std::vector<double> change(points_.size(), 0.0);
    for (std::size_t cell = 0; cell < cells().size(); ++cell) {
      const double gain = quality_.values[kShape][cell] - guard_.quality_.values[kShape][cell];
      for (const Index v : cells().vertices(cell)) change[v] += gain;
    }
    std::vector<double> losses;
    for (std::size_t v = 0; v < change.size(); ++v) {
      if (change[v] < 0.0 && may_go_back(static_cast<Index>(v))) losses.push_back(change[v]);
    }
    if (!losses.empty()) {
      const auto middle = losses.begin() + static_cast<std::ptrdiff_t>(losses.size() / 2);
      std::nth_element(losses.begin(), middle, losses.end());
      for (std::size_t v = 0; v < change.size(); ++v) {
        if (change[v] <= *middle && may_go_back(static_cast<Index>(v))) marked_[v] = 1;
      }
      return true;
    }
    bool any = false;
    for (std::size_t cell = 0; cell < cells().size(); ++cell) {
      if (quality_.values[kShape][cell] >= guard_.quality_.values[kShape][cell]) continue;
      for (const Index v : cells().vertices(cell)) {
        if (!may_go_back(v)) continue;
        marked_[v] = 1;
        any = true;
      }
    }
    return any;
  }

  // Those that are tied go back together; they are at the same stage.
  void mark_tied() {
    if (guard_.motion_ == nullptr || !guard_.motion_->has_ties()) return;
    for (Index v = 0; v < points_.size(); ++v) {
      if (marked_[v]) guard_.motion_->for_tied(v, [&](Index other) { marked_[other] = 1; });
    }
  }

  // Half of a way along a curve is beside the curve.
  void put_on_track(Index v) {
    const Track* track = guard_.motion_ != nullptr ? guard_.motion_->track(v) : nullptr;
    if (track == nullptr) return;
    const TrackPoint& start = guard_.motion_->start()[guard_.motion_->slot(v)];
    points_[v] = track->nearest(points_[v], start).position;
  }

  // Takes the marked vertices one stage further back and measures again what that changes.
  void retreat() {
    mark_tied();
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (!marked_[v]) continue;
      const double left = kLeft[++stage_[v]];
      const Vec3& start = guard_.input_.points()[v];
      points_[v] = left == 0.0 ? start : Vec3(start + left * (target_[v] - start));
      if (left > 0.0) put_on_track(static_cast<Index>(v));
    }
    round(points_);
    Cells changed;
    std::vector<std::size_t> numbers;
    Orientation orientation;
    orientation.type = guard_.orientation_.type;
    orientation.normal = guard_.orientation_.normal;
    for (std::size_t cell = 0; cell < cells().size(); ++cell) {
      const auto vertices = cells().vertices(cell);
      if (std::none_of(vertices.begin(), vertices.end(), [&](Index v) { return marked_[v]; })) {
        continue;
      }
      changed.add(cells().kind(cell), vertices);
      numbers.push_back(cell);
      if (!guard_.orientation_.signs.empty()) {
        orientation.signs.push_back(guard_.orientation_.signs[cell]);
      }
      if (!guard_.orientation_.normals.empty()) {
        orientation.normals.push_back(guard_.orientation_.normals[cell]);
      }
    }
    const Mesh part(points_, std::move(changed));
    const CellQuality quality = measure_cells(workers_, part, points_, orientation);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      for (int m = 0; m < kMetricCount; ++m) quality_.values[m][numbers[i]] = quality.values[m][i];
      quality_.inverted[numbers[i]] = quality.inverted[i];
    }
    std::fill(marked_.begin(), marked_.end(), 0);
  }

  Workers& workers_;
  const Guard& guard_;
  std::vector<Vec3>& points_;
  Judge judge_;
  const Rounding& rounding_;
  const Spoilt& spoilt_;
  const std::vector<Vec3> target_;   // where the solver wants the vertices
  std::vector<std::uint8_t> stage_;  // per vertex: how far back it went, index into kLeft
  std::vector<char> marked_;         // per vertex: to go back one more stage
  CellQuality quality_;
  std::size_t inverted_unguarded_ = 0;
  bool mean_fell_ = false;
  double deviation_ = 0.0;
};

Guard::Result Guard::enforce(Workers& workers, std::vector<Vec3>& points, Judge judge,
                             const Rounding& rounding, const Spoilt& spoilt) const {
  Retreat retreat(workers, *this, points, judge, rounding, spoilt);
  if (judge == Judge::nothing) {
    retreat.measure_deviation();
  } else {
    retreat.run();
  }
  Result result;
  result.mean_fell = retreat.mean_fell();
  result.pulled_back = retreat.pulled_back();
  result.inverted_unguarded = retreat.inverted_unguarded();
  result.deviation = retreat.deviation();
  result.after = retreat.summary();
  const bool moved = !std::equal(points.begin(), points.end(), input_.points().begin());
  if (judge != Judge::quality_and_inversion) {
    result.promise = Promise::lifted;
  } else if (result.pulled_back > 0) {
    result.promise = moved ? Promise::pulled_back : Promise::unimproved;
  }
  return result;
}

}  // namespace evenmesh
