// SPDX-License-Identifier: MIT
//
// Constraints from the command line and from configuration files, and what a dry run says of them.
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/meshes.h"
#include "tests/cli/process.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing::Outcome;
using testing::read_bytes;
using testing::run;
using testing::TemporaryFolder;

class ConstraintOptions : public ::testing::Test {
 protected:
  ConstraintOptions() {
    testing::write_obj(shapes::quad_grid(4, 1.0, 0.2), folder_.path() / "in.obj");
  }

  Outcome start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "in.obj");
    return run(arguments, {.folder = folder_.path().string()});
  }
  Outcome dry_run(std::vector<std::string> arguments) {
    arguments.push_back("--dry-run");
    const std::size_t files = folder_.count_files();
    const Outcome outcome = start(arguments);
    EXPECT_EQ(folder_.count_files(), files);
    return outcome;
  }
  void expect_refused(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& parts) {
    const Outcome outcome = dry_run(arguments);
    const std::string shown = ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << shown << outcome.err;
    EXPECT_EQ(outcome.out, "") << shown;
    for (const std::string& part : parts) {
      EXPECT_NE(outcome.err.find(part), std::string::npos) << shown << outcome.err;
    }
  }
  void expect_shown(const Outcome& outcome, const std::vector<std::string>& parts) {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const std::string& part : parts) {
      EXPECT_NE(outcome.out.find(part), std::string::npos) << part << '\n' << outcome.out;
    }
  }

  TemporaryFolder folder_;
};

