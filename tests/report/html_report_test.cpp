// SPDX-License-Identifier: MIT
//
// Reports are read back with tests/report/inflated.h and compared with what went in.
#include "evenmesh/report/html_report.h"

#include <gtest/gtest.h>

#include "evenmesh/mesh/topology.h"
#include "evenmesh/report/packed_mesh.h"
#include "evenmesh/report/page_bundle.h"
#include "tests/report/inflated.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using nlohmann::json;
using testing::parse_report;
using testing::ReportFile;

constexpr std::size_t kPlenty = 8'000'000;
constexpr const char* kHostile = "</script><img src=x onerror=alert(1)>\"'\x01\xff<!--";

/// Two states of a mesh and all that a report of them needs.
struct Case {
  explicit Case(Mesh m, int threads = 1)
      : mesh(std::move(m)),
        orientation(find_orientation(mesh)),
        topology(find_topology(mesh, orientation)) {
    for (std::size_t v = 0; v < mesh.point_count(); ++v) {
      const Vec3& p = mesh.points()[v];
      after.push_back(p + 1e-3 * Vec3(std::sin(9.0 * p.y()), std::sin(7.0 * p.x()), 0.0));
    }
    Workers workers(threads);
    from = measure_cells(workers, mesh, mesh.points(), orientation);
    to = measure_cells(workers, mesh, after, orientation);
    page.title = "part.obj";
    page.status = "ok";
    page.message = "done";
    page.before = summarize(workers, from);
    page.after = summarize(workers, to);
  }

  ShownMesh shown() const {
    return {.before = mesh,
            .orientation = orientation,
            .quality_before = from,
            .after = after,
            .quality_after = &to,
            .feature_edges = topology.curves,
            .cell_number = [](std::size_t cell) { return 1000 + cell; },
            .vertex_number = [](Index v) { return 5 + 2 * std::uint64_t{v}; }};
  }

  std::string html(std::size_t most = kPlenty) const { return html_report(page, shown(), most); }
  ReportFile report(std::size_t most = kPlenty) const { return parse_report(html(most)); }

  Mesh mesh;
  Orientation orientation;
  Topology topology;
  std::vector<Vec3> after;
  CellQuality from, to;
  ReportPage page;
};

CellKind kind_of(std::int64_t code) {
  constexpr CellKind kKinds[] = {CellKind::triangle, CellKind::quad,  CellKind::tet,
                                 CellKind::pyramid,  CellKind::wedge, CellKind::hex,
                                 CellKind::polygon};
  return kKinds[code];
}

/// The mesh in a report, with the numbers of the original.
struct Decoded {
  explicit Decoded(const ReportFile& file) {
    const json& points = file.json["mesh"]["points"];
    const double scale = points["scale"];
    const auto places = file.array("points");
    const auto moves = file.array("moves");
    const auto ids = file.array("vertex_id");
    for (std::size_t v = 0; v < ids.size(); ++v) {
      vertices.push_back(static_cast<Index>((ids[v] - 5) / 2));
      Vec3 p;
      Vec3 q;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double origin = points["origin"][axis];
        const auto i = static_cast<int>(axis);
        p[i] = origin + scale * static_cast<double>(places[3 * v + axis]);
        q[i] = origin + scale * static_cast<double>(places[3 * v + axis] + moves[3 * v + axis]);
      }
      before.push_back(p);
      after.push_back(q);
    }
    step = scale;
    const auto kinds = file.array("cell_kind");
    const auto corners = file.array("cell_vertices");
    const auto sizes =
        file.has("polygon_size") ? file.array("polygon_size") : std::vector<std::int64_t>{};
    std::size_t at = 0;
    std::size_t polygon = 0;
    for (const std::int64_t code : kinds) {
      const CellKind kind = kind_of(code);
      const auto count = kind == CellKind::polygon
                             ? static_cast<std::size_t>(sizes.at(polygon++))
                             : static_cast<std::size_t>(traits(kind).vertices);
      std::vector<Index> cell;
      for (std::size_t k = 0; k < count; ++k) {
        cell.push_back(vertices[static_cast<std::size_t>(corners.at(at++))]);
      }
      cells.emplace_back(kind, cell);
    }
    EXPECT_EQ(at, corners.size());
    for (const std::int64_t id : file.array("cell_id")) {
      numbers.push_back(static_cast<std::size_t>(id - 1000));
    }
  }

  double step = 0.0;
  std::vector<Index> vertices;
  std::vector<Vec3> before, after;
  std::vector<std::pair<CellKind, std::vector<Index>>> cells;
  std::vector<std::size_t> numbers;
};

