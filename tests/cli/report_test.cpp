// SPDX-License-Identifier: MIT
//
// Reports in HTML: what is written when, what it says, and what stops a run before it begins.
#include <gtest/gtest.h>

#include "tests/cli/meshes.h"
#include "tests/cli/process.h"
#include "tests/io/temporary_folder.h"
#include "tests/report/inflated.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::Outcome;
using testing::read_bytes;
using testing::ReportFile;
using testing::run;

/// Two quads on two triangles, with a word for a group and one for an empty set.
constexpr const char* kMixed =
    "g wall\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1.3 1.2 0\nv 2 1 0\nv 0 2 0\nv 1 2 0\nv 2 2 0\n"
    "f 1 2 5 4\nf 2 3 6 5\ng </script><b>\nf 4 5 7\nf 5 8 7\nf 5 6 9 8\ng empty\n";

/// A triangle of second order beside one of which the middle node of the common edge moves along.
constexpr const char* kSecondOrder =
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0.2, 0.3, 0\n"
    "11, 0.5, 0, 0\n12, 1, 0.5, 0\n13, 0.5, 1, 0\n14, 0, 0.5, 0\n"
    "21, 0.1, 0.15, 0\n22, 0.6, 0.15, 0\n23, 0.6, 0.65, 0\n24, 0.1, 0.65, 0\n"
    "*ELEMENT, TYPE=S6, ELSET=PLATE\n101, 1, 2, 5, 11, 22, 21\n102, 2, 3, 5, 12, 23, 22\n"
    "103, 3, 4, 5, 13, 24, 23\n104, 4, 1, 5, 14, 21, 24\n";

class HtmlReports : public ::testing::Test {
 protected:
  HtmlReports() {
    folder_.write("in.obj", testing::kCanImprove);
    folder_.write("good.obj", testing::kCannotImprove);
  }

  Outcome evenmesh(const std::vector<std::string>& arguments) const {
    return run(arguments, {.folder = folder_.path().string()});
  }
  Outcome smooth(std::vector<std::string> more, const std::string& in = "in.obj") const {
    more.insert(more.begin(), {in, "-o", "out" + in.substr(in.find('.'))});
    return evenmesh(more);
  }
  std::string bytes(const std::string& name) const { return read_bytes(folder_.path() / name); }
  bool exists(const std::string& name) const { return fs::exists(folder_.path() / name); }
  ReportFile report(const std::string& name = "r.html") const {
    return testing::parse_report(bytes(name));
  }
  static std::string verdict(const ReportFile& file, const std::string& name) {
    for (const json& v : file.json["verdicts"]) {
      if (v["name"] == name) return v["pass"].dump();
    }
    return "none";
  }

  void expect_nothing_done(const Outcome& outcome, int code, const std::string& why) const {
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("converged"), std::string::npos) << outcome.err;
    EXPECT_FALSE(exists("out.obj"));
    EXPECT_FALSE(exists("r.html"));
  }

  testing::TemporaryFolder folder_;
};