TEST_F(ConstraintOptions, AreShownByADryRun) {
  const Outcome outcome = dry_run({"--symmetry", "x=0", "--max-move", "0.2h"});
  expect_shown(
      outcome,
      {"# fixed              eliminated            4 vertices default (corners)\n",
       "# slide on line      eliminated           12 vertices default",
       "# symmetry           eliminated            5 vertices --symmetry x=0\n",
       "# max_move           inequality           25 vertices --max-move 0.2h\n",
       "# validity           inequality           16 cells    default", "\nsymmetry = [\"x=0\"]\n",
       "\nmax-move = \"0.2h\"\n", "\nfix = \"auto\"\n", "cost = \"shape=1\"\n"});
  EXPECT_NE(outcome.err.find("of 25 vertices 4 are fixed, 12 slide, 9 are free"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("dry run: nothing was written"), std::string::npos) << outcome.err;
}

TEST_F(ConstraintOptions, OfADryRunCanBeFedBack) {
  const Outcome first =
      dry_run({"--slide", "box:0,0,0,1,0,0 on line", "--slide", "id:6,11 on plane:x=0", "--fix",
               "corners", "--scale-free", "--iterations", "7", "--min-jacobian", "0.05"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  folder_.write("job.toml", first.out);
  const Outcome second = dry_run({"--config", "job.toml"});
  ASSERT_EQ(second.exit_code, 0) << second.err;
  // But for the command line in the first line.
  EXPECT_EQ(second.out.substr(second.out.find('\n')), first.out.substr(first.out.find('\n')));
  EXPECT_NE(first.out.find("slide = [\"box:0,0,0,1,0,0 on line\", \"id:6,11 on plane:x=0\"]\n"),
            std::string::npos)
      << first.out;
}

TEST_F(ConstraintOptions, OfADryRunNeedNoOutputAndNoReport) {
  EXPECT_EQ(dry_run({}).exit_code, 0);
  EXPECT_EQ(dry_run({"-o", "out.obj"}).exit_code, 0);
  expect_refused({"--json", "r.json"}, {"--dry-run writes nothing"});
}

TEST_F(ConstraintOptions, StandInTheReport) {
  const Outcome outcome =
      start({"-o", "out.obj", "--fix", "boundary+features+interface", "--json", "r.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(read_bytes(folder_.path() / "r.json"));
  EXPECT_EQ(report["schema_version"], "1.4");
  const auto& first = report["constraints"][0];
  EXPECT_EQ(first["kind"], "fixed");
  EXPECT_EQ(first["text"], "--fix boundary+features+interface");
  EXPECT_EQ(first["entry"], "eliminated");
  EXPECT_EQ(first["count"], 16);
  EXPECT_EQ(first["unit"], "vertices");
  EXPECT_EQ(report["options"]["fix"], "boundary+features+interface");
}

TEST_F(ConstraintOptions, ThatContradictEachOtherNameAVertexOfTheFile) {
  expect_refused({"--fix", "boundary", "--prescribe", "id:5 = 0,0.1,0"},
                 {"evenmesh: --fix boundary and --prescribe 'id:5 = 0,0.1,0' contradict each other",
                  "vertex 5 (line 5) is fixed, but would move by 0.1"});
  expect_refused({"--slide", "boundary on circle"}, {"do not say which circle", "(line "});
  expect_refused({"--fix", "group:wall"}, {"there is no group 'wall': the file has none"});
  expect_refused({"--max-move", "0"}, {"--max-move '0'", "positive number"});
  expect_refused({"--solver", "newtom"}, {"did you mean 'newton'?"});
  expect_refused({"--periodic", "x=0 x=1", "--slide", "all of plane"}, {"'on' is missing"});
  expect_refused({"--prescribe", "all = x,y,("}, {"--prescribe", "all = x,y,("});
}

TEST_F(ConstraintOptions, ByDefaultSayHowFarASurfaceMayBeLeftAndWhich) {
  testing::write_obj(shapes::cube_surface(4), folder_.path() / "in.obj");
  testing::write_obj(shapes::cube_surface(4), folder_.path() / "other.obj");
  for (const std::vector<std::string>& asked :
       {std::vector<std::string>{}, std::vector<std::string>{"--surface", "other.obj"}}) {
    const Outcome outcome = dry_run(asked);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    // As in the line of the constraint, between parentheses.
    const std::size_t begin = outcome.out.find('(', outcome.out.find("# max_deviation")) + 1;
    const std::string note = outcome.out.substr(begin, outcome.out.find(")\n", begin) - begin);
    EXPECT_TRUE(note.starts_with("at most ")) << note;
    EXPECT_NE(outcome.err.find("--max-deviation, by default: " + note + "\n"), std::string::npos)
        << outcome.err;
  }
  const std::string asked = dry_run({"--max-deviation", "1%"}).err;
  EXPECT_EQ(asked.find("--max-deviation"), std::string::npos) << asked;
}

TEST_F(ConstraintOptions, ReadOtherFiles) {
  testing::write_obj(shapes::quad_grid(4), folder_.path() / "even.obj");
  folder_.write("moves.csv", "id,dx,dy,dz\n3,0.01,0,0\n");
  expect_shown(dry_run({"--prescribe", "even.obj"}),
               {"# prescribed         eliminated            9 vertices"});
  expect_shown(dry_run({"--prescribe", "all = moves.csv"}),
               {"# prescribed         eliminated            1 vertices", "by 0.01 at most"});
  const Outcome missing = dry_run({"--prescribe", "missing.obj"});
  EXPECT_EQ(missing.exit_code, 3) << missing.err;
  EXPECT_NE(missing.err.find("missing.obj: cannot be opened"), std::string::npos) << missing.err;
}

// A grid whose boundary is folded over itself at one vertex and fixed: some cell stays inverted.
TEST_F(ConstraintOptions, ThatAreMetDoNotFailForACellThatStaysInverted) {
  Mesh folded = shapes::triangle_grid(4);
  std::vector<Vec3> points(folded.points().begin(), folded.points().end());
  points[2] = Vec3(0.5, 1.3, 0.0);
  folded.set_points(std::move(points));
  testing::write_obj(folded, folder_.path() / "in.obj");
  const auto code_of = [&](std::vector<std::string> asked) {
    const std::string shown = ::testing::PrintToString(asked);
    asked.insert(asked.end(),
                 {"-o", "out.obj", "--fix", "boundary", "--allow-worse", "--json", "r.json"});
    const Outcome outcome = start(asked);
    const auto report = nlohmann::json::parse(read_bytes(folder_.path() / "r.json"));
    EXPECT_GT(report["inverted_after"], 0) << shown;
    EXPECT_GT(report["unmet"], 0) << shown;
    EXPECT_EQ(report["exit_code"], outcome.exit_code) << shown;
    EXPECT_EQ(report["still_inverted"].size(), report["inverted_after"]) << shown;
    EXPECT_NE(outcome.err.find(" is too small or inverted"), std::string::npos) << outcome.err;
    return outcome.exit_code;
  };
  EXPECT_EQ(code_of({}), 0);
  EXPECT_EQ(code_of({"--max-move", "1"}), 0);
  EXPECT_EQ(code_of({"--limit", "all max-move 1"}), 0);
  EXPECT_EQ(code_of({"--keep", "area"}), 0);
  EXPECT_EQ(code_of({"--min-area", "0.001"}), 4);
  EXPECT_EQ(code_of({"--min-jacobian", "0.05"}), 4);
  EXPECT_EQ(code_of({"--min-jacobian", "0.05", "--max-move", "1"}), 4);
}

TEST_F(ConstraintOptions, ThatCannotBeMetFail) {
  const Outcome outcome = start({"-o", "out.obj", "--min-jacobian", "0.9999", "--allow-worse"});
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_NE(outcome.err.find("is too small or inverted; lower the demand"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("folded"), std::string::npos) << outcome.err;
}

TEST_F(ConstraintOptions, CarryPrescribedMovesToAllImages) {
  testing::write_obj(shapes::quad_grid(4), folder_.path() / "in.obj");
  const Outcome outcome = start({"--periodic", "x=0 x=1", "--periodic", "y=0 y=1", "--prescribe",
                                 "id:25 = 0.0625,0.03125,0", "-o", "out.obj"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string moved = read_bytes(folder_.path() / "out.obj");
  for (const char* corner : {"v 0.0625 0.03125 0\n", "v 1.0625 0.03125 0\n", "v 0.0625 1.03125 0\n",
                             "v 1.0625 1.03125 0\n"}) {
    EXPECT_NE(moved.find(corner), std::string::npos) << corner << moved;
  }
}

// ---- configuration files ------------------------------------------------------------------------

TEST_F(ConstraintOptions, ComeFromAFile) {
  folder_.write("job.toml",
                "# a comment\nfix = 'corners'\nslide = ['boundary on line']\nmax_move = 0.05\n"
                "min-jacobian = '0.1'\niterations = 5\nscale_free = true\ntolerance = 1\n"
                "[cost]\nlocal = 0.5\nbarycenter = 1\n");
  const Outcome outcome = dry_run({"--config", "job.toml", "--tolerance", "1e-3"});
  expect_shown(outcome, {"fix = \"corners\"\n", "slide = [\"boundary on line\"]\n",
                         "max-move = \"0.05\"\n", "min-jacobian = \"0.1\"\n", "iterations = 5\n",
                         "scale-free = true\n", "tolerance = 1e-3\n", "local=0.5", "barycenter=1"});
}

TEST_F(ConstraintOptions, FromTheCommandLineWinOverAFile) {
  folder_.write("job.toml", "fix = 'none'\niterations = 5\nsymmetry = ['y=0']\n");
  const Outcome outcome =
      dry_run({"--config", "job.toml", "--fix", "corners", "--symmetry", "x=0"});
  expect_shown(outcome, {"fix = \"corners\"\n", "iterations = 5\n", "symmetry = [\"x=0\"]\n"});
}

TEST_F(ConstraintOptions, FromAFileAreJudgedWithTheirPlaceInIt) {
  const auto expect = [&](const std::string& text, const std::string& message) {
    folder_.write("job.toml", text);
    expect_refused({"--config", "job.toml"}, {message});
  };
  expect("fix = 'corners'\nslid = ['x']\n",
         "job.toml:2:1: there is no option 'slid' (did you mean 'slide'?)");
  expect("max_mov = 1\n", "job.toml:1:1: there is no option 'max_mov' (did you mean 'max-move'?)");
  expect("config = 'job.toml'\n", "job.toml:1:1: there is no option 'config'");
  expect("iterations = 'many'\n", "job.toml:1:14: iterations takes a whole number");
  expect("iterations = 1.5\n", "iterations takes a whole number");
  expect("fix = 1\n", "job.toml:1:7: fix takes a string");
  expect("slide = [1]\n", "slide takes a string or an array of strings");
  expect("scale-free = 'yes'\n", "scale-free takes true or false");
  expect("cost = 1\n", "cost takes a string or a table of weights");
  expect("[cost]\nlocal = 'much'\n", "cost takes a string or a table of weights");
  expect("[slide]\na = 1\n", "slide takes a string or an array");
  expect("fix = \n", "job.toml:1:");
  expect("fix = 'a'\nfix = 'b'\n", "job.toml:2:");
  const Outcome verb = run({"--config", "none.toml", "check", "in.obj"});
  EXPECT_EQ(verb.exit_code, 2);
  EXPECT_NE(verb.err.find("'--config' before check has no meaning"), std::string::npos) << verb.err;
  const Outcome missing = dry_run({"--config", "none.toml"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_NE(missing.err.find("none.toml: cannot be read"), std::string::npos) << missing.err;
}

TEST_F(ConstraintOptions, HoldWallLayersUntilToldOtherwise) {
  Mesh mesh = shapes::quad_grid(6, 1.0, 0.15);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double row = static_cast<double>(v / 7);
    if (row < 4) points[v] = Vec3(static_cast<double>(v % 7) / 6, 0.005 * (std::exp2(row) - 1), 0);
  }
  mesh.set_points(std::move(points));
  testing::write_obj(mesh, folder_.path() / "in.obj");
  const Outcome held = start({"-o", "held.obj"});
  EXPECT_EQ(held.exit_code, 0) << held.err;
  EXPECT_NE(held.err.find("found wall layers, 18 cells; they stay as they are"), std::string::npos)
      << held.err;
  const std::string before = read_bytes(folder_.path() / "in.obj");
  const std::string after = read_bytes(folder_.path() / "held.obj");
  std::size_t end = 0;
  for (int line = 0; line < 28; ++line) end = before.find('\n', end) + 1;
  EXPECT_EQ(after.substr(0, end), before.substr(0, end));
  EXPECT_NE(after, before);
  const Outcome smoothed = start({"-o", "smoothed.obj", "--wall-layers", "smooth"});
  EXPECT_EQ(smoothed.err.find("wall layers"), std::string::npos) << smoothed.err;
  expect_refused({"--wall-layers", "thick"}, {"--wall-layers 'thick'", "hold and smooth"});
}

TEST_F(ConstraintOptions, MissingATargetIsExitCode4) {
  testing::write_obj(shapes::irregular_triangles(200, 0.4), folder_.path() / "in.obj");
  EXPECT_EQ(start({"-o", "out.obj", "--target", "shape>=0.3"}).exit_code, 0);
  const Outcome missed = start({"-o", "missed.obj", "--target", "shape>=0.99"});
  EXPECT_EQ(missed.exit_code, 4) << missed.err;
  EXPECT_NE(missed.err.find("below the target shape>=0.99, the first: "), std::string::npos)
      << missed.err;
  EXPECT_NE(read_bytes(folder_.path() / "missed.obj"), "");
  expect_refused({"--target", "shape=0.3"}, {"--target 'shape=0.3'", "shape>=X"});
  expect_refused({"--target", "shape>=0.3", "--method", "laplacian"}, {"--target needs"});
}

TEST_F(ConstraintOptions, OnlyFailingLeavesTheRest) {
  Mesh mesh = shapes::quad_grid(10, 1.0, 0.1);
  std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
  points[2 * 11 + 2] += Vec3(0.06, 0.06, 0.0);
  mesh.set_points(std::move(points));
  testing::write_obj(mesh, folder_.path() / "in.obj");
  const Outcome outcome =
      start({"-o", "out.obj", "--target", "shape>=0.8", "--only-failing", "--layers", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string before = read_bytes(folder_.path() / "in.obj");
  const std::string after = read_bytes(folder_.path() / "out.obj");
  EXPECT_NE(after, before);
  const auto upper = [](const std::string& text) {  // rows from the sixth on
    std::size_t at = 0;
    for (int line = 0; line < 55; ++line) at = text.find('\n', at) + 1;
    return text.substr(at);
  };
  EXPECT_EQ(upper(after), upper(before));
  testing::write_obj(shapes::quad_grid(10, 1.0, 0.1), folder_.path() / "in.obj");
  const Outcome nothing = start({"-o", "same.obj", "--target", "shape>=0.1", "--only-failing"});
  EXPECT_EQ(nothing.exit_code, 0) << nothing.err;
  EXPECT_NE(nothing.err.find("near a cell below shape>=0.1"), std::string::npos) << nothing.err;
  EXPECT_EQ(read_bytes(folder_.path() / "same.obj"), read_bytes(folder_.path() / "in.obj"));
  expect_refused({"--only-failing"}, {"--only-failing needs a --target"});
  expect_refused({"--target", "shape>=0.5", "--only-failing", "--layers", "-1"}, {"--layers"});
}

}  // namespace
}  // namespace evenmesh
