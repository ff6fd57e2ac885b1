// SPDX-License-Identifier: MIT
#include "evenmesh/plot/mesh_picture.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/plot/camera.h"
#include "evenmesh/plot/faces.h"
#include "evenmesh/plot/palette.h"
#include "tests/plot/xml.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing::Element;
using testing::named;
using testing::parse_xml;
using testing::texts;

// A panel of 100 pixels and 3 on each side.
constexpr double kWidth = 106.0;

std::string picture(const Mesh& mesh, MeshPictureOptions options = {}) {
  options.panel_width = kWidth;
  return mesh_picture(mesh, find_orientation(mesh), {{"mesh", mesh.points()}}, options);
}

std::vector<Element> paths(const std::string& svg) { return named(parse_xml(svg), "path"); }

std::size_t count_polygons(const std::string& svg) {
  std::size_t count = 0;
  for (const Element& path : paths(svg)) {
    const std::string data = path["d"];
    count += static_cast<std::size_t>(std::count(data.begin(), data.end(), 'z'));
  }
  return count;
}

std::string all_text(const std::string& svg) {
  std::string all;
  for (const std::string& text : texts(svg)) all += text + '\n';
  return all;
}

bool says(const std::string& svg, const std::string& what) {
  return all_text(svg).find(what) != std::string::npos;
}

TEST(MeshPicture, DrawsCellsAtTheirPlaces) {
  const std::vector<Element> all = paths(picture(shapes::fig5(0, 0)));
  ASSERT_EQ(all.size(), 1u);  // four equal triangles
  // In tenths of pixels: the corner (0, 0) of the mesh is 3 from the left and 103 from above.
  EXPECT_EQ(all[0]["d"],
            "M30 1030l1000 0-500-500z"
            "M1030 1030l0-1000-500 500z"
            "M1030 30l-1000 0 500 500z"
            "M30 30l0 1000 500-500z");
}

TEST(MeshPicture, ColoursByQuality) {
  const std::vector<Element> all = paths(picture(shapes::quad_grid(1)));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0]["fill"], quality_colour(0.975));  // the middle of the best class of twenty
}

TEST(MeshPicture, DrawsInvertedCellsRedAndLast) {
  // The middle vertex lies beyond the right side: the triangle there is turned over.
  const std::string svg = picture(shapes::fig5(0.7, 0));
  const std::vector<Element> all = paths(svg);
  ASSERT_GE(all.size(), 2u);
  EXPECT_EQ(all.back()["fill"], kInvertedColour);
  EXPECT_EQ(all.back()["stroke"], kInvertedEdge);
  // 100 pixels are 1.2: the corner (1, 0) lies at 83.3, the middle vertex at 100. Of the height
  // of 89 pixels 83.3 are needed.
  EXPECT_EQ(all.back()["d"], "M863 862l0-834 167 417z");
  for (std::size_t i = 0; i + 1 < all.size(); ++i) EXPECT_NE(all[i]["fill"], kInvertedColour);
  EXPECT_TRUE(says(svg, "1 inverted"));
}

TEST(MeshPicture, ShowsEveryPanelAtTheSameScale) {
  const Mesh small = shapes::quad_grid(1, 1.0);
  const Mesh large = shapes::quad_grid(1, 2.0);
  const std::vector<Element> all = paths(mesh_picture(
      small, find_orientation(small), {{"before", small.points()}, {"after", large.points()}},
      {.panel_width = kWidth}));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0]["d"], "M30 1030l500 0 0-500-500 0z");
  EXPECT_EQ(all[1]["d"], "M30 1030l1000 0 0-1000-1000 0z");
}

TEST(MeshPicture, SaysWorstAndMeanOfTheMetric) {
  const std::string svg = picture(shapes::fig5(0, 0), {.metric = Metric::min_angle});
  EXPECT_TRUE(says(svg, "min angle: worst 45.0\u00B0 \u00B7 mean 45.0\u00B0"));
  EXPECT_TRUE(says(svg, "smallest angle (degrees)"));
}

