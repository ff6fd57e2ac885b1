// SPDX-License-Identifier: MIT
#include "evenmesh/plot/mesh_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/extent.h"
#include "evenmesh/plot/axis.h"
#include "evenmesh/plot/camera.h"
#include "evenmesh/plot/cell_paths.h"
#include "evenmesh/plot/faces.h"
#include "evenmesh/plot/metric_range.h"
#include "evenmesh/plot/palette.h"
#include "evenmesh/plot/raster.h"
#include "evenmesh/plot/svg.h"
#include "evenmesh/quality/quality.h"

namespace evenmesh {
namespace {

constexpr double kGap = 28.0;  // between panels
constexpr double kMargin = 14.0;
constexpr double kPadding = 3.0;  // between a panel's border and the mesh
constexpr double kHead = 34.0;
constexpr double kFoot = 30.0;
constexpr double kNote = 20.0;
constexpr double kLegend = 66.0;
constexpr double kFont = 13.0;
constexpr double kLetter = 10.0;  // width of one in a title
constexpr double kTallest = 1.5;  // height of a panel, in its widths
constexpr double kLowest = 0.15;
constexpr std::size_t kMostMarks = 3000;

constexpr const char* kCentred = R"(font-size="13" text-anchor="middle")";
constexpr const char* kBold = R"(font-size="16" font-weight="bold" text-anchor="middle")";

/// The part of the projection plane that panels show, and how large.
struct Window {
  double left = 0.0, top = 0.0;      // in the plane
  double scale = 1.0;                // pixels per its unit
  Pixel offset;                      // of the left upper corner within the panel
  double width = 0.0, height = 0.0;  // of the panel, pixels

  Pixel place(const Vec3& p) const {
    return {offset.x() + (p.x() - left) * scale, offset.y() + (top - p.y()) * scale};
  }
};

struct Box {
  double low_x = std::numeric_limits<double>::infinity();
  double low_y = low_x;
  double high_x = -low_x;
  double high_y = -low_x;

  void add(const Vec3& p) {
    low_x = std::min(low_x, p.x());
    high_x = std::max(high_x, p.x());
    low_y = std::min(low_y, p.y());
    high_y = std::max(high_y, p.y());
  }
};

// A panel before it is drawn.
struct Scene {
  std::string title;
  CellQuality quality;
  QualitySummary summary;
  std::vector<Vec3> projected;  // per vertex
  PatchList patches;
  std::vector<Paint> paints;                       // per patch
  std::vector<std::uint32_t> faces;                // per patch
  std::vector<std::vector<std::uint32_t>> layers;  // of patches
  std::size_t drawn = 0;                           // patches in layers
};

class Picture {
 public:
  Picture(const Mesh& mesh, const Orientation& orientation, const MeshPictureOptions& options)
      : mesh_(mesh),
        orientation_(orientation),
        options_(options),
        is_flat_(orientation.type == MeshType::planar),
        camera_(is_flat_ ? look_at_plane(orientation.normal) : look_from(options.view, options.up)),
        faces_(find_faces(mesh)) {
    const auto [x0, y0, x1, y1] = options.zoom;
    if (!(x0 < x1 && y0 < y1)) {
      throw InvalidOption("zoom: the second corner must lie right of and above the first");
    }
  }

  std::string draw(const std::vector<Panel>& panels) {
    measure(panels);
    find_window();
    for (Scene& scene : scenes_) fill_scene(scene);
    find_layers();
    return compose();
  }

 private:
  // ---- what there is to draw ----

  void measure(const std::vector<Panel>& panels) {
    // Lengths are counted in the size of the mesh: squares of them must not overflow.
    const Extent extent = extent_of(panels.front().points, faces_.polygons.corners());
    const double unit = extent.half() > 0.0 ? extent.half() : 1.0;
    Workers workers;
    std::vector<const CellQuality*> all;
    for (const Panel& panel : panels) {
      assert(panel.points.size() == mesh_.point_count());
      Scene scene;
      scene.title = panel.title;
      scene.quality = measure_cells(workers, mesh_, panel.points, orientation_);
      scene.summary = summarize(workers, scene.quality);
      for (const Vec3& p : panel.points) {
        scene.projected.push_back(camera_.project((p - extent.middle()) / unit));
      }
      scenes_.push_back(std::move(scene));
    }
    for (const Scene& scene : scenes_) all.push_back(&scene.quality);
    range_ = metric_range(options_.metric, all);
  }

