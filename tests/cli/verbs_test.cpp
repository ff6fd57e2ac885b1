// SPDX-License-Identifier: MIT
//
// --help, --version, check and info.
#include <sstream>

#include <gtest/gtest.h>

#include "evenmesh/base/version.h"
#include "tests/cli/meshes.h"
#include "tests/cli/process.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing::Outcome;
using testing::run;
using testing::TemporaryFolder;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

TEST(Help, StartsWithThreeExamplesAndListsExitCodes) {
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  const std::vector<std::string> shown = lines(help.out);
  ASSERT_GT(shown.size(), 4u);
  EXPECT_EQ(shown[0], "Examples:");
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_TRUE(shown[i].starts_with("  evenmesh ")) << shown[i];
  for (const char* code :
       {"0 done", "1 internal error", "2 wrong usage", "3 a file", "4 check found",
        "a demand is not met", "5 refused", "130 interrupted"}) {
    EXPECT_NE(help.out.find(code), std::string::npos) << code;
  }
  for (const char* option : {"--output", "--in-place", "--cost", "--fix", "--iterations",
                             "--tolerance", "--time-limit", "--threads", "--quiet", "--json"}) {
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  }
}

TEST(Help, TellsWhichOptionsMayBeRepeated) {
  const Outcome help = run({"--help"});
  std::size_t repeatable = 0;
  for (const std::string& line : lines(help.out)) {
    EXPECT_EQ(line.find("..."), std::string::npos) << line;  // each use takes one value
    if (line.find("TEXT (repeatable)") != std::string::npos) ++repeatable;
  }
  EXPECT_EQ(repeatable, 8u) << help.out;
}

TEST(Help, GivesTheVersion) {
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out, std::string("evenmesh ") + kVersion + "\n");
}

TEST(Check, AcceptsAGoodMesh) {
  const TemporaryFolder folder;
  const auto path = folder.write("good.obj", testing::kCanImprove);
  const Outcome outcome = run({"check", path.string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("inverted cells               0"), std::string::npos) << outcome.out;
  EXPECT_EQ(folder.count_files(), 1u);
}

TEST(Check, ReportsAnInvertedCellByItsNameInTheFile) {
  const TemporaryFolder folder;
  // The middle vertex of a square of four triangles pulled out over its lower edge.
  const auto path = folder.write("bad.obj",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 -0.25 0\n"
                                 "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  const Outcome outcome = run({"check", path.string()});
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_NE(outcome.err.find("1 inverted"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("face 1 (line 6)"), std::string::npos) << outcome.out;
}

TEST(Check, ReportsAHexThatIsInvertedOnlyBetweenItsCorners) {
  const TemporaryFolder folder;
  const auto path = folder.write("folded.mesh",
                                 "MeshVersionFormatted 2\nDimension 3\nVertices\n8\n"
                                 "-5 -2 6 0\n5 6 -6 0\n13 3 5 0\n3 5 5 0\n"
                                 "-2 -5 12 0\n15 -1 4 0\n5 3 10 0\n-5 12 9 0\n"
                                 "Hexahedra\n1\n1 2 3 4 5 6 7 8 0\nEnd\n");
  const Outcome outcome = run({"check", path.string()});
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_NE(outcome.err.find("1 cell is inverted or without a positive shape (1 inverted)"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.out.find("hex, inverted"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("0.0000"), std::string::npos) << outcome.out;  // shape
}

TEST(Info, PrintsCountsThatAreRight) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "cube.obj";
  testing::write_obj(shapes::cube_surface(2), path);
  const Outcome outcome = run({"info", path.string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* line :
       {"format          obj\n", "type            surface\n", "vertices        26 (0 in no cell)\n",
        "cells           24 quads\n", "box             (0, 0, 0) to (1, 1, 1)\n",
        "components      1\n", "boundary        0 edges, 0 vertices\n",
        "features        24 edges, 20 vertices\n", "corners         8 vertices\n"}) {
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << outcome.out;
  }
}

}  // namespace
}  // namespace evenmesh
