// SPDX-License-Identifier: MIT
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "evenmesh/base/version.h"
#include "evenmesh/mesh/topology.h"
#include "evenmesh/problem/constraints.h"
#include "evenmesh/problem/problem.h"
#include "evenmesh/report/run_record.h"
#include "evenmesh/solver/smooth.h"
#include "tests/report/schema.h"
#include "tests/support/places.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using nlohmann::json;
using testing::schema_violations;
using Lines = std::vector<std::string>;

const json& schema() {
  static const json kSchema =
      json::parse(std::ifstream(testing::source_dir() / "docs/report.schema.json"));
  return kSchema;
}

json checked(const RunRecord& record) {
  const json report = json::parse(to_json(record));
  EXPECT_EQ(schema_violations(schema(), report), Lines{});
  return report;
}

/// The record of smoothing a mesh whose boundary is fixed.
RunRecord record_of(Mesh mesh, const Options& options = {}) {
  RunRecord record;
  record.status = "ok";
  record.message = "converged in 3 iterations";
  record.command = "evenmesh in.obj -o out.obj";
  record.input = "in.obj";
  record.output = "out.obj";
  record.format = "obj";
  record.vertices = mesh.point_count();
  record.options = {{"tolerance", "1e-06"}, {"fix", "boundary"}};
  for (const CellKind kind : mesh.cells().kinds()) ++record.cells[static_cast<std::size_t>(kind)];
  const Orientation orientation = find_orientation(mesh);
  record.type = orientation.type;
  const Topology topology = find_topology(mesh, orientation);
  record.components = topology.components;
  Problem problem;
  problem.orientation = orientation;
  record.constraints =
      apply(mesh, topology, {.fixed = Selection{"--fix boundary", topology.boundary}}, problem);
  add_costs(mesh, {}, problem);
  record.report = smooth(mesh, problem, options);
  return record;
}

TEST(RunReport, OfASuccessMatchesTheSchemaAndTheRun) {
  RunRecord record = record_of(shapes::triangle_grid(6, 1.0, 0.3));
  record.worst = {{.name = "face 1 (line 2)", .shape_before = 0.5, .shape_after = 0.75}};
  record.notes = {"a note."};
  const json report = checked(record);
  EXPECT_EQ(report["status"], "ok");
  EXPECT_EQ(report["exit_code"], 0);
  EXPECT_EQ(report["stop_reason"], "converged");
  EXPECT_EQ(report["promise"], name(record.report.promise));
  EXPECT_EQ(report["solver"], "multigrid");
  EXPECT_EQ(report["output"], "out.obj");
  EXPECT_EQ(report["input"]["cells"], json({{"triangle", 72}}));
  EXPECT_EQ(report["input"]["type"], "planar");
  EXPECT_EQ(report["options"]["tolerance"], "1e-06");
  EXPECT_EQ(report["iterations"], record.report.history.back().number);
  EXPECT_EQ(report["history"].size(), record.report.history.size());
  EXPECT_EQ(report["cost_after"], record.report.cost_after);
  EXPECT_EQ(report["geometry"]["fixed"], 24);
  EXPECT_EQ(report["geometry"]["movable"], 25);
  EXPECT_EQ(report["worst"][0]["cell"], "face 1 (line 2)");
  EXPECT_EQ(report["notes"][0], "a note.");
  EXPECT_EQ(report["still_inverted"], json::array());
  EXPECT_EQ(report["constraints"][0], json({{"kind", "fixed"},
                                            {"text", "--fix boundary"},
                                            {"entry", "eliminated"},
                                            {"count", 24},
                                            {"unit", "vertices"},
                                            {"note", ""}}));
  EXPECT_EQ(report["constraints"][1]["kind"], "validity");
  const Distribution& shape = record.report.quality_after.of(Metric::shape);
  EXPECT_EQ(report["quality"]["after"]["shape"]["min"], shape.worst);
  EXPECT_EQ(report["quality"]["after"]["shape"]["max"], shape.best);
  const Distribution& angle = record.report.quality_after.of(Metric::max_angle);
  EXPECT_EQ(report["quality"]["after"]["max_angle"]["max"], angle.worst);
}

