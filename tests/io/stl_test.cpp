// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/format.h"
#include "evenmesh/io/stl_soup.h"
#include "tests/io/only_coordinates.h"
#include "tests/io/read_text.h"

namespace evenmesh {
namespace {

using testing::points_of;
using testing::refusal_by;
using testing::written;

MeshFile read(std::string_view bytes, const ReadOptions& options = {}) {
  return read_mesh(InputFile::borrow(bytes, "a.stl"), options);
}

std::string refusal(std::string_view text) {
  return refusal_by([&] { read(text); });
}

using Corners = std::array<Vec3, 3>;

std::string binary(const std::vector<Corners>& facets, const std::string& header = "part") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(static_cast<std::uint32_t>(facets.size()));
  for (const Corners& corners : facets) {
    for (const float component : {0.0F, 0.0F, 1.0F}) append(component);
    for (const Vec3& corner : corners) {
      for (int k = 0; k < 3; ++k) append(static_cast<float>(corner[k]));
    }
    bytes += "ab";  // the attribute
  }
  return bytes;
}

float float_at(std::string_view bytes, std::size_t facet, std::size_t number) {
  float value = 0.0F;
  std::memcpy(&value, bytes.data() + 84 + 50 * facet + 4 * number, sizeof(value));
  return value;
}

const std::vector<Corners> kTwo{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}},
                                {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}}};

const std::string kAscii =
    "\r\nSOLID  top part \r\n\tfacet normal nan 0 1e0\n outer loop vertex 0 -0 +0.0\n"
    "vertex 1.00 0 0 vertex 0 1 0 endloop endfacet\nendsolid\nsolid\nfacet normal 0 0 1\n"
    "outer loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid x\n";

TEST(StlBinary, WeldsCornersInTheirOrder) {
  const std::string bytes = binary(kTwo);
  const MeshFile file = read(bytes);
  EXPECT_EQ(file.patch->format(), "stl_binary");
  EXPECT_EQ(points_of(file), (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_TRUE(
      std::ranges::equal(file.mesh.cells().corners(), std::vector<Index>{0, 1, 2, 1, 3, 2}));
}

TEST(StlBinary, IsRecognisedBehindTheWordSolid) {
  EXPECT_EQ(read(binary(kTwo, "solid facet normal")).patch->format(), "stl_binary");
}

TEST(StlBinary, PatchesMovedFacetsAndTheirNormalsOnly) {
  std::vector<Corners> three = kTwo;
  three.push_back({Vec3{5, 5, 5}, Vec3{6, 5, 5}, Vec3{5, 6, 5}});
  const std::string bytes = binary(three) + "tail";
  const MeshFile file = read(bytes);
  std::vector<Vec3> points = points_of(file);
  EXPECT_EQ(written(file, points), bytes);
  points[3] = {1, 1, 0.1};  // of the second facet only
  const std::string out = written(file, points);
  EXPECT_EQ(out.size(), bytes.size());
  EXPECT_EQ(out.substr(0, 84 + 50), bytes.substr(0, 84 + 50));
  EXPECT_EQ(out.substr(84 + 98), bytes.substr(84 + 98));
  EXPECT_EQ(float_at(out, 1, 8), 0.1F);
  const Vec3 normal = Vec3(-0.1, -0.1, 1).normalized();
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_FLOAT_EQ(float_at(out, 1, k), static_cast<float>(normal[static_cast<int>(k)]));
  }
}

TEST(StlBinary, KeepsAVertexThatMovesLessThanSinglePrecisionShows) {
  const std::string bytes = binary(kTwo);
  const MeshFile file = read(bytes);
  std::vector<Vec3> points = points_of(file);
  points[1].x() += 1e-12;
  EXPECT_EQ(written(file, points), bytes);
  EXPECT_EQ(file.representable(points), points_of(file));
}

TEST(StlBinary, RepresentableIsWhatIsReadBack) {
  const std::string bytes = binary(kTwo);
  const MeshFile file = read(bytes);
  std::vector<Vec3> points = points_of(file);
  points[1] = {1.0 / 3.0, -0.0, 1e-50};
  points[2] = {-1e-50, 1.1, 0.7};
  const std::string out = written(file, points);
  const std::vector<Vec3> wanted = file.representable(points);
  const MeshFile again = read(out);
  EXPECT_EQ(std::memcmp(again.mesh.points().data(), wanted.data(), 4 * sizeof(Vec3)), 0);
}

TEST(StlBinary, HoldsTheNearestFiniteNumberWhereADoubleIsTooLarge) {
  const std::string bytes = binary(kTwo);
  const MeshFile file = read(bytes);
  std::vector<Vec3> points = points_of(file);
  points[3] = {1e300, -1e300, 0};
  const double largest = std::numeric_limits<float>::max();
  EXPECT_EQ(file.representable(points)[3], Vec3(largest, -largest, 0));
  EXPECT_EQ(float_at(written(file, points), 1, 6), std::numeric_limits<float>::max());
}

TEST(StlBinary, GivesACollapsedFacetNoNormal) {
  const std::string bytes = binary({kTwo[0]});
  const MeshFile file = read(bytes);
  std::vector<Vec3> points = points_of(file);
  points[2] = {2, 0, 0};
  const std::string out = written(file, points);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(float_at(out, 0, k), 0.0F);
}

TEST(StlBinary, RefusesCoordinatesThatAreNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    std::vector<Corners> facets = kTwo;
    facets[1][2].y() = bad;
    EXPECT_TRUE(refusal(binary(facets)).starts_with("a.stl: facet 2 (byte 134) has a coordinate"));
  }
}