void expect_same(const Decoded& decoded, const Case& original) {
  for (std::size_t v = 0; v < decoded.vertices.size(); ++v) {
    const Index number = decoded.vertices[v];
    const double from = (decoded.before[v] - original.mesh.points()[number]).cwiseAbs().maxCoeff();
    const double to = (decoded.after[v] - original.after[number]).cwiseAbs().maxCoeff();
    ASSERT_LE(std::max(from, to), 0.5001 * decoded.step) << number;
  }
  ASSERT_EQ(decoded.cells.size(), decoded.numbers.size());
  for (std::size_t c = 0; c < decoded.cells.size(); ++c) {
    const std::size_t number = decoded.numbers[c];
    ASSERT_EQ(decoded.cells[c].first, original.mesh.cells().kind(number));
    const auto vertices = original.mesh.cells().vertices(number);
    ASSERT_EQ(decoded.cells[c].second, std::vector<Index>(vertices.begin(), vertices.end()));
  }
}

TEST(HtmlReport, HoldsTheMeshBeforeAndAfter) {
  const std::vector<Mesh> meshes{shapes::triangle_grid(9, 1.0, 0.3),
                                 shapes::mixed_surface(8),
                                 shapes::tet_grid(3),
                                 shapes::hex_grid(3, 0.2),
                                 shapes::wedge_grid(2),
                                 shapes::pyramid_grid(2),
                                 shapes::hexagons(4),
                                 shapes::shuffled(shapes::triangle_grid(200), 3)};
  for (const Mesh& mesh : meshes) {
    const Case original(mesh);
    const ReportFile file = original.report();
    const Decoded decoded(file);
    EXPECT_EQ(decoded.cells.size(), mesh.cells().size());
    EXPECT_EQ(decoded.vertices.size(), mesh.point_count());
    EXPECT_EQ(file.json["mesh"]["cells"]["shown"], mesh.cells().size());
    EXPECT_EQ(file.json["mesh"]["points"]["count"], mesh.point_count());
    EXPECT_EQ(file.json["notes"], json::array());
    expect_same(decoded, original);
  }
}

TEST(HtmlReport, NumbersVerticesByTheirFirstUse) {
  const auto vertices =
      Case(shapes::shuffled(shapes::triangle_grid(6), 1)).report().array("cell_vertices");
  std::int64_t next = 0;
  for (const std::int64_t v : vertices) {
    ASSERT_LE(v, next);
    if (v == next) ++next;
  }
}

TEST(HtmlReport, HoldsEveryMetricInBytes) {
  const Case original(shapes::triangle_grid(9, 1.0, 0.3));
  const ReportFile file = original.report();
  ASSERT_EQ(file.json["mesh"]["metrics"].size(), kMetrics.size());
  for (std::size_t k = 0; k < kMetrics.size(); ++k) {
    const json& metric = file.json["mesh"]["metrics"][k];
    ASSERT_EQ(metric["name"], name(kMetrics[k]));
    const double low = metric["low"];
    const double high = metric["high"];
    const auto bytes = file.array("after_" + std::string(name(kMetrics[k])));
    const auto ids = file.array("cell_id");
    for (std::size_t c = 0; c < bytes.size(); ++c) {
      const auto cell = static_cast<std::size_t>(ids[c] - 1000);
      const double value = std::clamp(original.to.of(kMetrics[k])[cell], low, high);
      const double stored = low + (high - low) * static_cast<double>(bytes[c]) / 254.0;
      ASSERT_NEAR(stored, value, 0.51 * (high - low) / 254.0);
    }
  }
}