  void find_window() {
    Box box;
    for (const Scene& scene : scenes_) {
      for (const Index v : faces_.polygons.corners()) box.add(scene.projected[v]);
    }
    if (faces_.polygons.empty()) box = {-1.0, -0.3, 1.0, 0.3};
    const auto [x0, y0, x1, y1] = options_.zoom;
    const double whole_width = box.high_x - box.low_x;
    const double whole_height = box.high_y - box.low_y;
    const double width = (x1 - x0) * whole_width;
    const double height = (y1 - y0) * whole_height;

    window_.width = std::max(options_.panel_width, 60.0);
    const double room = window_.width - 2.0 * kPadding;
    const double wanted = width > 0.0 ? room * height / width : std::numeric_limits<double>::max();
    const double drawn = std::clamp(wanted, kLowest * room, kTallest * room);
    window_.height = std::round(drawn + 2.0 * kPadding);
    // A mesh without extent is a point in the middle.
    window_.scale = std::min(width > 0.0 ? room / width : std::numeric_limits<double>::max(),
                             height > 0.0 ? drawn / height : std::numeric_limits<double>::max());
    if (!(width > 0.0) && !(height > 0.0)) window_.scale = 1.0;
    window_.left = box.low_x + x0 * whole_width;
    window_.top = box.low_y + y1 * whole_height;
    window_.offset = {(window_.width - width * window_.scale) / 2.0,
                      (window_.height - height * window_.scale) / 2.0};
  }

  RasterSize raster_size() const {
    return {static_cast<int>(std::ceil(window_.width)), static_cast<int>(window_.height)};
  }

  // Twice the area of a polygon along its normal, as projected.
  static Vec3 area_vector(std::span<const Index> polygon, const std::vector<Vec3>& projected) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      sum += (projected[polygon[i - 1]] - projected[polygon[0]])
                 .cross(projected[polygon[i]] - projected[polygon[0]]);
    }
    return sum;
  }

  bool is_in_window(std::span<const Pixel> polygon) const {
    const auto all = [&](const auto& outside) {
      return std::all_of(polygon.begin(), polygon.end(), outside);
    };
    return !all([](const Pixel& p) { return p.x() < 0.0; }) &&
           !all([](const Pixel& p) { return p.y() < 0.0; }) &&
           !all([&](const Pixel& p) { return p.x() > window_.width; }) &&
           !all([&](const Pixel& p) { return p.y() > window_.height; });
  }

  void fill_scene(Scene& scene) const {
    const Vec3 light = camera_.project(camera_.light);
    for (std::uint32_t f = 0; f < faces_.polygons.size(); ++f) {
      const std::span<const Index> polygon = faces_.polygons.vertices(f);
      PatchList& list = scene.patches;
      const std::size_t first = list.places.size();
      for (const Index v : polygon) list.places.push_back(window_.place(scene.projected[v]));
      Patch patch{first, list.places.size(), 0.0, Pixel::Zero(), 0.0};
      if (!is_in_window(list.of(patch))) {
        list.places.resize(first);
        continue;
      }
      const std::uint32_t cell = faces_.cells[f];
      const bool inverted = scene.quality.inverted[cell] != 0;
      const double good =
          goodness(options_.metric, range_, scene.quality.of(options_.metric)[cell]);
      const Vec3 area = area_vector(polygon, scene.projected);
      if (is_flat_) {
        patch.depth = inverted ? 2.0 : 1.0 - good;  // where cells share a pixel, the worst is seen
      } else {
        set_depth(patch, polygon, scene.projected, area);
      }
      const double lit = is_flat_ ? -1.0 : std::abs(area.stableNormalized().dot(light));
      list.patches.push_back(patch);
      scene.paints.push_back(paint_of(inverted, good, lit));
      scene.faces.push_back(f);
    }
  }