TEST(RunReport, NamesTheMethod) {
  const Mesh mesh = shapes::triangle_grid(6, 1.0, 0.3);
  json report = checked(record_of(mesh));
  EXPECT_EQ(report["method"], "lagrange_newton");
  EXPECT_EQ(report["inverted_unguarded"], 0);
  report = checked(record_of(mesh, {.method = Method::lennard_jones, .max_iterations = 20}));
  EXPECT_EQ(report["method"], "lennard_jones");
  EXPECT_TRUE(report["solver"].is_null());
  EXPECT_GT(report["inverted_unguarded"], 0);
  EXPECT_EQ(report["inverted_after"], 0);
}

TEST(RunReport, EveryMethodIsInTheSchema) {
  json known = schema()["properties"]["method"]["enum"];
  known.erase(known.size() - 1);  // null
  EXPECT_EQ(known, json(method_names()));
}

TEST(RunReport, NamesInvertedCellsWithWhatHoldsThem) {
  RunRecord record = record_of(shapes::triangle_grid(3));
  record.still_inverted = {{"face 7 (line 9)", {"vertex 3 is fixed"}}, {"face 8 (line 10)"}};
  const json inverted = checked(record)["still_inverted"];
  ASSERT_EQ(inverted.size(), 2u);
  EXPECT_EQ(inverted[0]["cell"], "face 7 (line 9)");
  EXPECT_EQ(inverted[0]["held_by"], json::array({"vertex 3 is fixed"}));
  EXPECT_EQ(inverted[1]["cell"], "face 8 (line 10)");
  EXPECT_EQ(inverted[1]["held_by"], json::array());
}

TEST(RunReport, TellsWhichIteratesHaveComparableCosts) {
  RunRecord record = record_of(shapes::triangle_grid(3));
  record.report.history = {{.number = 0, .inverted = 5},
                           {.number = 1, .inverted = 2, .function = 3}};
  const json history = checked(record)["history"];
  EXPECT_EQ(history[0]["function"], 0);
  EXPECT_EQ(history[1]["function"], 3);
  EXPECT_EQ(history[0]["inverted"], 5);
  EXPECT_EQ(history[1]["inverted"], 2);
}

TEST(RunReport, HasEveryPromisedKey) {
  const json report = checked(record_of(shapes::quad_grid(4, 1.0, 0.2)));
  for (const char* key :
       {"/schema_version", "/status", "/exit_code", "/stop_reason", "/iterations", "/cost_before",
        "/cost_after", "/inverted_before", "/inverted_after", "/geometry/moved", "/geometry/fixed",
        "/geometry/max_move", "/time/read_seconds", "/time/setup_seconds", "/time/solve_seconds",
        "/time/write_seconds", "/time/total_seconds", "/peak_memory_bytes", "/history/0"}) {
    EXPECT_TRUE(report.contains(json::json_pointer(key))) << key;
  }
  for (const char* when : {"before", "after"}) {
    for (const Metric metric : kMetrics) {
      for (const char* statistic : {"min", "p1", "p5", "median", "mean"}) {
        EXPECT_TRUE(report["quality"][when][std::string(name(metric))][statistic].is_number())
            << when << name(metric) << statistic;
      }
    }
  }
}

TEST(RunReport, OfARefusalHasNoOutput) {
  RunRecord record = record_of(shapes::triangle_grid(3));
  record.status = "refused";
  record.exit_code = 5;
  record.output.clear();
  record.report.promise = Promise::unimproved;
  const json report = checked(record);
  EXPECT_TRUE(report["output"].is_null());
  EXPECT_EQ(report["promise"], "unimproved");
}

TEST(RunReport, OfAnInterruptionSaysSo) {
  RunRecord record = record_of(shapes::triangle_grid(6, 1.0, 0.3),
                               {.progress = [](const Iteration& i) { return i.number < 1; }});
  record.status = "interrupted";
  record.exit_code = 130;
  EXPECT_EQ(checked(record)["stop_reason"], "interrupted");
}