TEST(HtmlReport, MarksWhatIsInvertedAndHasNoValueForIt) {
  // The middle of the square out of it: two cells are turned over.
  const Case original(shapes::fig5(0.9, 0.0));
  const ReportFile file = original.report();
  const auto flags = file.array("cell_flags");
  const auto ids = file.array("cell_id");
  const auto shape = file.array("before_shape");
  std::size_t inverted = 0;
  for (std::size_t c = 0; c < flags.size(); ++c) {
    const bool is = original.from.inverted[static_cast<std::size_t>(ids[c] - 1000)] != 0;
    EXPECT_EQ((flags[c] & 1) != 0, is);
    EXPECT_EQ(shape[c] == 255, is);
    inverted += is;
  }
  EXPECT_GT(inverted, 0u);
}

TEST(HtmlReport, SaysWhatHoldsVerticesAndWhichGroupsCellsAreIn) {
  const Case original(
      shapes::grouped(shapes::quad_grid(2), [](std::size_t c) { return std::uint32_t(c % 2); }));
  ShownMesh shown = original.shown();
  shown.group_names = {"", kHostile};
  shown.hold.assign(9, Hold::fixed);
  shown.hold[4] = Hold::free;
  const ReportFile file = parse_report(html_report(original.page, shown, kPlenty));
  EXPECT_EQ(file.array("cell_group"), (std::vector<std::int64_t>{0, 1, 0, 1}));
  ASSERT_EQ(file.json["groups"].size(), 1u);
  const auto ids = file.array("vertex_id");
  const auto hold = file.array("vertex_hold");
  for (std::size_t v = 0; v < ids.size(); ++v) EXPECT_EQ(hold[v], ids[v] == 13 ? 0 : 1);
}

TEST(HtmlReport, HasTheEdgesOfTheBoundary) {
  const ReportFile file = Case(shapes::quad_grid(3)).report();
  const auto edges = file.array("feature_edges");
  EXPECT_EQ(edges.size(), 2u * 12u);
  EXPECT_EQ(file.json["arrays"]["feature_edges"]["components"], 2);
}

TEST(HtmlReport, IsFlatForAPlaneAlone) {
  EXPECT_EQ(Case(shapes::quad_grid(3)).report().json["mesh"]["dimension"], 2);
  EXPECT_EQ(Case(shapes::rotated(shapes::quad_grid(3), Vec3(1, 0, 0), 0.3))
                .report()
                .json["mesh"]["dimension"],
            3);
  EXPECT_EQ(Case(shapes::tet_grid(2)).report().json["mesh"]["type"], "volume");
}

TEST(HtmlReport, HoldsIteratesOnTheWay) {
  const Case original(shapes::triangle_grid(5));
  const std::vector<StoredIterate> iterates{
      {0, {original.mesh.points().begin(), original.mesh.points().end()}}, {7, original.after}};
  ShownMesh shown = original.shown();
  shown.iterates = iterates;
  const ReportFile file = parse_report(html_report(original.page, shown, kPlenty));
  EXPECT_EQ(file.json["mesh"]["iterates"], (json{0, 7}));
  EXPECT_EQ(file.array("iterate_0"), std::vector<std::int64_t>(3 * 36, 0));
  EXPECT_EQ(file.array("iterate_1"), file.array("moves"));
}

TEST(HtmlReport, OfAMeshWithoutCellsHasNone) {
  const ReportFile file = Case(Mesh()).report();
  EXPECT_EQ(file.json["mesh"]["cells"]["of"], 0);
  EXPECT_TRUE(file.array("cell_kind").empty());
}

