// SPDX-License-Identifier: MIT
#include "evenmesh/report/packed_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "evenmesh/mesh/ordering.h"
#include "evenmesh/plot/svg.h"
#include "evenmesh/report/importance.h"

namespace evenmesh {
namespace {

using Numbers = std::vector<std::int64_t>;

constexpr Index kNotShown = ~Index{0};
constexpr Fineness kFine = {};
constexpr Fineness kCoarse = {.steps_per_edge = 8.0, .steps_per_box = 4096.0};
constexpr int kUndefined = 255;
constexpr std::uint64_t kGreatestNumber = std::numeric_limits<std::int32_t>::max();

// Of triangle, quad, polygon, tet, hex, wedge, pyramid.
constexpr std::array<int, kCellKinds> kCodeOfKind = {0, 1, 6, 2, 5, 4, 3};

int byte_of(const CellQuality& quality, const PackedMetric& metric, std::size_t cell) {
  const double value = quality.of(metric.metric)[cell];
  const bool is_shape = metric.metric == Metric::shape;
  if (std::isnan(value) || (is_shape && (quality.inverted[cell] != 0 || !(value > 0.0)))) {
    return kUndefined;
  }
  const double part = (value - metric.range.low) / (metric.range.high - metric.range.low);
  return static_cast<int>(std::lround(254.0 * std::clamp(part, 0.0, 1.0)));
}

// The arrays of some cells of a mesh.
class Packer {
 public:
  Packer(const ShownMesh& shown, std::vector<std::uint32_t> cells, const Fineness& fineness)
      : shown_(shown) {
    result_.cells = std::move(cells);
    result_.is_flat =
        shown.orientation.type == MeshType::planar && std::abs(shown.orientation.normal.z()) == 1.0;
    number_vertices();
    std::vector<Points> states{shown.before.points()};
    if (shown.has_after()) states.push_back(shown.after);
    for (const StoredIterate& iterate : shown.iterates) states.emplace_back(iterate.points);
    result_.grid = choose_grid(shown.before.cells(), states, vertices_, fineness);
  }

  // All but metrics and iterates.
  void pack_mesh() {
    pack_positions();
    pack_cells();
    pack_number("cell_id", result_.cells, shown_.cell_number);
    pack_number("vertex_id", vertices_, shown_.vertex_number);
    pack_marks();
    pack_feature_edges();
  }

  std::size_t bytes() const { return result_.bytes(); }

  // False if it does not fit: then it is not there.
  bool add_metric(const PackedMetric& metric, std::size_t budget) {
    const std::string word(name(metric.metric));
    std::vector<NamedArray> arrays{{"before_" + word, bytes_of(shown_.quality_before, metric)}};
    if (shown_.has_after()) {
      arrays.push_back({"after_" + word, bytes_of(*shown_.quality_after, metric)});
    }
    if (!add(std::move(arrays), budget)) return false;
    result_.metrics.push_back(metric);
    return true;
  }

  void drop_vertex_numbers() {
    if (std::erase_if(result_.arrays, [](const NamedArray& a) { return a.name == "vertex_id"; })) {
      result_.notes.emplace_back("Vertices have no numbers here: they would not fit.");
    }
  }

  bool add_iterates(std::size_t budget) {
    std::vector<NamedArray> arrays;
    for (std::size_t k = 0; k < shown_.iterates.size(); ++k) {
      arrays.push_back(
          {fmt::format("iterate_{}", k), pack_signed(moves_to(shown_.iterates[k].points), 3)});
    }
    if (!add(std::move(arrays), budget)) return false;
    for (const StoredIterate& iterate : shown_.iterates) {
      result_.iterates.push_back(iterate.iteration);
    }
    return true;
  }

  PackedMesh take() && {
    result_.vertices = vertices_.size();
    return std::move(result_);
  }

 private:
  // In the order in which cells name them first.
  void number_vertices() {
    number_of_.assign(shown_.before.point_count(), kNotShown);
    for (const std::uint32_t c : result_.cells) {
      for (const Index v : shown_.before.cells().vertices(c)) {
        if (number_of_[v] != kNotShown) continue;
        number_of_[v] = static_cast<Index>(vertices_.size());
        vertices_.push_back(v);
      }
    }
  }

  bool add(std::vector<NamedArray> arrays, std::size_t budget) {
    std::size_t more = 0;
    for (const NamedArray& one : arrays) more += one.array.bytes.size();
    if (bytes() + more > budget) return false;
    for (NamedArray& one : arrays) result_.arrays.push_back(std::move(one));
    return true;
  }

  void add(std::string name, PackedArray array) {
    result_.arrays.push_back({std::move(name), std::move(array)});
  }

  std::array<std::int64_t, 3> place(const Vec3& position) const {
    auto result = result_.grid.place(position);
    if (result_.is_flat) result[2] = 0;
    return result;
  }

  Numbers moves_to(Points points) const {
    Numbers moves;
    moves.reserve(3 * vertices_.size());
    for (const Index v : vertices_) {
      const auto from = place(shown_.before.points()[v]);
      const auto to = place(points[v]);
      for (std::size_t axis = 0; axis < 3; ++axis) moves.push_back(to[axis] - from[axis]);
    }
    return moves;
  }