TEST(StlBinary, TakesPaddingForPadding) {
  const std::string padded = binary(kTwo) + std::string(100, '\0');
  const MeshFile file = read(padded);
  EXPECT_EQ(file.mesh.cells().size(), 2u);
  EXPECT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(written(file, file.mesh.points()), padded);
}

TEST(StlAscii, ReadsAnyLayoutAndGroupsSolids) {
  const MeshFile file = read(kAscii);
  EXPECT_EQ(file.patch->format(), "stl_ascii");
  EXPECT_EQ(file.mesh.point_count(), 4u);
  EXPECT_EQ(file.group_names, (std::vector<std::string>{"", "solid top part", "solid 2"}));
  EXPECT_EQ(file.mesh.cells().group(0), 1u);
  EXPECT_EQ(file.mesh.cells().group(1), 2u);
  EXPECT_EQ(file.patch->cell_name(1), "facet 2 (line 8)");
  EXPECT_EQ(file.patch->vertex_name(3), "vertex 4 (corner 2 of facet 2 (line 8))");
  EXPECT_EQ(written(file, file.mesh.points()), kAscii);
}

TEST(StlAscii, PatchesMovedCoordinatesAndNormals) {
  const MeshFile file = read(kAscii);
  std::vector<Vec3> points = points_of(file);
  points[0].z() = 1.0;
  std::string expected = kAscii;
  expected.replace(expected.find("nan 0 1e0"), 9, "0.57735026 0.57735026 0.57735026");
  expected.replace(expected.find("+0.0"), 4, "1");
  EXPECT_EQ(written(file, points), expected);
}

TEST(StlAscii, KeepsDoublePrecision) {
  const MeshFile file = read(kAscii);
  std::vector<Vec3> points = points_of(file);
  points[3] = {1.0 / 3.0, 0.1, 1e-300};
  EXPECT_EQ(points_of(read(written(file, points))), points);
}

TEST(StlAscii, MakesNoGroupOfASingleSolid) {
  const MeshFile file = read(kAscii.substr(0, kAscii.find("solid\nfacet")));
  EXPECT_EQ(file.group_names, std::vector<std::string>{""});
  EXPECT_FALSE(file.mesh.cells().has_groups());
}

TEST(Stl, WeldsWithinATolerance) {
  std::vector<Corners> facets = kTwo;
  facets[1][0] = {1.001, 0.002, 0};
  const std::string bytes = binary(facets);
  EXPECT_EQ(read(bytes).mesh.point_count(), 5u);
  const ReadOptions options{.weld_tolerance = 0.01};
  const MeshFile file = read(bytes, options);
  ASSERT_EQ(file.mesh.point_count(), 4u);
  EXPECT_EQ(written(file, file.mesh.points()), bytes);

  // The corner that lies apart keeps its own y and z and gets the common x.
  std::vector<Vec3> points = points_of(file);
  points[1].x() = 1.25;
  const std::string out = written(file, points);
  EXPECT_EQ(float_at(out, 0, 6), 1.25F);
  EXPECT_EQ(float_at(out, 1, 3), 1.25F);
  EXPECT_EQ(float_at(out, 1, 4), 0.002F);
  EXPECT_EQ(points_of(read(out, options)), points);
}

TEST(Stl, RefusesAToleranceThatIsNoLength) {
  const std::string bytes = binary(kTwo);
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(read(bytes, {.weld_tolerance = bad}), InvalidOption);
  }
}

TEST(Stl, NormalsSurviveHugeAndTinyFacets) {
  for (const double size : {1e-300, 1e-160, 1.0, 1e160, 1e308}) {
    EXPECT_EQ(facet_normal({-size, 0, 0}, {size, 0, 0}, {0, size, 0}), Vec3(0, 0, 1)) << size;
  }
  EXPECT_EQ(facet_normal({1, 1, 1}, {2, 2, 2}, {3, 3, 3}), Vec3(0, 0, 0));
}

TEST(Stl, ReadsOrRefusesEveryBeginningOfAFile) {
  for (const std::string& bytes : {kAscii, binary(kTwo), binary(kTwo, "solid x\n")}) {
    for (std::size_t length = 0; length <= bytes.size(); ++length) {
      const std::vector<char> copy(bytes.begin(),
                                   bytes.begin() + static_cast<std::ptrdiff_t>(length));
      const std::string_view part(copy.data(), copy.size());
      try {
        const MeshFile file = read(part);
        EXPECT_EQ(written(file, file.mesh.points()), part);
      } catch (const IoError&) {
      }
    }
  }
}

}  // namespace
}  // namespace evenmesh