// Two squares in planes of their own, the nearer one first in the list.
Mesh two_squares(double shift, double size) {
  std::vector<Vec3> points;
  for (const auto& [z, x, s] : {std::array{1.0, 0.0, 1.0}, std::array{0.0, shift, size}}) {
    for (const auto& [a, b] :
         {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
      points.emplace_back(x + a * s, shift + b * s, z);
    }
  }
  Cells cells;
  cells.add(CellKind::quad, std::array<Index, 4>{0, 1, 2, 3});
  cells.add(CellKind::quad, std::array<Index, 4>{4, 5, 6, 7});
  return Mesh(std::move(points), std::move(cells));
}

const MeshPictureOptions kFromAbove = {.view = Vec3(0, 0, 1), .up = Vec3(0, 1, 0)};

TEST(MeshPicture, DrawsWhatIsNearerLast) {
  const std::vector<Element> all = paths(picture(two_squares(0.5, 1.0), kFromAbove));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(all[0]["d"].starts_with("M363 "))
      << all[0]["d"];  // the far one, a third to the right
  EXPECT_TRUE(all[1]["d"].starts_with("M30 ")) << all[1]["d"];
}

TEST(MeshPicture, LeavesOutWhatIsHidden) {
  EXPECT_EQ(count_polygons(picture(two_squares(0.2, 0.2), kFromAbove)), 1u);
  const Mesh cube = shapes::cube_surface(1);
  EXPECT_EQ(count_polygons(picture(cube)), 3u);
  EXPECT_EQ(count_polygons(picture(shapes::reversed(cube, [](std::size_t) { return true; }))), 3u);
}

TEST(MeshPicture, OfAVolumeShowsItsSkin) {
  EXPECT_EQ(count_polygons(picture(shapes::hex_grid(2))), 12u);
}

TEST(FindFaces, OfAVolumeAreItsSkinByCell) {
  const Faces faces = find_faces(shapes::hex_grid(2));
  ASSERT_EQ(faces.polygons.size(), 24u);
  for (std::uint32_t cell = 0; cell < 8; ++cell) {
    EXPECT_EQ(std::count(faces.cells.begin(), faces.cells.end(), cell), 3);
  }
}

TEST(FindFaces, OfASurfaceAreItsCells) {
  const Faces faces = find_faces(shapes::mixed_surface(3));
  EXPECT_EQ(faces.polygons.size(), shapes::mixed_surface(3).cells().size());
  EXPECT_EQ(faces.cells[2], 2u);
}

TEST(MeshPicture, MarksFixedVertices) {
  const Mesh mesh = shapes::fig5(0, 0);
  const std::string svg = picture(mesh, {.fixed = {1, 0, 0, 0, 1}});
  std::vector<std::pair<double, double>> marks;
  for (const Element& r : named(parse_xml(svg), "rect")) {
    if (r["width"] == "6" && r["fill"].empty()) marks.emplace_back(r.number("x"), r.number("y"));
  }
  EXPECT_EQ(marks, (std::vector<std::pair<double, double>>{{0, 100}, {50, 50}}));
  EXPECT_TRUE(says(svg, "fixed vertex"));
  EXPECT_FALSE(says(picture(mesh), "fixed vertex"));
}

TEST(MeshPicture, LeavesEdgesOutBeyondTheBudgetAndSaysSo) {
  const Mesh mesh = shapes::quad_grid(12);
  const std::string with_edges = picture(mesh, {.edge_budget = 144});
  const std::string without = picture(mesh, {.edge_budget = 143});
  EXPECT_FALSE(says(with_edges, "left out"));
  EXPECT_TRUE(says(without, "edges of 144 cells are left out"));
  EXPECT_EQ(count_polygons(without), 144u);
  EXPECT_EQ(paths(without)[0]["stroke"], paths(without)[0]["fill"]);
}

TEST(MeshPicture, DrawsPixelsBeyondTheHardBudgetAndSaysSo) {
  const std::string svg = picture(shapes::quad_grid(12), {.cell_budget = 100});
  EXPECT_TRUE(says(svg, "144 cells are too many to draw"));
  EXPECT_EQ(count_polygons(svg), 0u);
  double covered = 0.0;  // pixels: the sum of the lengths of all runs
  for (const Element& path : paths(svg)) {
    if (path["fill"] != "" || path["d"].find('h') == std::string::npos) continue;
    std::istringstream in(path["d"]);
    for (std::string run; std::getline(in, run, 'm');) {
      const std::size_t h = run.find('h');
      if (h != std::string::npos) covered += std::stod(run.substr(h + 1));
    }
  }
  EXPECT_EQ(covered, 100.0 * 100.0);
}

TEST(MeshPicture, ShowsTheWorstCellOfAPixel) {
  // 10,000 good cells on 100 x 100 pixels and one that is turned over, as large as a pixel.
  Mesh mesh = shapes::quad_grid(100);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  const Index v = 50 * 101 + 50;
  points[v] += Vec3(0.015, 0.0, 0.0);
  mesh.set_points(points);
  const std::string svg = picture(mesh, {.cell_budget = 100});
  const std::vector<Element> all = paths(svg);
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [](const Element& p) { return p["stroke"] == kInvertedColour; }));
}

