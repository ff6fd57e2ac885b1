// SPDX-License-Identifier: MIT
//
// Surfaces of the corpus, from file to file: features stay features, the shape stays within its
// bound, and the cells get better.
#include <filesystem>
#include <ostream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "evenmesh/geometry/bvh.h"
#include "evenmesh/io/mesh_file.h"
#include "evenmesh/mesh/topology.h"
#include "tests/cli/process.h"
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

struct Surface {
  const char* file;
  bool worst_improves;  // false: the worst cell lies between fixed vertices
};

void PrintTo(const Surface& surface, std::ostream* out) { *out << surface.file; }

class OfTheCorpus : public ::testing::TestWithParam<Surface> {};

TEST_P(OfTheCorpus, KeepsFeaturesAndShapeAndGetsBetter) {
  const fs::path in = corpus_dir() / GetParam().file;
  if (!fs::exists(in)) GTEST_SKIP() << in << " is not there";
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out.obj";
  const fs::path report = folder.path() / "report.json";
  const Outcome outcome = run({in.string(), "-o", out.string(), "--iterations", "60", "--json",
                               report.string(), "--threads", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;

  const Mesh before = read_mesh(in).mesh;
  const Mesh after = read_mesh(out).mesh;
  const Orientation orientation = find_orientation(before);
  const Topology topology = find_topology(before, orientation);
  std::vector<VertexTriple> curves;
  for (const VertexPair& edge : topology.curves) curves.push_back({edge[0], edge[1], edge[1]});
  const Bvh bvh(before.points(), curves);
  double diagonal = (before.points()[0] - before.points()[1]).norm();
  for (const Vec3& p : before.points()) {
    diagonal = std::max(diagonal, (p - before.points()[0]).norm());
  }
  std::vector<char> on_curve(before.point_count(), 0);
  for (const VertexPair& edge : topology.curves) on_curve[edge[0]] = on_curve[edge[1]] = 1;
  for (Index v = 0; v < before.point_count(); ++v) {
    if (on_curve[v]) {
      EXPECT_LE(bvh.closest(after.points()[v]).distance, 1e-9 * diagonal);
    }
    if (topology.corners[v]) {
      EXPECT_EQ(after.points()[v], before.points()[v]);
    }
  }
  const json content = json::parse(read_bytes(report));
  EXPECT_EQ(content["inverted_after"], 0);
  EXPECT_GT(content["geometry"]["deviation"], 0.0);
  EXPECT_LE(content["geometry"]["deviation"], 0.0051 * 2.0 * diagonal);
  const json& shape = content["quality"];
  EXPECT_GT(shape["after"]["shape"]["mean"], shape["before"]["shape"]["mean"]);
  if (GetParam().worst_improves) {
    EXPECT_GT(shape["after"]["shape"]["worst"], shape["before"]["shape"]["worst"]);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, OfTheCorpus,
                         ::testing::Values(Surface{"cad_surface/trimesh__fandisk.obj", true},
                                           Surface{"scan/meshes__goathead.obj", true},
                                           Surface{"scan/cinolib__soccerball.obj", false}));

}  // namespace
}  // namespace evenmesh
