// SPDX-License-Identifier: MIT
//
// Ctrl-C and the time limit.
#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "evenmesh/io/mesh_file.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/quality/quality.h"
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

/// A mesh whose iterations, with a tolerance that cannot be met, take long enough to come between.
class Interrupt : public ::testing::Test {
 protected:
  Interrupt() {
    in_ = (folder_.path() / "in.obj").string();
    testing::write_obj(shapes::irregular_triangles(kVertices), in_);
    size_ = std::filesystem::file_size(in_);
  }

  /// Sends SIGINT once the solver iterates: the narration before it is the sign.
  Outcome interrupted(std::vector<std::string> more) {
    more.insert(more.begin(), {in_, "-o", out(), "--tolerance", "1e-300", "--iterations", "100000",
                               "--json", json()});
    return run(more, {.meanwhile = [](pid_t child) {
                 std::this_thread::sleep_for(std::chrono::milliseconds(kDelay));
                 ::kill(child, SIGINT);
               }});
  }
  std::string out() const { return (folder_.path() / "out.obj").string(); }
  std::string json() const { return (folder_.path() / "report.json").string(); }
  nlohmann::json report() const { return nlohmann::json::parse(read_bytes(json())); }

#ifdef EVENMESH_SANITIZED
  static constexpr std::size_t kVertices = 100'000;
  static constexpr int kDelay = 3000;
#else
  static constexpr std::size_t kVertices = 300'000;
  static constexpr int kDelay = 1500;
#endif
  TemporaryFolder folder_;
  std::string in_;
  std::uintmax_t size_ = 0;
};

TEST_F(Interrupt, WritesNothing) {
  const Outcome outcome = interrupted({});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("nothing was written"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder_.count_files(), 2u);  // the input and the report
  EXPECT_EQ(report()["status"], "interrupted");
  EXPECT_EQ(report()["stop_reason"], "interrupted");
  EXPECT_TRUE(report()["output"].is_null());
}

TEST_F(Interrupt, KeepsWhatThereIsWhenAsked) {
  const Outcome outcome = interrupted({"--keep-partial"});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_EQ(report()["output"], out());
  const MeshFile before = read_mesh(in_);
  const MeshFile after = read_mesh(out());
  ASSERT_EQ(after.mesh.cells().size(), before.mesh.cells().size());
  Workers workers(1);
  const Orientation orientation = find_orientation(before.mesh);
  const auto quality = [&](const Mesh& mesh) {
    return summarize(workers, measure_cells(workers, mesh, mesh.points(), orientation));
  };
  EXPECT_EQ(quality(after.mesh).inverted, 0u);
  EXPECT_GE(quality(after.mesh).of(Metric::shape).worst,
            quality(before.mesh).of(Metric::shape).worst);
}

TEST_F(Interrupt, ASecondOneEndsTheProgramAtOnce) {
  const Outcome outcome = run({in_, "-o", out(), "--tolerance", "1e-300", "--iterations", "100000"},
                              {.meanwhile = [](pid_t child) {
                                // While it still reads or sets up, which no first Ctrl-C cuts
                                // short.
                                std::this_thread::sleep_for(std::chrono::milliseconds(100));
                                ::kill(child, SIGINT);
                                std::this_thread::sleep_for(std::chrono::milliseconds(20));
                                ::kill(child, SIGINT);
                              }});
  EXPECT_TRUE(outcome.signal == SIGINT || outcome.exit_code == 130) << outcome.err;
  EXPECT_EQ(folder_.count_files(), 1u);
}

TEST_F(Interrupt, TheTimeLimitKeepsTheResultAndSucceeds) {
  const Outcome outcome = run({in_, "-o", out(), "--tolerance", "1e-300", "--iterations", "100000",
                               "--time-limit", "0.05", "--json", json()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(report()["stop_reason"], "time_limit");
  EXPECT_NE(outcome.err.find("stopped at the time limit"), std::string::npos) << outcome.err;
  EXPECT_EQ(read_mesh(out()).mesh.point_count(), report()["input"]["vertices"]);
}

}  // namespace
}  // namespace evenmesh