TEST_F(HtmlReports, SayWhatARunDid) {
  const Outcome outcome = smooth({"--report", "r.html", "--target", "shape>=0.2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("wrote r.html"), std::string::npos) << outcome.err;
  const ReportFile file = report();
  EXPECT_EQ(file.json["kind"], "smooth");
  EXPECT_EQ(file.json["title"], "in.obj");
  EXPECT_EQ(file.json["status"], "ok");
  EXPECT_EQ(file.json["run"]["status"], "ok");
  EXPECT_EQ(file.json["history"].size(), file.json["run"]["history"].size());
  EXPECT_EQ(file.json["worst"].size(), 4u);
  EXPECT_EQ(file.array("vertex_hold"), (std::vector<std::int64_t>{1, 1, 0, 1, 1}));
  for (const char* name : {"no inverted cells", "worst quality not lower", "target met",
                           "fixed vertices where they were", "groups, numbers and bytes kept"}) {
    EXPECT_EQ(verdict(file, name), "true") << name;
  }
  EXPECT_NE(file.main.find("evenmesh in.obj -o out.obj --report r.html"), std::string::npos);
}

TEST_F(HtmlReports, GoWithOneInJson) {
  ASSERT_EQ(smooth({"--report", "r.html", "--json", "r.json"}).exit_code, 0);
  json in_html = report().json["run"];
  json alone = json::parse(bytes("r.json"));
  for (const char* differs : {"time"}) {
    in_html.erase(differs);
    alone.erase(differs);
  }
  EXPECT_EQ(in_html, alone);
}

TEST_F(HtmlReports, OfARefusedRunSayWhy) {
  const Outcome outcome = smooth({"--report", "r.html", "--cost", "local"}, "good.obj");
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  EXPECT_FALSE(exists("out.obj"));
  const ReportFile file = report();
  EXPECT_EQ(file.json["status"], "refused");
  EXPECT_NE(file.main.find("refused"), std::string::npos);
  EXPECT_EQ(verdict(file, "file written"), "null");
  EXPECT_EQ(verdict(file, "groups, numbers and bytes kept"), "none");
}

TEST_F(HtmlReports, OfARunThatMissesItsTargetSaySo) {
  EXPECT_EQ(smooth({"--report", "r.html", "--target", "shape>=0.99"}).exit_code, 4);
  EXPECT_EQ(verdict(report(), "target met"), "false");
}

TEST_F(HtmlReports, OfAFailedRunShowWhatWasRead) {
  EXPECT_EQ(smooth({"--report", "r.html", "--fix", "nonsense"}).exit_code, 2);
  const ReportFile file = report();
  EXPECT_EQ(file.json["status"], "failed");
  EXPECT_EQ(file.json["mesh"]["has_after"], false);
  EXPECT_FALSE(exists("out.obj"));
}

TEST_F(HtmlReports, HoldIterates) {
  testing::write_obj(shapes::triangle_grid(8, 1.0, 0.3), folder_.path() / "grid.obj");
  ASSERT_EQ(smooth({"--report", "r.html", "--keep-iterates", "6"}, "grid.obj").exit_code, 0);
  const ReportFile file = report();
  const auto iterates = file.json["mesh"]["iterates"].get<std::vector<int>>();
  ASSERT_GE(iterates.size(), 3u);
  EXPECT_LE(iterates.size(), 6u);
  EXPECT_EQ(iterates[0], 0);
  EXPECT_LE(iterates.back(), file.json["run"]["iterations"].get<int>());
  EXPECT_EQ(file.array("iterate_0"), std::vector<std::int64_t>(3 * 81, 0));
  EXPECT_NE(file.array("iterate_1"), std::vector<std::int64_t>(3 * 81, 0));
}

TEST_F(HtmlReports, CompareTwoFiles) {
  ASSERT_EQ(smooth({}).exit_code, 0);
  const Outcome outcome = evenmesh({"report", "in.obj", "out.obj", "-o", "r.html"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const ReportFile file = report();
  EXPECT_EQ(file.json["kind"], "compare");
  EXPECT_FALSE(file.json.contains("run"));
  EXPECT_EQ(verdict(file, "worst quality not lower"), "true");
  ASSERT_EQ(evenmesh({"report", "out.obj", "in.obj", "-o", "r.html"}).exit_code, 0);
  EXPECT_EQ(verdict(report(), "worst quality not lower"), "false");
}

TEST_F(HtmlReports, CompareNothingWithOtherCells) {
  const auto expect = [this](const std::string& b, const std::string& why) {
    expect_nothing_done(evenmesh({"report", "in.obj", b, "-o", "r.html"}), 2, why);
  };
  folder_.write("more.obj", std::string(testing::kCanImprove) + "v 5 5 5\n");
  expect("more.obj", "the one has 5 vertices, the other 6 vertices");
  folder_.write("other.obj",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.2 0.3 0\n"
                "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 1 5 4\n");
  expect("other.obj", "face 4 (line 10) has other vertices");
  folder_.write("quad.obj",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.2 0.3 0\n"
                "f 1 2 3 4\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  expect("quad.obj", "face 1 (line 7) is a triangle in the one and a quad in the other");
  folder_.write("three.obj",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.2 0.3 0\n"
                "f 1 2 5\nf 2 3 5\nf 3 4 5\n");
  expect("three.obj", "the one has 4 triangles, the other 3 triangles");
  expect_nothing_done(evenmesh({"report", "in.obj", "no.obj", "-o", "r.html"}), 3, "no.obj");
}

TEST_F(HtmlReports, OfACheckShowTheMeshAsItIs) {
  const Outcome outcome = evenmesh({"check", "in.obj", "--report", "r.html"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const ReportFile file = report();
  EXPECT_EQ(file.json["kind"], "check");
  EXPECT_EQ(file.json["mesh"]["has_after"], false);
  EXPECT_EQ(verdict(file, "no inverted cells"), "true");
  folder_.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
  EXPECT_EQ(evenmesh({"check", "flat.obj", "--report", "r.html"}).exit_code, 4);
  EXPECT_EQ(verdict(report(), "every cell has a size"), "false");
}

TEST_F(HtmlReports, ShowGroupsWithWhateverName) {
  folder_.write("mixed.obj", kMixed);
  ASSERT_EQ(smooth({"--report", "r.html"}, "mixed.obj").exit_code, 0);
  const ReportFile file = report();
  EXPECT_EQ(file.json["groups"][1], "g </script><b>");
  EXPECT_EQ(file.array("cell_kind"), (std::vector<std::int64_t>{1, 1, 0, 0, 1}));
  EXPECT_EQ(file.array("cell_id"), (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(bytes("r.html").find("<b>"), std::string::npos);
}

TEST_F(HtmlReports, ShowTheCornersOfCellsOfSecondOrder) {
  folder_.write("plate.inp", kSecondOrder);
  ASSERT_EQ(smooth({"--report", "r.html"}, "plate.inp").exit_code, 0);
  const ReportFile file = report();
  EXPECT_EQ(file.array("cell_id"), (std::vector<std::int64_t>{101, 102, 103, 104}));
  EXPECT_EQ(file.array("vertex_id"), (std::vector<std::int64_t>{1, 2, 5, 3, 4}));
  EXPECT_NE(file.main.find("nodes between corners"), std::string::npos);
}

TEST_F(HtmlReports, OfAFileWithAHostileNameAreSafe) {
  folder_.write("<img onerror=x>.obj", testing::kCanImprove);
  ASSERT_EQ(smooth({"--report", "r.html"}, "<img onerror=x>.obj").exit_code, 0);
  EXPECT_EQ(bytes("r.html").find("<img"), std::string::npos);
  EXPECT_EQ(report().json["title"], "<img onerror=x>.obj");
}

TEST_F(HtmlReports, ThatCannotBeWrittenStopARunBeforeTheWork) {
  expect_nothing_done(smooth({"--report", "no/r.html"}), 3, "no/r.html: cannot be written");
  expect_nothing_done(smooth({"--report", "."}), 3, ".: is a folder");
  expect_nothing_done(smooth({"--report", "/proc/r.html"}), 3, "/proc/r.html");
  expect_nothing_done(smooth({"--report", "in.obj"}), 2, "--report in.obj would overwrite");
  expect_nothing_done(smooth({"--report", "./out.obj"}), 2, "--report ./out.obj would overwrite");
  expect_nothing_done(smooth({"--report", "r.html", "--json", "./r.html"}), 2, "are both");
  expect_nothing_done(smooth({"--report", "mesh.svg", "--plot", "."}), 2, "overwrite mesh.svg");
  expect_nothing_done(smooth({"--report", "r.html", "--dry-run"}), 2, "leave --report out");
  expect_nothing_done(smooth({"--report", "r.html", "--report-max-mb", "0"}), 2, "report-max-mb");
  expect_nothing_done(evenmesh({"check", "in.obj", "--report", "in.obj"}), 2, "would overwrite");
  expect_nothing_done(evenmesh({"check", "in.obj", "--report", "no/r.html"}), 3, "no/r.html");
  expect_nothing_done(evenmesh({"report", "in.obj", "in.obj", "-o", "in.obj"}), 2, "overwrite");
  expect_nothing_done(evenmesh({"report", "in.obj", "in.obj"}), 2, "output");
  EXPECT_EQ(bytes("in.obj"), testing::kCanImprove);
}

TEST_F(HtmlReports, LeaveNoTemporaryFileBehind) {
  ASSERT_EQ(smooth({"--report", "r.html"}).exit_code, 0);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_.path())) ++files;
  EXPECT_EQ(files, 4u);  // two inputs, the output and the report
}

TEST_F(HtmlReports, DoNotDependOnThreads) {
  testing::write_obj(shapes::triangle_grid(30, 1.0, 0.3), folder_.path() / "a.obj");
  testing::write_obj(shapes::triangle_grid(30, 1.0, 0.2), folder_.path() / "b.obj");
  const auto report_with = [this](const std::string& threads) {
    EXPECT_EQ(
        evenmesh({"report", "a.obj", "b.obj", "-o", "r.html", "--threads", threads}).exit_code, 0);
    return bytes("r.html");
  };
  std::string one = report_with("1");
  std::string two = report_with("2");
  for (std::size_t at = 0; (at = two.find("--threads 2", at)) != std::string::npos;)
    two[at + 10] = '1';
  EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace evenmesh