  void pack_positions() {
    Numbers points;
    points.reserve(3 * vertices_.size());
    for (const Index v : vertices_) {
      for (const std::int64_t x : place(shown_.before.points()[v])) points.push_back(x);
    }
    add("points", pack(points, 3, Rule::delta));
    if (shown_.has_after()) add("moves", pack_signed(moves_to(shown_.after), 3));
  }

  void pack_cells() {
    const Cells& cells = shown_.before.cells();
    Numbers kinds;
    Numbers vertices;
    Numbers sizes;
    for (const std::uint32_t c : result_.cells) {
      kinds.push_back(kCodeOfKind[static_cast<std::size_t>(cells.kind(c))]);
      const auto corners = cells.vertices(c);
      for (const Index v : corners) vertices.push_back(number_of_[v]);
      if (cells.kind(c) == CellKind::polygon) {
        sizes.push_back(static_cast<std::int64_t>(corners.size()));
      }
    }
    add("cell_kind", pack(kinds, 1, Rule::as_is));
    add("cell_vertices", pack(vertices, 1, Rule::highwater));
    if (!sizes.empty()) add("polygon_size", pack(sizes, 1, Rule::as_is));
    if (!cells.has_groups()) return;
    Numbers groups;
    for (const std::uint32_t c : result_.cells) groups.push_back(cells.group(c));
    add("cell_group", pack(groups, 1, Rule::as_is));
  }

  template <typename Item, typename NumberOf>
  void pack_number(const std::string& name, const std::vector<Item>& items,
                   const NumberOf& number_of) {
    if (!number_of) return;
    Numbers numbers;
    for (const Item item : items) {
      const std::uint64_t number = number_of(item);
      if (number > kGreatestNumber) {
        result_.notes.push_back(
            fmt::format("The file numbers beyond {}, so that the data names no {}.",
                        kGreatestNumber, name == "cell_id" ? "cells" : "vertices"));
        return;
      }
      numbers.push_back(static_cast<std::int64_t>(number));
    }
    add(name, pack(numbers, 1, Rule::delta));
  }

  void pack_marks() {
    Numbers flags;
    for (const std::uint32_t c : result_.cells) {
      const bool before = shown_.quality_before.inverted[c] != 0;
      const bool after = shown_.has_after() && shown_.quality_after->inverted[c] != 0;
      const bool layer = !shown_.wall_layers.empty() && shown_.wall_layers[c] != 0;
      flags.push_back((before ? 1 : 0) | (after ? 2 : 0) | (layer ? 4 : 0));
    }
    add("cell_flags", pack(flags, 1, Rule::as_is));
    if (shown_.hold.empty()) return;
    Numbers holds;
    for (const Index v : vertices_) holds.push_back(static_cast<std::int64_t>(shown_.hold[v]));
    add("vertex_hold", pack(holds, 1, Rule::as_is));
  }

  void pack_feature_edges() {
    std::vector<VertexPair> edges;
    for (const auto& [a, b] : shown_.feature_edges) {
      const Index p = number_of_[a];
      const Index q = number_of_[b];
      if (p != kNotShown && q != kNotShown) edges.push_back({std::min(p, q), std::max(p, q)});
    }
    std::sort(edges.begin(), edges.end());
    Numbers vertices;
    for (const auto& [a, b] : edges) {
      vertices.push_back(a);
      vertices.push_back(b);
    }
    add("feature_edges", pack(vertices, 2, Rule::delta));
  }

  PackedArray bytes_of(const CellQuality& quality, const PackedMetric& metric) const {
    Numbers bytes;
    bytes.reserve(result_.cells.size());
    for (const std::uint32_t c : result_.cells) bytes.push_back(byte_of(quality, metric, c));
    return pack(bytes, 1, Rule::as_is);
  }

  const ShownMesh& shown_;
  PackedMesh result_;
  std::vector<Index> vertices_;   // by their numbers in the report
  std::vector<Index> number_of_;  // of every vertex of the mesh in the report
};

// Leaves out what does not fit, step by step.
class Fitting {
 public:
  Fitting(const ShownMesh& shown, std::size_t budget)
      : shown_(shown), budget_(budget), place_(display_places(shown.before)) {
    std::vector<const CellQuality*> states{&shown.quality_before};
    if (shown.has_after()) states.push_back(shown.quality_after);
    for (std::size_t k = 0; k < kMetrics.size(); ++k) {
      metrics_[k] = {kMetrics[k], metric_range(kMetrics[k], states)};
    }
  }

  PackedMesh fit() {
    std::vector<std::uint32_t> all(shown_.before.cells().size());
    std::iota(all.begin(), all.end(), 0U);
    const std::size_t count = all.size();
    all = in_display_order(std::move(all));
    for (const Fineness& fineness : {kFine, kCoarse}) {
      Packer packer = pack(all, fineness);
      const bool coarse = fineness.steps_per_box == kCoarse.steps_per_box;
      if (coarse && packer.bytes() > budget_) packer.drop_vertex_numbers();
      if (packer.bytes() > budget_) continue;
      return finish(std::move(packer), count, coarse);
    }
    return fit_some();
  }

