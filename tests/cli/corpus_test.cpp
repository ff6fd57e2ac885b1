// SPDX-License-Identifier: MIT
//
// Every file of the corpus that may be in a format that is read, from file to file: no worse, or
// refused with a reason.
#include <algorithm>
#include <array>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "evenmesh/base/error.h"
#include "evenmesh/io/mesh_file.h"
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

#ifdef EVENMESH_SANITIZED
constexpr std::uintmax_t kLargest = 1'500'000;  // bytes; the larger ones take minutes there
#else
constexpr std::uintmax_t kLargest = 100'000'000;
#endif

// Some volumes take a minute for 60, and what happens to a file does not hang on how often vertices
// move.
std::string iterations_for(const fs::path& path) {
  std::string suffix = path.extension().string();
  std::ranges::transform(suffix, suffix.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".obj" || suffix == ".stl") return "60";
#ifdef EVENMESH_SANITIZED
  return "3";
#else
  return "10";
#endif
}

std::vector<fs::path> corpus_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(corpus_dir())) {
    std::string suffix = entry.path().extension().string();
    std::ranges::transform(suffix, suffix.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array<std::string_view, 13> kSuffixes = {
        ".obj",  ".stl",   ".off", ".msh", ".ply", ".inp", ".su2",
        ".mesh", ".meshb", ".vtk", ".vtu", ".bdf", ".g"};
    if (!entry.is_regular_file() || std::ranges::find(kSuffixes, suffix) == kSuffixes.end())
      continue;
    if (entry.file_size() <= kLargest) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool is_readable(const fs::path& path) {
  try {
    read_mesh(path);
    return true;
  } catch (const IoError&) {
    return false;
  }
}

// The one line that says what is wrong; empty if there is none or more than one.
std::string complaint(const std::string& err) {
  std::string found;
  for (std::size_t at = 0; at < err.size();) {
    const std::size_t end = std::min(err.find('\n', at), err.size());
    const std::string line = err.substr(at, end - at);
    at = end + 1;
    if (!line.starts_with("evenmesh: ") && !line.starts_with("refused: ")) continue;
    if (!found.empty()) return "";
    found = line;
  }
  return found;
}

void expect_report_of_success(const json& report) {
  EXPECT_EQ(report["status"], "ok");
  EXPECT_LE(report["inverted_after"], report["inverted_before"]);
  const json& before = report["quality"]["before"]["shape"];
  const json& after = report["quality"]["after"]["shape"];
  EXPECT_GE(after["min"], before["min"]);
  EXPECT_GE(after["mean"], before["mean"]);
}

void expect_clean_run(const fs::path& path) {
  SCOPED_TRACE(path.string());
  const TemporaryFolder folder;
  const fs::path out = folder.path() / ("out" + path.extension().string());
  const fs::path report = folder.path() / "report.json";
  const Outcome outcome = run({path.string(), "-o", out.string(), "--iterations",
                               iterations_for(path), "--json", report.string(), "--threads", "1"});
  ASSERT_FALSE(outcome.timed_out);
  ASSERT_EQ(outcome.signal, 0) << outcome.err;
  ASSERT_TRUE(json::accept(read_bytes(report))) << outcome.err;
  const json content = json::parse(read_bytes(report));
  EXPECT_EQ(content["exit_code"], outcome.exit_code);
  if (!is_readable(path)) {
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  }
  if (outcome.exit_code == 0) {
    EXPECT_EQ(complaint(outcome.err), "");
    expect_report_of_success(content);
    testing::expect_promise(path, out);
    EXPECT_EQ(folder.count_files(), 2u);
    return;
  }
  EXPECT_TRUE(outcome.exit_code == 2 || outcome.exit_code == 3 || outcome.exit_code == 5)
      << outcome.exit_code << outcome.err;
  EXPECT_EQ(outcome.exit_code == 3, !is_readable(path)) << outcome.err;
  EXPECT_NE(complaint(outcome.err).find(path.string()), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count_files(), 1u);  // the report
}

TEST(Corpus, ComesOutNoWorseOrIsRefusedWithAReason) {
  if (!fs::is_directory(corpus_dir())) GTEST_SKIP() << "there is no corpus at " << corpus_dir();
  for (const fs::path& path : corpus_files()) expect_clean_run(path);
}

}  // namespace
}  // namespace evenmesh
