// SPDX-License-Identifier: MIT
//
// Pictures of a run: what is written when, and what stops a run before it begins.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/meshes.h"
#include "tests/cli/process.h"
#include "tests/io/temporary_folder.h"

namespace evenmesh {
namespace {

namespace fs = std::filesystem;
using testing::Outcome;
using testing::read_bytes;
using testing::run;

class Plots : public ::testing::Test {
 protected:
  Plots() {
    folder_.write("in.obj", testing::kCanImprove);
    folder_.write("good.obj", testing::kCannotImprove);
  }

  Outcome smooth(std::vector<std::string> more, const std::string& in = "in.obj") const {
    more.insert(more.begin(), {in, "-o", "out.obj"});
    return run(more, {.folder = folder_.path().string()});
  }
  std::string bytes(const std::string& name) const { return read_bytes(folder_.path() / name); }
  bool exists(const std::string& name) const { return fs::exists(folder_.path() / name); }

  void expect_pictures(const std::string& in) const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_.path() / in)) {
      const std::string text = read_bytes(entry.path());
      EXPECT_TRUE(text.starts_with("<svg xmlns=")) << entry.path();
      EXPECT_TRUE(text.ends_with("</svg>\n")) << entry.path();
      ++count;
    }
    EXPECT_EQ(count, 3u);
    for (const char* name : {"convergence.svg", "quality.svg", "mesh.svg"}) {
      EXPECT_TRUE(exists(in + "/" + name)) << name;
    }
  }

  void expect_nothing_done(const Outcome& outcome, int code, const std::string& why) const {
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("converged"), std::string::npos) << outcome.err;
    EXPECT_FALSE(exists("out.obj"));
  }

  testing::TemporaryFolder folder_;
};

TEST_F(Plots, AreThreeInAFolderOfTheirOwn) {
  const Outcome outcome = smooth({"--plot", "pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("wrote pictures into pictures"), std::string::npos) << outcome.err;
  expect_pictures("pictures");
  const std::string mesh = bytes("pictures/mesh.svg");
  EXPECT_NE(mesh.find(">before</text>"), std::string::npos);
  EXPECT_NE(mesh.find(">after</text>"), std::string::npos);
}

TEST_F(Plots, ReplaceThoseOfAnEarlierRunAndLeaveOtherFiles) {
  fs::create_directory(folder_.path() / "pictures");
  folder_.write("pictures/mesh.svg", "old");
  folder_.write("notes.txt", "mine");
  ASSERT_EQ(smooth({"--plot", "pictures/"}).exit_code, 0);
  expect_pictures("pictures");
  ASSERT_EQ(smooth({"--plot", "."}).exit_code, 0);
  EXPECT_TRUE(exists("mesh.svg"));
  EXPECT_EQ(bytes("notes.txt"), "mine");
}

TEST_F(Plots, OfARefusedRunShowWhatThereIs) {
  const Outcome outcome = smooth({"--plot", "pictures", "--cost", "local"}, "good.obj");
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  EXPECT_FALSE(exists("out.obj"));
  expect_pictures("pictures");
  EXPECT_NE(bytes("pictures/mesh.svg").find(">before</text>"), std::string::npos);
  EXPECT_EQ(bytes("pictures/mesh.svg").find(">after</text>"), std::string::npos);
}

TEST_F(Plots, GoWithAReport) {
  const Outcome outcome = smooth({"--plot", "pictures", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["status"], "ok");
  expect_pictures("pictures");
}

TEST_F(Plots, CanBeAskedForInAConfigurationFile) {
  folder_.write("run.toml", "plot = \"pictures\"\n");
  ASSERT_EQ(smooth({"--config", "run.toml"}).exit_code, 0);
  expect_pictures("pictures");
}

TEST_F(Plots, AreNotDrawnInADryRun) {
  ASSERT_EQ(smooth({"--plot", "pictures", "--dry-run"}).exit_code, 0);
  EXPECT_FALSE(exists("pictures"));
}

TEST_F(Plots, ThatCannotBeWrittenStopARunBeforeTheWork) {
  expect_nothing_done(smooth({"--plot", "no/pictures"}), 3, "--plot no/pictures: cannot be made");
  expect_nothing_done(smooth({"--plot", "in.obj"}), 3, "--plot in.obj: cannot be made");
  expect_nothing_done(smooth({"--plot", "/proc/pictures"}), 3, "--plot /proc/pictures");
  fs::create_directories(folder_.path() / "pictures" / "mesh.svg");
  expect_nothing_done(smooth({"--plot", "pictures"}), 3, "pictures/mesh.svg: is a folder");
  EXPECT_FALSE(exists("pictures/quality.svg"));
}

TEST_F(Plots, MustNotOverwriteTheReport) {
  expect_nothing_done(smooth({"--plot", ".", "--json", "mesh.svg"}), 2, "would overwrite mesh.svg");
}

TEST_F(Plots, LeaveNoFolderBehindWhereTheRunFails) {
  EXPECT_EQ(smooth({"--plot", "pictures", "--fix", "nonsense"}).exit_code, 2);
  EXPECT_FALSE(exists("pictures"));
}

}  // namespace
}  // namespace evenmesh
