// SPDX-License-Identifier: MIT
//
// What a run does to files: the output, what was there before, and the input.
#include <array>
#include <map>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "evenmesh/classic/method.h"
#include "evenmesh/io/mesh_file.h"
#include "tests/cli/meshes.h"
#include "tests/cli/process.h"
#include "tests/cli/promise.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/places.h"

namespace evenmesh {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::Outcome;
using testing::read_bytes;
using testing::run;
using testing::TemporaryFolder;

const fs::path kData = testing::data_dir();

class Files : public ::testing::Test {
 protected:
  std::string at(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string bytes(const std::string& name) const { return read_bytes(folder_.path() / name); }
  std::string out() const { return at("out.obj"); }

  TemporaryFolder folder_;
};

TEST_F(Files, OfTheDataFolderKeepThePromise) {
  for (const char* name : {"cubespikes.obj", "hele_shaw.obj", "plate_ascii.stl", "plate_binary.stl",
                           "soccerball.obj"}) {
    const std::string target = at(std::string("out") + fs::path(name).extension().string());
    const Outcome outcome = run({(kData / name).string(), "-o", target, "-q"});
    ASSERT_EQ(outcome.exit_code, 0) << name << outcome.err;
    testing::expect_promise(kData / name, target);
  }
}

TEST_F(Files, OfEveryMethodKeepThePromise) {
  for (const std::string_view method : method_names()) {
    const std::string word(method);
    const Outcome outcome = run({(kData / "hele_shaw.obj").string(), "-o", out(), "-q", "--method",
                                 word, "--iterations", "10", "--json", at("report.json")});
    ASSERT_EQ(outcome.exit_code, 0) << method << outcome.err;
    testing::expect_promise(kData / "hele_shaw.obj", out());
    const json report = json::parse(bytes("report.json"));
    EXPECT_EQ(report["method"], word);
    EXPECT_EQ(report["options"]["method"], word);
    EXPECT_EQ(report["inverted_after"], 0) << method;
  }
}

/// Quads so far from the origin that floats are a quarter apart, and some of them not wider than
/// that; the vertices within are displaced along them.
std::string coarse_points() {
  constexpr std::array kColumns = {0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5,
                                   2.0, 3.0,  4.0, 6.0,  8.0, 12.0};
  std::string text;
  unsigned noise = 1;
  for (int j = 0; j <= 12; ++j) {
    for (int i = 0; i <= 12; ++i) {
      const bool within = i > 0 && j > 0 && i < 12 && j < 12;
      noise = noise * 1103515245U + 12345U;
      const int quarters = within ? static_cast<int>((noise >> 16U) % 3U) - 1 : 0;
      text += fmt::format("{:.2f} {:.2f} 0\n", 4.0e6 + kColumns[static_cast<std::size_t>(i)],
                          4.0e6 + j + 0.25 * quarters);
    }
  }
  return text;
}

std::string coarse_quads(int base) {
  std::string text;
  for (int j = 0; j < 12; ++j) {
    for (int i = 0; i < 12; ++i) {
      const int a = 13 * j + i + base;
      text += fmt::format("4 {} {} {} {}\n", a, a + 1, a + 14, a + 13);
    }
  }
  return text;
}

TEST_F(Files, OfCoarseNumbersInvertNothingByRounding) {
  std::string types;
  for (int i = 0; i < 144; ++i) types += "9\n";
  const std::map<std::string, std::string> files = {
      {"coarse.ply",
       "ply\nformat ascii 1.0\nelement vertex 169\nproperty float x\nproperty float y\nproperty "
       "float "
       "z\nelement face 144\nproperty list uchar int vertex_indices\nend_header\n" +
           coarse_points() + coarse_quads(0)},
      {"coarse.vtk",
       "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 169 float\n" +
           coarse_points() + "CELLS 144 720\n" + coarse_quads(0) + "CELL_TYPES 144\n" + types}};
  for (const auto& [name, content] : files) {
    folder_.write(name, content);
    const std::string target = at("out_" + name);
    const Outcome outcome = run({at(name), "-o", target});
    ASSERT_EQ(outcome.exit_code, 0) << name << outcome.err;
    testing::expect_promise(at(name), target);
    const MeshFile written = read_mesh(target);
    for (const Vec3& point : written.mesh.points()) {
      EXPECT_EQ(point.x(), static_cast<double>(static_cast<float>(point.x())));
    }
    EXPECT_NE(bytes("out_" + name), content) << outcome.err;

    // As doubles the columns would be narrower and apart, as floats they fall together.
    fs::remove(target);
    const Outcome narrowed =
        run({at(name), "-o", target, "--prescribe", "boundary = (4000000 - x) * 0.45, 0, 0"});
    EXPECT_EQ(narrowed.exit_code, 5) << narrowed.err;
    EXPECT_NE(narrowed.err.find("in the file as read back, "), std::string::npos) << narrowed.err;
    EXPECT_FALSE(fs::exists(target));
  }
}

TEST_F(Files, SayThatAClassicMethodDoesNotMinimiseTheCost) {
  const Outcome outcome = run({(kData / "hele_shaw.obj").string(), "-o", out(), "--method",
                               "laplacian", "--cost", "global", "--iterations", "3"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("--method laplacian does not minimise --cost"), std::string::npos);
  EXPECT_NE(outcome.err.find("stopped at the limit of 3 iterations, vertices still moving by"),
            std::string::npos)
      << outcome.err;
}

TEST_F(Files, SoccerballImproves) {
  const Outcome outcome = run({(kData / "soccerball.obj").string(), "-o", out(), "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json quality = json::parse(outcome.out)["quality"];
  EXPECT_GT(quality["after"]["shape"]["mean"], quality["before"]["shape"]["mean"]);
}

// The lines of the output that are not those of the input.
std::vector<std::string> changed_lines(const std::string& before, const std::string& after) {
  std::istringstream a(before);
  std::istringstream b(after);
  std::vector<std::string> changed;
  for (std::string x, y; std::getline(a, x) && std::getline(b, y);) {
    if (x != y) changed.push_back(y);
  }
  return changed;
}

TEST_F(Files, DifferInLinesOfVerticesOnly) {
  const fs::path in = kData / "soccerball.obj";
  ASSERT_EQ(run({in.string(), "-o", out(), "-q"}).exit_code, 0);
  const std::vector<std::string> changed = changed_lines(read_bytes(in), bytes("out.obj"));
  EXPECT_FALSE(changed.empty());
  for (const std::string& line : changed) EXPECT_TRUE(line.starts_with("v ")) << line;
}

TEST_F(Files, KeepInterfacesBetweenGroupsAndCommentsBehindCoordinates) {
  // Two groups meet in the middle column, whose inner vertex is not evenly placed.
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1.25 0\nv 2 1 0\nv 0 2 0\nv 1 2 0\nv 2 2 0\n"
      "v 0.2 0.4 0 # inner\n"
      "g left\nf 1 2 10\nf 2 5 10\nf 5 4 10\nf 4 1 10\nf 4 5 8 7\n"
      "g right\nf 2 3 6 5\nf 5 6 9 8\n";
  folder_.write("in.obj", text);
  const Outcome outcome = run({at("in.obj"), "-o", out(), "--fix", "boundary+features+interface"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> changed = changed_lines(text, bytes("out.obj"));
  ASSERT_EQ(changed.size(), 1u);
  EXPECT_TRUE(changed[0].ends_with(" # inner")) << changed[0];
}

TEST_F(Files, InPlaceReplacesTheInput) {
  folder_.write("in.obj", testing::kCanImprove);
  ASSERT_EQ(run({at("in.obj"), "-o", out(), "-q"}).exit_code, 0);
  ASSERT_EQ(run({at("in.obj"), "--in-place", "-q"}).exit_code, 0);
  EXPECT_NE(bytes("in.obj"), testing::kCanImprove);
  EXPECT_EQ(bytes("in.obj"), bytes("out.obj"));
  EXPECT_EQ(folder_.count_files(), 2u);
}

TEST_F(Files, InPlaceIsARenameSoThatReadersNeverSeeHalfAFile) {
  folder_.write("in.obj", testing::kCanImprove);
  std::ifstream reader(at("in.obj"));
  ASSERT_EQ(run({at("in.obj"), "--in-place", "-q"}).exit_code, 0);
  const std::string seen{std::istreambuf_iterator<char>(reader), std::istreambuf_iterator<char>()};
  EXPECT_EQ(seen, testing::kCanImprove);
}

TEST_F(Files, InPlaceFollowsALinkAndLeavesIt) {
  folder_.write("in.obj", testing::kCanImprove);
  fs::create_symlink("in.obj", at("link.obj"));
  ASSERT_EQ(run({at("link.obj"), "--in-place", "-q"}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(at("link.obj")));
  EXPECT_NE(bytes("in.obj"), testing::kCanImprove);
}

TEST_F(Files, ThereBeforeAreReplacedOnSuccess) {
  folder_.write("in.obj", testing::kCanImprove);
  folder_.write("out.obj", "old");
  ASSERT_EQ(run({at("in.obj"), "-o", out(), "-q"}).exit_code, 0);
  testing::expect_promise(at("in.obj"), out());
}

TEST_F(Files, ThereBeforeStayWhenTheMeshCannotBeImproved) {
  folder_.write("in.obj", testing::kCannotImprove);
  folder_.write("out.obj", "old");
  const Outcome outcome =
      run({at("in.obj"), "-o", out(), "--cost", "local", "--json", at("report.json")});
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  EXPECT_NE(outcome.err.find("refused: " + at("in.obj")), std::string::npos) << outcome.err;
  EXPECT_EQ(bytes("out.obj"), "old");
  EXPECT_EQ(folder_.count_files(), 3u);
  const json report = json::parse(bytes("report.json"));
  EXPECT_EQ(report["status"], "refused");
  EXPECT_EQ(report["promise"], "unimproved");
  EXPECT_TRUE(report["output"].is_null());
}

TEST_F(Files, InPlaceStaysWhenTheMeshCannotBeImproved) {
  folder_.write("in.obj", testing::kCannotImprove);
  EXPECT_EQ(run({at("in.obj"), "--in-place", "-q", "--cost", "local"}).exit_code, 5);
  EXPECT_EQ(bytes("in.obj"), testing::kCannotImprove);
}

TEST_F(Files, AllowWorseWritesWhatIsRefusedOtherwise) {
  folder_.write("in.obj", testing::kCannotImprove);
  EXPECT_EQ(run({at("in.obj"), "-o", out(), "-q", "--cost", "local", "--allow-worse"}).exit_code,
            0);
  EXPECT_NE(bytes("out.obj"), testing::kCannotImprove);
}

TEST_F(Files, ThereBeforeStayOnFailure) {
  folder_.write("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  folder_.write("out.obj", "old");
  const Outcome outcome = run({at("in.obj"), "-o", out()});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find(at("in.obj") + ":4:"), std::string::npos) << outcome.err;
  EXPECT_EQ(bytes("out.obj"), "old");
  EXPECT_EQ(folder_.count_files(), 2u);
}

// Two by two quads of second order with a displaced centre, a support and a load.
const std::string kDeck =
    "*HEADING\nplate\n*NODE, NSET=ALL\n1,0,0,0\n2,1,0,0\n3,2,0,0\n4,0,1,0\n5,1.4,1.3,0\n6,2,1,0\n"
    "7,0,2,0\n8,1,2,0\n9,2,2,0\n11,0.5,0,0\n12,1.5,0,0\n13,0.7,1.15,0\n14,1.7,1.15,0\n15,0.5,2,0\n"
    "16,1.5,2,0\n21,0,0.5,0\n22,0,1.5,0\n23,1.2,0.65,0\n24,1.2,1.65,0\n25,2,0.5,0\n26,2,1.5,0\n"
    "*ELEMENT, TYPE=S8R, ELSET=PLATE\n1, 1,2,5,4, 11,23,13,21\n2, 2,3,6,5, 12,25,14,23\n"
    "3, 4,5,8,7, 13,24,15,22\n4, 5,6,9,8, 14,26,16,24\n*NSET, NSET=LOADED\n8\n"
    "*SHELL SECTION, ELSET=PLATE, MATERIAL=STEEL\n0.1\n*BOUNDARY\n2, 1, 3\n*STEP\n*STATIC\n"
    "*CLOAD\nLOADED, 2, -1.\n*END STEP\n";

TEST_F(Files, DecksOfSecondOrderKeepTheirLoadsAndTakeTheMiddlesOfEdgesAlong) {
  folder_.write("in.inp", kDeck);
  const Outcome outcome = run({at("in.inp"), "-o", at("out.inp"), "--json", at("report.json")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const MeshFile before = read_mesh(at("in.inp"));
  const MeshFile after = read_mesh(at("out.inp"));
  const Points points = after.mesh.points();
  EXPECT_NEAR((points[4] - Vec3(1, 1, 0)).norm(), 0.0, 1e-3);
  for (const Index v : {1u, 7u}) EXPECT_EQ(points[v], before.mesh.points()[v]);  // held
  for (std::size_t i = 0; i < after.followers.size(); ++i) {
    const auto ends = after.followers.leaders(i);
    const Vec3 middle = 0.5 * (points[ends[0]] + points[ends[1]]);
    EXPECT_NEAR((points[after.followers.vertex(i)] - middle).norm(), 0.0, 1e-12);
  }
  EXPECT_EQ(bytes("out.inp").substr(bytes("out.inp").find("*ELEMENT")),
            kDeck.substr(kDeck.find("*ELEMENT")));
  const json report = json::parse(bytes("report.json"));
  EXPECT_EQ(report["input"]["format"], "inp");
}

/// Six triangles of second order around a vertex; the two edges at the bottom are bent up by
/// `bend`.
std::string bent_below(double bend) {
  const std::vector<std::array<int, 3>> triangles = {{0, 1, 6}, {1, 2, 6}, {2, 5, 6},
                                                     {5, 4, 6}, {4, 3, 6}, {3, 0, 6}};
  std::vector<std::pair<double, double>> points = {{0, 0}, {1, 0}, {2, 0},  {0, 2},
                                                   {1, 2}, {2, 2}, {1, 1.6}};
  std::map<std::pair<int, int>, std::size_t> middles;
  std::string cells;
  for (const auto& corners : triangles) {
    cells += fmt::format("6 {} {} {}", corners[0], corners[1], corners[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = std::minmax(corners[k], corners[(k + 1) % 3]);
      const auto [at, is_new] = middles.emplace(edge, points.size());
      const auto a = points[static_cast<std::size_t>(edge.first)];
      const auto b = points[static_cast<std::size_t>(edge.second)];
      const double up = a.second == 0 && b.second == 0 ? bend : 0.0;
      if (is_new) points.emplace_back((a.first + b.first) / 2, (a.second + b.second) / 2 + up);
      cells += fmt::format(" {}", at->second);
    }
    cells += "\n";
  }
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n",
      points.size());
  for (const auto& [x, y] : points) text += fmt::format("{} {} 0\n", x, y);
  return text + "CELLS 6 42\n" + cells + "CELL_TYPES 6\n22 22 22 22 22 22\n";
}

TEST_F(Files, OfSecondOrderAreNotFoldedBetweenTheirCorners) {
  // A triangle of height h over an edge bent by b is inverted at its ends where h < 4 b.
  for (const double bend : {0.0, 0.35}) {
    folder_.write("bent.vtk", bent_below(bend));
    const Outcome outcome = run({at("bent.vtk"), "-o", at("out.vtk"), "--fix", "boundary"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const double height = read_mesh(at("out.vtk")).mesh.points()[6].y();
    if (bend == 0.0) {
      EXPECT_LT(height, 1.2);
    } else {
      EXPECT_GT(height, 4 * bend);
      EXPECT_LT(height, 1.6);
    }
    EXPECT_EQ(run({"check", at("out.vtk")}).exit_code, 0);
  }
  folder_.write("bent.vtk", bent_below(0.5));
  const Outcome folded = run({"check", at("bent.vtk")});
  EXPECT_EQ(folded.exit_code, 4);
  EXPECT_NE(folded.err.find("2 cells of second order are inverted by the nodes between the "
                            "corners, cell 0 (line 26) first"),
            std::string::npos)
      << folded.err;
}

TEST_F(Files, NamesThatPromiseAnotherFormatAreRefusedBeforeTheWork) {
  folder_.write("in.inp", kDeck);
  for (const char* name : {"out.obj", "out.inp.gz"}) {
    const Outcome outcome = run({at("in.inp"), "-o", at(name)});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_EQ(outcome.err.find("planar mesh"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(folder_.count_files(), 1u);
}

TEST_F(Files, SetsOfADeckAreSelectorsAndNearNamesAreSuggested) {
  folder_.write("in.inp", kDeck);
  const Outcome fixed =
      run({at("in.inp"), "-o", at("out.inp"), "--fix", "nset:all", "--json", at("report.json")});
  EXPECT_EQ(fixed.exit_code, 0) << fixed.err;
  EXPECT_EQ(bytes("out.inp"), kDeck);
  const Outcome wrong = run({at("in.inp"), "-o", at("b.inp"), "--fix", "nset:LAODED"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("there is no nset 'LAODED' (did you mean 'LOADED'?)"), std::string::npos)
      << wrong.err;
  const Outcome info = run({"info", at("in.inp")});
  EXPECT_NE(info.out.find("nset            LOADED: 1 vertex"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("held            2 vertices"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("second order    12 of these"), std::string::npos) << info.out;
}

TEST_F(Files, WithNothingToMoveComeOutByteForByteAndSayWhy) {
  folder_.write("in.obj", testing::kCube);
  const Outcome outcome = run({at("in.obj"), "-o", out(), "--json", at("report.json")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(bytes("out.obj"), testing::kCube);
  EXPECT_NE(outcome.err.find("nothing may move: every vertex is fixed (--fix auto)"),
            std::string::npos)
      << outcome.err;
  const json report = json::parse(bytes("report.json"));
  EXPECT_EQ(report["stop_reason"], "nothing_to_move");
  EXPECT_EQ(report["geometry"]["moved"], 0);
  EXPECT_EQ(report["worst"].size(), 6u);
}

TEST_F(Files, AreTheSameForAnyNumberOfThreadsAndInEveryRun) {
  const std::string in = (kData / "hele_shaw.obj").string();
  const std::array<std::string, 4> threads{"1", "1", "2", "7"};
  std::string first;
  for (const std::string& count : threads) {
    ASSERT_EQ(run({in, "-o", out(), "-q", "--threads", count}).exit_code, 0);
    if (first.empty()) first = bytes("out.obj");
    EXPECT_TRUE(bytes("out.obj") == first) << count << " threads";
  }
}

TEST_F(Files, MayHaveAnyName) {
  const std::string in = "a b'c\"\xC3\xA4 $x.obj";
  folder_.write(in, testing::kCanImprove);
  const std::string target = "out \xE2\x86\x92 ;.obj";
  const Outcome outcome = run({in, "-o", target, "--json", "-"}, {.folder = at("")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  testing::expect_promise(at(in), at(target));
  EXPECT_EQ(json::parse(outcome.out)["command"],
            "evenmesh 'a b'\\''c\"\xC3\xA4 $x.obj' -o '" + target + "' --json -");
}

TEST_F(Files, MayHaveNamesThatAreNotUtf8) {
  const std::string in = "latin-\xE4.obj";
  folder_.write(in, testing::kCanImprove);
  const Outcome outcome = run({in, "-o", "out.obj", "--json", "-"}, {.folder = at("")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["input"]["file"], "latin-\xEF\xBF\xBD.obj");
}

TEST_F(Files, ReadOnlyOnesAreReadAndNotReplaced) {
  folder_.write("in.obj", testing::kCanImprove);
  fs::permissions(at("in.obj"), fs::perms::owner_read);
  EXPECT_EQ(run({at("in.obj"), "-o", out(), "-q"}).exit_code, 0);
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  EXPECT_EQ(run({at("in.obj"), "--in-place", "-q"}).exit_code, 3);
  EXPECT_EQ(bytes("in.obj"), testing::kCanImprove);
}

}  // namespace
}  // namespace evenmesh