TEST(HtmlReport, WithoutASecondStateHasOne) {
  Case original(shapes::triangle_grid(5));
  original.page.after.reset();
  ShownMesh shown = original.shown();
  shown.after = {};
  shown.quality_after = nullptr;
  const ReportFile file = parse_report(html_report(original.page, shown, kPlenty));
  EXPECT_EQ(file.json["mesh"]["has_after"], false);
  EXPECT_FALSE(file.has("moves"));
  EXPECT_FALSE(file.has("after_shape"));
  EXPECT_FALSE(file.json["quality"][0].contains("after"));
}

TEST(HtmlReport, LetsOnlyItsOwnScriptAndStyleIn) {
  const ReportFile file = Case(shapes::quad_grid(2)).report();
  EXPECT_EQ(file.script, page_bundle().script);
  EXPECT_EQ(testing::sha256_base64("abc"), "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
  EXPECT_NE(file.policy.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(file.policy.find("script-src 'sha256-" + testing::sha256_base64(file.script) + "'"),
            std::string::npos);
  EXPECT_NE(file.policy.find("style-src 'sha256-" + testing::sha256_base64(file.style) + "'"),
            std::string::npos);
}

TEST(HtmlReport, NeedsNoStyleThatThePolicyForbids) {
  Case original(shapes::triangle_grid(6));
  RunRecord run;
  run.report.history.resize(3);
  original.page.run = &run;
  const ReportFile file = original.report();
  EXPECT_NE(file.main.find("<svg"), std::string::npos);
  EXPECT_EQ(file.main.find("<style"), std::string::npos);
  EXPECT_EQ(file.main.find(" style="), std::string::npos);
  EXPECT_EQ(file.main.find("<script"), std::string::npos);
}

TEST(HtmlReport, ShowsHostileTextsAsText) {
  Case original(shapes::quad_grid(2));
  ReportPage& page = original.page;
  RunRecord run;
  run.input = run.message = run.command = kHostile;
  run.notes = {kHostile};
  page.run = &run;
  page.title = page.status = page.message = page.command = kHostile;
  page.notes = {kHostile};
  page.verdicts = {{kHostile, true, kHostile}};
  page.ledger = {{kHostile, kHostile}};
  page.worst = {{{.name = kHostile, .held_by = {kHostile}}, 0}};
  ShownMesh shown = original.shown();
  shown.group_names = {"", kHostile};
  const std::string html = html_report(page, shown, kPlenty);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(html.find("<!--"), std::string::npos);
  EXPECT_EQ(html.find('\x01'), std::string::npos);
  EXPECT_EQ(html.find('\xff'), std::string::npos);
  std::size_t scripts = 0;
  for (std::size_t at = 0; (at = html.find("</script", at)) != std::string::npos; ++at) ++scripts;
  EXPECT_EQ(scripts, 3u);
  const ReportFile file = parse_report(html);
  EXPECT_EQ(file.json["title"].get<std::string>().find("</script><img src=x"), 0u);
  EXPECT_EQ(file.json["groups"][0], file.json["title"]);
}

TEST(HtmlReport, ListsTheWorstByTheirPlaceInTheData) {
  Case original(shapes::shuffled(shapes::triangle_grid(200, 1.0, 0.3), 5));
  original.page.worst = {{{.name = "face 4"}, 3}, {{.name = "face 78"}, 77}};
  const ReportFile file = original.report();
  const auto ids = file.array("cell_id");
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t at = file.json["worst"][i]["cell"];
    EXPECT_EQ(ids.at(at), 1000 + static_cast<std::int64_t>(original.page.worst[i].number));
  }
}

TEST(HtmlReport, HasTheSameBytesForAnyNumberOfThreads) {
  const Mesh mesh = shapes::triangle_grid(100, 1.0, 0.3);
  const std::string one = Case(mesh, 1).html();
  EXPECT_EQ(Case(mesh, 2).html(), one);
  EXPECT_EQ(Case(mesh, 3).html(), one);
}

// ---- the budget ---------------------------------------------------------------------------------

bool says(const json& notes, const std::string& what) {
  return std::any_of(notes.begin(), notes.end(), [&](const json& note) {
    return note.get<std::string>().find(what) != std::string::npos;
  });
}

TEST(HtmlReport, LeavesOutMetricsFirst) {
  const Case original(shapes::triangle_grid(120, 1.0, 0.3));
  // The picture of the mesh is as small as it gets by then.
  const std::size_t all = original.html(original.html().size() - 1).size();
  const std::size_t budget = all - 20'000;
  const std::string html = original.html(budget);
  EXPECT_LE(html.size(), budget);
  const ReportFile file = parse_report(html);
  EXPECT_LT(file.json["mesh"]["metrics"].size(), kMetrics.size());
  EXPECT_EQ(file.json["mesh"]["metrics"][0]["name"], "shape");
  EXPECT_FALSE(file.has("after_edge_ratio"));
  EXPECT_TRUE(says(file.json["notes"], "edge_ratio")) << file.json["notes"];
  EXPECT_NE(file.main.find("edge_ratio here: they would not fit."), std::string::npos);
  EXPECT_EQ(file.json["mesh"]["cells"]["shown"], original.mesh.cells().size());
  expect_same(Decoded(file), original);
}

void expect_some_cells(const Case& original, std::size_t budget) {
  const std::string html = original.html(budget);
  EXPECT_LE(html.size(), budget);
  EXPECT_GE(html.size(), budget * 3 / 4);
  const ReportFile file = parse_report(html);
  const std::size_t shown = file.json["mesh"]["cells"]["shown"];
  EXPECT_LT(shown, original.mesh.cells().size());
  EXPECT_GT(shown, 0u);
  EXPECT_EQ(file.json["mesh"]["cells"]["of"], original.mesh.cells().size());
  EXPECT_TRUE(says(file.json["notes"], "cells, as all would not fit")) << file.json["notes"];
  EXPECT_EQ(file.array("cell_kind").size(), shown);
  EXPECT_FALSE(file.has("vertex_id"));
}

TEST(HtmlReport, ThenLeavesOutCellsOfASurface) {
  const Case original(shapes::triangle_grid(150, 1.0, 0.3));
  expect_some_cells(original, page_bundle().script.size() + page_bundle().style.size() + 150'000);
}

// Step by step, with ever less room.
TEST(HtmlReport, ThenLeavesOutTheInsideOfAVolume) {
  const Case original(shapes::hex_grid(24, 0.2));
  const std::size_t all = original.mesh.cells().size();
  std::vector<std::size_t> shown{all};
  bool boundary = false;
  for (std::size_t budget = 400'000; budget > 50'000; budget = budget * 9 / 10) {
    const PackedMesh packed = pack_mesh(original.shown(), budget);
    EXPECT_LE(packed.bytes(), budget);
    EXPECT_LE(packed.cells.size(), shown.back());
    shown.push_back(packed.cells.size());
    if (packed.cells.size() == all) continue;
    if (!boundary) {
      boundary = true;
      EXPECT_GE(packed.cells.size(), 24u * 24u * 24u - 22u * 22u * 22u);
      EXPECT_TRUE(says(packed.notes, "all on the boundary")) << json(packed.notes);
    }
  }
  EXPECT_LT(shown.back(), 24u * 24u * 24u - 22u * 22u * 22u);
}

TEST(HtmlReport, ThatHasNoRoomForCellsSaysSo) {
  const ReportFile file = Case(shapes::triangle_grid(40)).report(1000);
  EXPECT_EQ(file.json["mesh"]["cells"]["shown"], 0);
  EXPECT_TRUE(says(file.json["notes"], "shows 0 of 3,200 cells")) << file.json["notes"];
}

}  // namespace
}  // namespace evenmesh
