// SPDX-License-Identifier: MIT
//
// The tangled planar and surface meshes of the corpus: untangled, or the report says which cells
// are not, and why.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "evenmesh/io/mesh_file.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/quality/quality.h"
#include "tests/cli/process.h"
#include "tests/cli/promise.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/places.h"

namespace evenmesh {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::corpus_dir;
using testing::Outcome;
using testing::read_bytes;
using testing::run;
using testing::TemporaryFolder;

constexpr std::size_t kNamed = 10;     // worst cells in a report
constexpr std::size_t kListed = 1000;  // inverted cells in a report

#ifdef EVENMESH_SANITIZED
constexpr std::uintmax_t kLargest = 100'000;  // bytes; the larger ones take minutes there
#else
constexpr std::uintmax_t kLargest = 100'000'000;
#endif

// These have come out without an inverted cell, and have to. The second's cells are not tangled
// but wound both ways.
const std::set<std::string> kUntangle = {"mfem__rt-2d-q3.mesh",  "tutorials__primitiveVenturi.su2",
                                         "no_flux_quad_s13.vtk", "lego_tri_s14.vtk",
                                         "naca_tri_s15.vtk",     "mfem__triple-pt-1.mesh"};

std::vector<fs::path> tangled_files() {
  std::vector<fs::path> files;
  for (const char* folder : {"tangled", "tangled_derived"}) {
    if (!fs::is_directory(corpus_dir() / folder)) continue;
    for (const auto& entry : fs::directory_iterator(corpus_dir() / folder)) {
      if (entry.is_regular_file() && entry.file_size() <= kLargest) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

// False if it is refused, as volume meshes are.
bool convert(const fs::path& from, const fs::path& to) {
  const std::string command = "python3 \"" + testing::source_dir().string() +
                              "/tools/corpus_to_obj.py\" \"" + from.string() + "\" \"" +
                              to.string() + "\" 2>/dev/null";
  return std::system(command.c_str()) == 0;
}

std::size_t count_inverted(const Mesh& mesh, const Orientation& orientation) {
  Workers workers(1);
  return summarize(workers, measure_cells(workers, mesh, mesh.points(), orientation)).inverted;
}

void expect_held(const json& cell) {
  EXPECT_FALSE(cell.at("held_by").empty()) << cell;
  for (const std::string reason : cell.at("held_by")) EXPECT_NE(reason, "") << cell;
}

// Inverted cells come first among the worst, and each has what holds it.
void expect_reasons(const json& report) {
  const std::size_t inverted = report["inverted_after"];
  const json& worst = report["worst"];
  ASSERT_GE(worst.size(), std::min(inverted, kNamed));
  for (std::size_t i = 0; i < std::min(inverted, kNamed); ++i) {
    EXPECT_EQ(worst[i]["inverted"], true) << worst[i];
    EXPECT_NE(worst[i]["cell"], "");
    expect_held(worst[i]);
  }
  const json& all = report["still_inverted"];
  EXPECT_EQ(all.size(), std::min(inverted, kListed));
  for (const json& cell : all) expect_held(cell);
}

void expect_written(const fs::path& in, const fs::path& out, const json& report) {
  testing::expect_promise(in, out);  // also that fixed vertices keep their bits
  const MeshFile before = read_mesh(in);
  const Orientation orientation = find_orientation(before.mesh);
  EXPECT_EQ(count_inverted(before.mesh, orientation), report["inverted_before"]);
  EXPECT_EQ(count_inverted(read_mesh(out).mesh, orientation), report["inverted_after"]);
}

void expect_untangled_or_reasons(const fs::path& in, const std::string& name) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out.obj";
  const fs::path file = folder.path() / "report.json";
  const Outcome outcome =
      run({in.string(), "-o", out.string(), "--json", file.string(), "--threads", "1"});
  ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 5)
      << outcome.exit_code << " " << outcome.signal << outcome.err;
  ASSERT_TRUE(json::accept(read_bytes(file))) << outcome.err;
  const json report = json::parse(read_bytes(file));
  EXPECT_EQ(report["exit_code"], outcome.exit_code);
  EXPECT_LE(report["inverted_after"], report["inverted_before"]);
  EXPECT_EQ(fs::exists(out), outcome.exit_code == 0);
  if (fs::exists(out)) expect_written(in, out, report);
  if (kUntangle.contains(name)) {
    EXPECT_EQ(report["inverted_after"], 0);
  }
  if (report["inverted_after"] > 0) expect_reasons(report);
}

TEST(Tangled, ComeOutUntangledOrWithTheCellsThatAreNotAndWhy) {
  if (tangled_files().empty()) GTEST_SKIP() << "there are no tangled meshes at " << corpus_dir();
  if (std::system("python3 -c '' 2>/dev/null") != 0) GTEST_SKIP() << "there is no python3";
  const TemporaryFolder folder;
  std::size_t converted = 0;
  for (const fs::path& path : tangled_files()) {
    SCOPED_TRACE(path.string());
    const fs::path mesh = folder.path() / (path.filename().string() + ".obj");
    if (!convert(path, mesh)) {
      EXPECT_FALSE(kUntangle.contains(path.filename().string()));
      continue;
    }
    ++converted;
    expect_untangled_or_reasons(mesh, path.filename().string());
  }
  EXPECT_GT(converted, 0u);
}

}  // namespace
}  // namespace evenmesh