TEST(RunReport, OfAFailureBeforeAnythingWasReadIsValidToo) {
  RunRecord record;
  record.status = "failed";
  record.exit_code = 3;
  record.message = "in.obj: is empty";
  const json report = checked(record);
  EXPECT_TRUE(report["stop_reason"].is_null());
  EXPECT_TRUE(report["promise"].is_null());
  EXPECT_EQ(report["iterations"], 0);
  EXPECT_EQ(report["message"], "in.obj: is empty");
}

TEST(RunReport, OfAMeshWithoutCellsIsValid) {
  const json report = checked(record_of(Mesh()));
  EXPECT_EQ(report["stop_reason"], "nothing_to_move");
  EXPECT_EQ(report["input"]["cells"], json::object());
  EXPECT_EQ(report["quality"]["before"]["shape"]["count"], 0);
}

TEST(RunReport, WritesInfinityAsNull) {
  RunRecord record = record_of(shapes::triangle_grid(3));
  Distribution& ratio = record.report.quality_before.metrics[static_cast<int>(Metric::edge_ratio)];
  ratio.worst = ratio.p1 = ratio.mean = std::numeric_limits<double>::infinity();
  const json before = checked(record)["quality"]["before"]["edge_ratio"];
  EXPECT_TRUE(before["max"].is_null());
  EXPECT_TRUE(before["worst"].is_null());
  EXPECT_TRUE(before["mean"].is_null());
  EXPECT_TRUE(before["min"].is_number());
}

TEST(RunReport, ReplacesBytesThatAreNotUtf8) {
  RunRecord record = record_of(shapes::triangle_grid(3));
  record.input = "gr\xFC\xDF.obj";
  record.worst = {{.name = "face 1 in \"\xFF\n\""}};
  const json report = checked(record);
  EXPECT_EQ(report["input"]["file"], "gr\xEF\xBF\xBD\xEF\xBF\xBD.obj");
  EXPECT_EQ(report["worst"][0]["cell"], "face 1 in \"\xEF\xBF\xBD\n\"");
}

TEST(RunReport, HasEveryCellKindByItsName) {
  for (const shapes::Named& specimen : shapes::zoo()) {
    SCOPED_TRACE(specimen.name);
    RunRecord record;
    record.status = "ok";
    for (const CellKind kind : specimen.mesh.cells().kinds()) {
      ++record.cells[static_cast<std::size_t>(kind)];
    }
    const json cells = checked(record)["input"]["cells"];
    std::size_t total = 0;
    for (const auto& [kind, count] : cells.items()) total += count.get<std::size_t>();
    EXPECT_EQ(total, specimen.mesh.cells().size());
  }
}

TEST(RunReport, WithAMemberTooFewOrTooManyBreaksTheSchema) {
  json report = json::parse(to_json(record_of(shapes::triangle_grid(3))));
  report.erase("status");
  report["extra"] = 1;
  report["quality"]["after"].erase("shape");
  EXPECT_EQ(schema_violations(schema(), report).size(), 3u);
}

TEST(WorstCells, ComeWorstFirstAndEqualOnesInTheOrderOfTheFile) {
  CellQuality quality;
  quality.values[static_cast<int>(Metric::shape)] = {0.5, 0.1, 0.9, 0.1, 0.0};
  quality.inverted = {0, 0, 0, 0, 0};
  EXPECT_EQ(worst_cells(quality, 3), (std::vector<std::size_t>{4, 1, 3}));
  EXPECT_EQ(worst_cells(quality, 99).size(), 5u);
  EXPECT_EQ(worst_cells({}, 3).size(), 0u);
}

TEST(WorstCells, AreFirstThoseThatAreInvertedBetweenGoodCorners) {
  CellQuality quality;
  quality.values[static_cast<int>(Metric::shape)] = {0.5, 0.1, 0.9, 0.0};
  quality.inverted = {0, 0, 1, 1};
  EXPECT_EQ(worst_cells(quality, 4), (std::vector<std::size_t>{3, 2, 1, 0}));
}

TEST(Version, IsThatOfTheBuild) { EXPECT_STREQ(kVersion, EVENMESH_PROJECT_VERSION); }

}  // namespace
}  // namespace evenmesh