TEST(MeshPicture, OfALargeMeshStaysSmall) {
  const Mesh mesh = shapes::irregular_triangles(60000, 0.3, 1, 0.95);
  const std::string svg = mesh_picture(mesh, find_orientation(mesh), {{"", mesh.points()}});
  EXPECT_LT(svg.size(), 2'500'000u);
  EXPECT_TRUE(says(svg, "too many to draw"));
}

TEST(MeshPicture, ZoomsToAPart) {
  // The right upper quarter of four by four quads.
  const std::string svg = picture(shapes::quad_grid(4), {.zoom = {0.55, 0.55, 1.0, 1.0}});
  EXPECT_EQ(count_polygons(svg), 4u);
  EXPECT_TRUE(says(svg, "whole mesh"));
}

TEST(MeshPicture, EscapesTitles) {
  const Mesh mesh = shapes::fig5(0, 0);
  const std::string svg = mesh_picture(mesh, find_orientation(mesh),
                                       {{"<script>&\x03\xfe", mesh.points()}}, {.title = "\"a\""});
  EXPECT_TRUE(says(svg, "<script>&\uFFFD\uFFFD"));
  EXPECT_TRUE(says(svg, "\"a\""));
}

TEST(MeshPicture, IsSoundForEveryMetricAndShape) {
  for (const shapes::Named& shape : shapes::zoo()) {
    for (const Metric metric : kMetrics) {
      const std::string svg = picture(shape.mesh, {.metric = metric});
      EXPECT_FALSE(parse_xml(svg).empty()) << shape.name;
      EXPECT_EQ(svg.find("nan"), std::string::npos) << shape.name;
      EXPECT_EQ(svg.find("inf\""), std::string::npos) << shape.name;
    }
  }
}

TEST(MeshPicture, OfWhatHasNoExtentOrNoCellsIsSound) {
  Cells cells;
  cells.add(CellKind::triangle, std::array<Index, 3>{0, 1, 2});
  const Mesh point(std::vector<Vec3>(3, Vec3(5, 5, 5)), cells);
  const Mesh line({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, cells);
  const Mesh upright({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, cells);
  const Mesh huge({{-1e300, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}}, cells);
  const Mesh tiny({{0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}}, cells);
  for (const Mesh* mesh : {&point, &line, &upright, &huge, &tiny}) {
    const std::string svg = picture(*mesh);
    EXPECT_FALSE(parse_xml(svg).empty());
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(count_polygons(svg), 1u);
  }
  EXPECT_TRUE(says(picture(Mesh()), "no cells"));
}

TEST(MeshPicture, RefusesAViewWithoutAnUp) {
  const Mesh cube = shapes::cube_surface(1);
  EXPECT_THROW(picture(cube, {.view = Vec3(0, 2, 0)}), InvalidOption);
  EXPECT_THROW(picture(cube, {.zoom = {0.5, 0.0, 0.5, 1.0}}), InvalidOption);
}

TEST(LookAtPlane, PutsXToTheRightAndTheLaterAxisUp) {
  for (const double sign : {1.0, -1.0}) {
    const auto axes = [&](const Vec3& normal) {
      const Camera camera = look_at_plane(sign * normal);
      return std::pair(camera.right, camera.up);
    };
    EXPECT_EQ(axes(Vec3::UnitZ()), std::pair(Vec3(1, 0, 0), Vec3(0, 1, 0)));
    EXPECT_EQ(axes(Vec3::UnitY()), std::pair(Vec3(1, 0, 0), Vec3(0, 0, 1)));
    EXPECT_EQ(axes(Vec3::UnitX()), std::pair(Vec3(0, 1, 0), Vec3(0, 0, 1)));
  }
}

}  // namespace
}  // namespace evenmesh
