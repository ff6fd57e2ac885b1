// SPDX-License-Identifier: MIT
//
// What goes to which stream: results to stdout, narration to stderr, and nothing that only a
// terminal understands.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/meshes.h"
#include "tests/cli/process.h"
#include "tests/io/temporary_folder.h"

namespace evenmesh {
namespace {

using testing::Outcome;
using testing::read_bytes;
using testing::run;
using testing::RunOptions;
using testing::TemporaryFolder;

class Streams : public ::testing::Test {
 protected:
  Streams() : in_(folder_.write("in.obj", testing::kCanImprove).string()) {}

  Outcome smooth(std::vector<std::string> more, const RunOptions& options = {}) {
    more.insert(more.begin(), {in_, "-o", out()});
    return run(more, options);
  }
  std::string out() const { return (folder_.path() / "out.obj").string(); }

  TemporaryFolder folder_;
  std::string in_;
};

TEST_F(Streams, ResultsGoToStdoutAndNarrationToStderr) {
  const Outcome outcome = smooth({});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("shape "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("wrote"), std::string::npos);
  EXPECT_NE(outcome.err.find("converged in"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("wrote " + out()), std::string::npos) << outcome.err;
}

TEST_F(Streams, NothingIsWrittenForTerminalsOnly) {
  const Outcome outcome = smooth({"-v"});
  EXPECT_EQ((outcome.out + outcome.err).find_first_of("\r\x1b"), std::string::npos);
}

TEST_F(Streams, VerboseListsIteratesWithTheFunctionThatTheirCostsAreOf) {
  const std::string err = smooth({"-v"}).err;
  EXPECT_NE(err.find("\niteration function "), std::string::npos) << err;
  EXPECT_NE(err.find("\n        0        0 "), std::string::npos) << err;
}

TEST_F(Streams, QuietSaysNothingOnSuccess) {
  EXPECT_EQ(smooth({"-q"}).err, "");
  EXPECT_EQ(run({"check", in_, "-q"}).err, "");
  EXPECT_EQ(run({"-q", "info", in_}).err, "");
  EXPECT_EQ(run({"demo", "--quiet"}).err, "");
}

TEST_F(Streams, QuietStillSaysWhatWentWrong) {
  folder_.write("in.obj", testing::kCannotImprove);
  const Outcome outcome = smooth({"-q", "--cost", "local"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_TRUE(outcome.err.starts_with("refused: " + in_)) << outcome.err;
}

TEST_F(Streams, JsonOnStdoutIsPure) {
  const Outcome outcome = smooth({"--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["status"], "ok");
  EXPECT_EQ(report["output"], out());
  EXPECT_EQ(report["exit_code"], 0);
}

TEST_F(Streams, JsonTellsOfFailuresToo) {
  const Outcome missing = run({"missing.obj", "-o", out(), "--json", "-"});
  EXPECT_EQ(missing.exit_code, 3);
  const auto report = nlohmann::json::parse(missing.out);
  EXPECT_EQ(report["status"], "failed");
  EXPECT_EQ(report["exit_code"], 3);
  EXPECT_TRUE(report["output"].is_null());
  EXPECT_TRUE(report["stop_reason"].is_null());
}

TEST_F(Streams, ClosedStdoutDoesNotSpoilTheFile) {
  const std::string json = (folder_.path() / "report.json").string();
  ASSERT_EQ(smooth({"-q"}).exit_code, 0);
  const std::string wanted = read_bytes(out());
  std::filesystem::remove(out());
  EXPECT_EQ(smooth({"--json", json}, {.close_out = true}).exit_code, 0);
  EXPECT_EQ(read_bytes(out()), wanted);
  EXPECT_TRUE(nlohmann::json::accept(read_bytes(json)));
}

TEST_F(Streams, FullStdoutIsAFailure) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const Outcome outcome = run({"check", in_}, {.out = "/dev/full"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("did not reach standard output"), std::string::npos) << outcome.err;
}

TEST_F(Streams, LocalesWithADecimalCommaChangeNothing) {
  ASSERT_EQ(smooth({"-q", "--cost", "local=0.5"}).exit_code, 0);
  const std::string wanted = read_bytes(out());
  const Outcome german =
      smooth({"-q", "--cost", "local=0.5"}, {.environment = {"LC_ALL=de_DE.UTF-8"}});
  EXPECT_EQ(german.exit_code, 0) << german.err;
  EXPECT_EQ(read_bytes(out()), wanted);
}

}  // namespace
}  // namespace evenmesh
