// SPDX-License-Identifier: MIT
//
// The verb demo.
#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/cli/process.h"
#include "tests/io/temporary_folder.h"

namespace evenmesh {
namespace {

using testing::Outcome;
using testing::run;
using testing::TemporaryFolder;

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(Demo, ListNamesEveryFigureAndSaysWhichMeshesAreLookAlikes) {
  const Outcome outcome = run({"demo", "list"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* line : {"fig5b ", "fig13a ", "fig22b ", "fig30 "}) {
    EXPECT_EQ(count(outcome.out, std::string("\n") + line), 1u) << line;
  }
  std::istringstream in(outcome.out);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("fig13a")) {
      EXPECT_NE(line.find("(look-alike)"), std::string::npos);
    }
    if (line.starts_with("fig5b")) {
      EXPECT_EQ(line.find("(look-alike)"), std::string::npos);
    }
  }
}

TEST(Demo, AloneShowsTheThreeKnownOptimaWithTwoCosts) {
  const Outcome outcome = run({"demo"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(count(outcome.out, "\nevenmesh "), 6u) << outcome.out;
  EXPECT_EQ(count(outcome.out, "30 random starts"), 3u);
  EXPECT_NE(outcome.err.find("demo list"), std::string::npos) << outcome.err;
}

TEST(Demo, TakesSeveralFiguresEachOnce) {
  const Outcome outcome = run({"demo", "fig29", "fig5b", "fig31", "-q"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(count(outcome.out, "Fig. 5b"), 1u);
  EXPECT_EQ(count(outcome.out, "Fig. 29"), 1u);
  EXPECT_EQ(count(outcome.out, "Fig. 30"), 1u);
}

TEST(Demo, AnUnknownFigureIsAnsweredWithTheNearest) {
  for (const auto& [word, hint] : {std::pair{"fig33", "fig31"}, {"fig13c", "fig13"}}) {
    const Outcome outcome = run({"demo", word});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(std::string("did you mean ") + hint), std::string::npos)
        << outcome.err;
  }
}

TEST(Demo, WritesNoFilesUnlessAsked) {
  const TemporaryFolder folder;
  EXPECT_EQ(run({"demo", "fig5"}, {.folder = folder.path().string()}).exit_code, 0);
  EXPECT_EQ(folder.count_files(), 0u);
}

TEST(Demo, WritesPicturesOfTheMeshAndOfConvergence) {
  const TemporaryFolder folder;
  const auto into = folder.path() / "new" / "folder";
  const Outcome outcome = run({"demo", "fig13b", "-o", into.string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"fig13b.svg", "fig13b_convergence.svg"}) {
    EXPECT_EQ(count(content(into / name), "</svg>"), 1u) << name;
  }
}

TEST(Demo, AFolderThatCannotBeMadeOrWrittenIsAFileError) {
  const TemporaryFolder folder;
  const auto file = folder.write("file", "not a folder");
  for (const auto& into : {file, file / "below"}) {
    const Outcome outcome = run({"demo", "fig5b", "-o", into.string()});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find(file.string()), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(content(file), "not a folder");
}

TEST(Demo, AllWritesAPageWhosePicturesAreThere) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"demo", "all", "-q", "-o", folder.path().string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = content(folder.path() / "gallery.md");
  std::size_t pictures = 0;
  for (auto at = page.find("]("); at != std::string::npos; at = page.find("](", at + 1)) {
    const std::string link = page.substr(at + 2, page.find(')', at) - at - 2);
    EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / link)) << link;
    ++pictures;
  }
  EXPECT_GE(pictures, 40u);
}

}  // namespace
}  // namespace evenmesh