 private:
  // Where each cell stands: as in the file, unless neighbours are far apart there.
  static std::vector<std::uint32_t> display_places(const Mesh& mesh) {
    if (has_good_order(mesh.cells())) return {};
    const Ordering ordering = breadth_first_order(mesh);
    std::vector<std::uint32_t> place(ordering.cells.size());
    for (std::uint32_t k = 0; k < place.size(); ++k) place[ordering.cells[k]] = k;
    return place;
  }

  std::vector<std::uint32_t> in_display_order(std::vector<std::uint32_t> cells) const {
    const auto place = [&](std::uint32_t c) { return place_.empty() ? c : place_[c]; };
    std::sort(cells.begin(), cells.end(),
              [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    return cells;
  }

  // What must be there of some cells.
  Packer pack(std::vector<std::uint32_t> cells, const Fineness& fineness) const {
    Packer packer(shown_, std::move(cells), fineness);
    packer.pack_mesh();
    packer.add_metric(metrics_[0], std::numeric_limits<std::size_t>::max());
    return packer;
  }

  // What may be there in addition.
  PackedMesh finish(Packer packer, std::size_t of, bool coarse) const {
    std::string left_out;
    for (std::size_t k = 1; k < metrics_.size(); ++k) {
      if (left_out.empty() && packer.add_metric(metrics_[k], budget_)) continue;
      left_out += fmt::format("{}{}", left_out.empty() ? "" : ", ", name(metrics_[k].metric));
    }
    bool iterates = true;
    if (!shown_.iterates.empty()) iterates = left_out.empty() && packer.add_iterates(budget_);
    PackedMesh mesh = std::move(packer).take();
    if (!iterates) mesh.notes.emplace_back("Iterates are left out: they would not fit.");
    if (!left_out.empty()) {
      mesh.notes.push_back(
          fmt::format("Cells have no values of {} here: they would not fit.", left_out));
    }
    if (coarse) {
      mesh.notes.push_back(fmt::format(
          "Positions are rounded to steps of {:.3g}: finer ones would not fit.", mesh.grid.step));
    }
    if (mesh.cells.size() < of) mesh.notes.push_back(said(mesh.cells.size(), of));
    return mesh;
  }

  std::string said(std::size_t shown, std::size_t of) const {
    const bool volume = shown_.orientation.type == MeshType::volume;
    const bool whole_boundary = volume && shown == outer_;
    return fmt::format(
        "The picture to turn and zoom shows {} of {} cells, as all would not fit: the worst with "
        "their neighbours, those around the longest moves, and {}. All numbers are of the whole "
        "mesh.",
        with_thousands(shown), with_thousands(of),
        whole_boundary ? "all on the boundary"
        : volume       ? "an even part of those on the boundary"
                       : "an even part of the others");
  }

  // A first part of the cells by importance. How many fit is found in a few attempts.
  PackedMesh fit_some() {
    const Importance importance = rank_cells(shown_);
    outer_ = importance.outer;
    const auto first = [&](std::size_t count) {
      return in_display_order({importance.cells.begin(),
                               importance.cells.begin() + static_cast<std::ptrdiff_t>(count)});
    };
    constexpr int kAttempts = 6;  // and more until something fits
    constexpr double kGoodEnough = 0.9;
    const auto budget = static_cast<double>(budget_);
    std::size_t fits = 0;
    std::size_t too_many = importance.outer + 1;
    std::size_t count = importance.outer;
    for (int i = 0; count > fits && (i < kAttempts || fits == 0); ++i) {
      Packer packer = pack(first(count), kCoarse);
      packer.drop_vertex_numbers();
      const auto bytes = static_cast<double>(packer.bytes());
      (bytes <= budget ? fits : too_many) = count;
      if (fits == importance.outer || (fits == count && bytes >= kGoodEnough * budget)) break;
      // Fewer cells share fewer vertices and take more bytes each.
      const double part = std::min(0.97 * budget / bytes, fits == 0 ? 0.7 : 1.0);
      const auto guess = static_cast<std::size_t>(part * static_cast<double>(count));
      count = fits == 0 ? guess : (fits + too_many) / 2;
    }
    Packer packer = pack(first(fits), kCoarse);
    packer.drop_vertex_numbers();
    return finish(std::move(packer), shown_.before.cells().size(), true);
  }

  const ShownMesh& shown_;
  std::size_t budget_;
  std::vector<std::uint32_t> place_;  // per cell; empty: as in the file
  std::array<PackedMetric, kMetricCount> metrics_;
  std::size_t outer_ = 0;
};

}  // namespace

std::size_t PackedMesh::bytes() const {
  std::size_t sum = 0;
  for (const NamedArray& one : arrays) sum += one.array.bytes.size();
  return sum;
}

PackedMesh pack_mesh(const ShownMesh& shown, std::size_t budget) {
  return Fitting(shown, budget).fit();
}

}  // namespace evenmesh
