// SPDX-License-Identifier: MIT
#include "evenmesh/io/ply.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/io/only_coordinates.h"
#include "tests/io/read_text.h"

namespace evenmesh {
namespace {

using testing::cell_of;
using testing::read_text;
using testing::readable_beginnings;
using testing::written;

using Numbers = std::vector<Index>;

const std::string kText =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty uchar red\n"
    "property float x\nproperty float y\nproperty float z\nproperty float nx\nelement face 3\n"
    "property list uchar float texcoord\nproperty list uchar int vertex_indices\n"
    "element edge 1\nproperty int vertex1\nend_header\n"
    "255 0 0 0 1\n0  1.0 0 0 1\n0 1 1 0 1 extra\n0 0 1 0.10000000149011612 1\n"
    "2 .5 .5 3 0 1 2\n0 4 0 1 2 3 9 9\n0 2 0 1\n7\n";

TEST(Ply, ReadsATextWithWhateverElseIsInIt) {
  const MeshFile file = read_text(kText, "a.ply");
  ASSERT_EQ(file.mesh.cells().size(), 2u);
  EXPECT_EQ(cell_of(file, 0), (Numbers{0, 1, 2}));
  EXPECT_EQ(cell_of(file, 1), (Numbers{0, 1, 2, 3}));
  EXPECT_EQ(file.mesh.points()[2], Vec3(1, 1, 0));
  EXPECT_EQ(file.patch->cell_name(1), "face 1 (line 21)");
  EXPECT_EQ(file.patch->vertex_name(3), "vertex 3 (line 19)");
  ASSERT_EQ(file.notes.size(), 2u);
  EXPECT_EQ(file.notes[0], "Vertex normals are kept as they are.");
}

TEST(Ply, FloatsInATextGetAFloatsDigitsWhereTheyMove) {
  const MeshFile file = read_text(kText, "a.ply");
  std::vector<Vec3> points = testing::points_of(file);
  EXPECT_EQ(written(file, points), kText);
  points[1].x() = 1.0 / 3.0;
  const std::vector<Vec3> wanted = file.representable(points);
  EXPECT_EQ(wanted[1].x(), 0.33333334);
  EXPECT_EQ(wanted[3].z(), 0.10000000149011612);  // did not move
  std::string expected = kText;
  expected.replace(expected.find("1.0 0 0 1\n0 1"), 3, "0.33333334");
  EXPECT_EQ(written(file, wanted), expected);
}

/// One quad behind its header, vertices with a colour, in either byte order and type.
std::string binary(bool big, bool wide, const std::string& line_end = "\n",
                   const std::string& last_end = "\n") {
  std::string text = "ply" + line_end + "format binary_" + (big ? "big" : "little") +
                     "_endian 1.0" + line_end + "element vertex 4" + line_end;
  for (const char axis : {'x', 'y', 'z'}) {
    text += std::string("property ") + (wide ? "double " : "float ") + axis + line_end;
  }
  text += "property uchar red" + line_end + "element face 1" + line_end +
          "property list uchar uint vertex_index" + line_end + "property short flags" + line_end +
          "end_header" + last_end;
  const auto put = [&](auto value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    if (big) std::reverse(raw, raw + sizeof(value));
    text.append(raw, sizeof(value));
  };
  for (const auto& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0.5)}) {
    for (int k = 0; k < 3; ++k) wide ? put(p[k]) : put(static_cast<float>(p[k]));
    put(std::uint8_t{10});
  }
  put(std::uint8_t{4});
  for (std::uint32_t v = 0; v < 4; ++v) put(v);
  put(std::int16_t{-3});
  return text;
}

TEST(Ply, ReadsAndPatchesBytesInEitherOrder) {
  for (const bool big : {false, true}) {
    for (const bool wide : {false, true}) {
      const std::string bytes = binary(big, wide);
      const MeshFile file = read_text(bytes, "a.ply");
      EXPECT_EQ(cell_of(file, 0), (Numbers{0, 1, 2, 3}));
      EXPECT_EQ(file.mesh.points()[3], Vec3(0, 1, 0.5));
      EXPECT_TRUE(file.notes.empty());
      EXPECT_EQ(file.patch->cell_name(0), "face 0");
      std::vector<Vec3> points = testing::points_of(file);
      EXPECT_EQ(written(file, points), bytes);
      points[2] = Vec3(0.1, 1, 0);
      const std::string after = written(file, points);
      ASSERT_EQ(after.size(), bytes.size());
      const MeshFile again = read_text(after, "a.ply");
      EXPECT_EQ(again.mesh.points()[2].x(), wide ? 0.1 : double{0.1f});
      EXPECT_EQ(again.mesh.points()[2], file.representable(points)[2]);
    }
  }
}

TEST(Ply, FindsTheDataBehindAnyLineEnd) {
  for (const auto& [line_end, last_end] : std::vector<std::pair<std::string, std::string>>{
           {"\r\n", "\r\n"}, {"\n", "\r\n"}, {"\r", "\r"}}) {
    const MeshFile file = read_text(binary(false, true, line_end, last_end), "a.ply");
    EXPECT_EQ(file.mesh.points()[1], Vec3(1, 0, 0));
    EXPECT_EQ(file.mesh.cells().size(), 1u);
  }
}

TEST(Ply, RefusesWithThePlaceAtFault) {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::vector<testing::Refusal> cases = {
      {head, ":3: the file ends within its header"},
      {"ply\nformat binary 1.0\n", ":2: format 'binary'"},
      {head + "property float x\n", ":3: a property before any element"},
      {head + "element vertex\n", ":3: the number of elements is missing"},
      {head + "element vertex 1\nproperty real x\n", ":4: 'real' is no type"},
      {head + "what\n", ":3: 'what' in the header"},
      {head + "element face 0\nend_header\n", ": has no vertices"},
      {head +
           "element vertex 1\nproperty float x\nproperty float z\nproperty float y\nend_header\n",
       ":3: the properties x, y and z"},
      {head +
           "element vertex 1\nproperty float x\nproperty double y\nproperty float z\nend_header\n",
       ":5: coordinates must be float or double"},
      {head + "element tristrips 1\nend_header\n", ":3: triangle strips"},
      {head + "element vertex 9999\n" + xyz + "end_header\n0 0 0\n", ":8: promises 9999 vertex"},
      {head + "element vertex 1\n" + xyz + "end_header\n0 nan 0\n", ":8: 'nan' is not a finite"},
      {head + "element vertex 1\n" + xyz + face + "0 0 0\n3 0 0 7\n",
       ":11: face 0 names vertex 7; the 1 vertices count from 0"},
      {head + "element vertex 1\n" + xyz + face + "0 0 0\n99 0 0\n",
       ":11: promises 99 numbers in a list"}};
  testing::expect_refusals("a.ply", cases);
}

TEST(Ply, ReadsOrRefusesEveryBeginningOfAFile) {
  EXPECT_GT(readable_beginnings(kText, "a.ply"), 0);
  EXPECT_EQ(readable_beginnings(binary(false, true), "a.ply"), 1);
}

}  // namespace
}  // namespace evenmesh