  void set_depth(Patch& patch, std::span<const Index> polygon, const std::vector<Vec3>& projected,
                 const Vec3& area) const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    double sum = 0.0;
    for (const Index v : polygon) {
      const double z = projected[v].z() * window_.scale;
      low = std::min(low, z);
      high = std::max(high, z);
      sum += z;
    }
    patch.depth = sum / static_cast<double>(polygon.size());
    patch.reach = std::max(high - patch.depth, patch.depth - low);
    // Seen edge-on it has all depths at one place: the mean will do.
    if (std::abs(area.z()) < 1e-3 * area.norm()) return;
    patch.slope = {-area.x() / area.z(), area.y() / area.z()};  // down is against up
  }

  void find_layers() {
    for (Scene& scene : scenes_) {
      if (is_flat_) {  // nothing is hidden; what is turned over is drawn last
        scene.layers.resize(2);
        for (std::uint32_t i = 0; i < scene.paints.size(); ++i) {
          scene.layers[scene.paints[i].quality == kInverted ? 1 : 0].push_back(i);
        }
      } else {
        scene.layers = visible_layers(scene.patches, raster_size());
      }
      for (const auto& layer : scene.layers) scene.drawn += layer.size();
      drawn_ += scene.drawn;
    }
  }

  // ---- drawing ----

  bool draws_pixels() const { return drawn_ > options_.cell_budget; }
  Edges edges() const { return drawn_ > options_.edge_budget ? Edges::left_out : Edges::drawn; }

  std::string note() const {
    const std::string cells = with_thousands(drawn_) + " cells";
    if (draws_pixels()) {
      return cells + (is_flat_ ? " are too many to draw: each pixel shows its worst"
                               : " are too many to draw: each pixel shows the nearest");
    }
    if (edges() == Edges::left_out) return "edges of " + cells + " are left out";
    return "";
  }

  double left(std::size_t panel) const {
    return side_ + static_cast<double>(panel) * (window_.width + kGap);
  }

  std::string compose() {
    const double panels = static_cast<double>(scenes_.size());
    const double row = panels * window_.width + (panels - 1.0) * kGap;
    // Captions and the bar of colours may be wider than one small panel.
    const double width = std::max(row + 2.0 * kMargin, 320.0);
    side_ = (width - row) / 2.0;
    const double head = kHead + (options_.title.empty() ? 0.0 : 28.0);
    const std::string left_out = note();
    const double foot = head + window_.height + kFoot + (left_out.empty() ? 0.0 : kNote);
    Svg svg(width, foot + kLegend);
    svg.raw(fmt::format(
        "<clipPath id=\"panel\"><rect x=\"-1\" y=\"-1\" width=\"{}\" height=\"{}\"/></clipPath>\n",
        svg_number(window_.width + 2.0), svg_number(window_.height + 2.0)));
    if (!options_.title.empty()) {
      svg.text({width / 2.0, 26.0},
               shortened(options_.title, static_cast<std::size_t>(width / kLetter)), kBold);
    }
    for (std::size_t i = 0; i < scenes_.size(); ++i) draw_panel(svg, i, head);
    if (!left_out.empty()) svg.text({width / 2.0, foot - 8.0}, left_out, kCentred);
    draw_legend(svg, width, foot);
    return std::move(svg).finish();
  }

  void draw_panel(Svg& svg, std::size_t i, double head) const {
    const Scene& scene = scenes_[i];
    const double middle = left(i) + window_.width / 2.0;
    const double letters = (window_.width + kGap) / kLetter;
    svg.text({middle, head - 12.0}, shortened(scene.title, static_cast<std::size_t>(letters)),
             kBold);
    svg.open(fmt::format("transform=\"translate({} {})\" clip-path=\"url(#panel)\"",
                         svg_number(left(i)), svg_number(head)));
    if (faces_.polygons.empty()) {
      svg.text({window_.width / 2.0, window_.height / 2.0}, "no cells", kCentred);
    } else if (draws_pixels()) {
      svg.raw(
          pixel_paths(nearest_patches(scene.patches, raster_size()), scene.paints, raster_size()));
    } else {
      svg.raw(cell_paths(scene.patches, scene.paints, scene.layers, edges(), line_width()));
    }
    draw_fixed(svg, scene);
    svg.close();
    svg.text({middle, head + window_.height + 20.0}, caption(scene), kCentred);
  }

  double line_width() const {
    const double most = static_cast<double>(std::max<std::size_t>(
        1, std::max_element(scenes_.begin(), scenes_.end(), [](const Scene& a, const Scene& b) {
             return a.drawn < b.drawn;
           })->drawn));
    return std::clamp(0.03 * std::sqrt(window_.width * window_.height / most), 0.15, 0.8);
  }

  // Vertices of cells that are seen.
  void draw_fixed(Svg& svg, const Scene& scene) const {
    if (!marks_fixed()) return;
    std::vector<char> seen(mesh_.point_count(), 0);
    for (const auto& layer : scene.layers) {
      for (const std::uint32_t i : layer) {
        for (const Index v : faces_.polygons.vertices(scene.faces[i])) seen[v] = 1;
      }
    }
    svg.open(kFixedLook);
    for (std::size_t v = 0; v < seen.size(); ++v) {
      if (seen[v] == 0 || options_.fixed[v] == 0) continue;
      svg.rectangle(window_.place(scene.projected[v]) - Pixel(3.0, 3.0), {6.0, 6.0}, "");
    }
    svg.close();
  }

  bool marks_fixed() const {
    const auto count = std::count_if(options_.fixed.begin(), options_.fixed.end(),
                                     [](char fixed) { return fixed != 0; });
    return count > 0 && static_cast<std::size_t>(count) <= kMostMarks && !draws_pixels();
  }

  std::string caption(const Scene& scene) const {
    const Distribution& values = scene.summary.of(options_.metric);
    std::string text(name(options_.metric));
    std::replace(text.begin(), text.end(), '_', ' ');
    if (options_.zoom != MeshPictureOptions{}.zoom) text += ", whole mesh";
    if (values.count > 0) {
      text += fmt::format(": worst {} \u00B7 mean {}", shown_value(options_.metric, values.worst),
                          shown_value(options_.metric, values.mean));
    } else {
      text += ": no cell has it";
    }
    if (scene.summary.inverted == 0) return text;
    text += fmt::format(" \u00B7 {} inverted", with_thousands(scene.summary.inverted));
    const std::size_t inside = inverted_inside(scene);
    return inside == 0 ? text : text + fmt::format(", {} of them inside", with_thousands(inside));
  }

  // Cells that no face shows.
  std::size_t inverted_inside(const Scene& scene) const {
    std::vector<char> on_skin(mesh_.cells().size(), 0);
    for (const std::uint32_t cell : faces_.cells) on_skin[cell] = 1;
    std::size_t count = 0;
    for (std::size_t c = 0; c < on_skin.size(); ++c) {
      if (scene.quality.inverted[c] != 0 && on_skin[c] == 0) ++count;
    }
    return count;
  }

  void draw_legend(Svg& svg, double width, double top) const {
    const bool any_inverted = std::any_of(scenes_.begin(), scenes_.end(), [](const Scene& scene) {
      return scene.summary.inverted > 0;
    });
    const double bar = std::min(240.0, width / 2.6);
    const double beside = std::max(any_inverted ? 96.0 : 0.0, marks_fixed() ? 124.0 : 0.0);
    const double left = (width - bar - beside) / 2.0;
    const double y = top + 24.0;
    svg.text({left + bar / 2.0, y - 7.0}, axis_title(options_.metric), kCentred);
    draw_bar(svg, left, y, bar);
    double row = y + 10.0 - (any_inverted && marks_fixed() ? 8.0 : 0.0);
    const double swatch = left + bar + 28.0;
    if (any_inverted) {
      svg.rectangle({swatch, row - 10.0}, {12.0, 12.0},
                    fmt::format("fill=\"{}\" stroke=\"{}\"", kInvertedColour, kInvertedEdge));
      svg.text({swatch + 18.0, row}, "inverted", kLeftAligned);
      row += 20.0;
    }
    if (marks_fixed()) {
      svg.rectangle({swatch + 3.0, row - 7.0}, {6.0, 6.0}, kFixedLook);
      svg.text({swatch + 18.0, row}, "fixed vertex", kLeftAligned);
    }
  }

  void draw_bar(Svg& svg, double left, double y, double width) const {
    const double step = width / kQualityClasses;
    for (int k = 0; k < kQualityClasses; ++k) {
      const double value = range_.low + (k + 0.5) / kQualityClasses * (range_.high - range_.low);
      const double good = goodness(options_.metric, range_, value);
      // They overlap a little: no white between them.
      const double overlap = k + 1 < kQualityClasses ? 0.4 : 0.0;
      svg.rectangle({left + k * step, y}, {step + overlap, 12.0},
                    fmt::format("fill=\"{}\"", fill(paint_of(false, good, -1.0))));
    }
    const Axis axis = Axis::linear(range_.low, range_.high, 5);
    for (const Tick& tick : axis.ticks()) {
      const double x = left + tick.place * width;
      svg.line({x, y + 12.0}, {x, y + 16.0}, R"(stroke="#444")");
      const bool is_open = range_.open && tick.place > 0.999;
      svg.text({x, y + 30.0}, is_open ? "\u2265 " + tick.label : tick.label, kCentred);
    }
  }

  static constexpr const char* kLeftAligned = R"(font-size="13")";
  static constexpr const char* kFixedLook = R"(fill="#111" stroke="#fff" stroke-width="0.8")";

  const Mesh& mesh_;
  const Orientation& orientation_;
  const MeshPictureOptions& options_;
  const bool is_flat_;
  const Camera camera_;
  const Faces faces_;
  std::vector<Scene> scenes_;
  MetricRange range_;
  Window window_;
  double side_ = kMargin;  // left of the first panel
  std::size_t drawn_ = 0;  // cells in all panels
};

}  // namespace

std::string mesh_picture(const Mesh& mesh, const Orientation& orientation,
                         const std::vector<Panel>& panels, const MeshPictureOptions& options) {
  assert(!panels.empty());
  assert(options.fixed.empty() || options.fixed.size() == mesh.point_count());
  return Picture(mesh, orientation, options).draw(panels);
}

}  // namespace evenmesh
