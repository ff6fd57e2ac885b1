// SPDX-License-Identifier: MIT
#include "evenmesh/io/msh.h"

#include <bit>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/format.h"
#include "tests/io/msh_text.h"
#include "tests/io/only_coordinates.h"
#include "tests/io/read_text.h"
#include "tests/io/temporary_folder.h"

namespace evenmesh {
namespace {

using testing::cell_of;
using testing::MshModel;
using testing::MshNumbers;
using testing::MshWriter;
using testing::points_of;
using testing::refusal_by;
using testing::written;

MeshFile read(std::string_view text) {
  return read_as(Format::msh, InputFile::borrow(text, "a.msh"), {});
}

std::string refusal(std::string_view text) {
  return refusal_by([&] { read(text); });
}

struct Layout {
  int version;
  MshNumbers numbers;
};

std::vector<Layout> all_layouts() {
  std::vector<Layout> layouts;
  for (const int version : {22, 40, 41}) {
    for (const auto numbers :
         {MshNumbers::text, MshNumbers::little_endian, MshNumbers::big_endian}) {
      layouts.push_back({version, numbers});
    }
  }
  return layouts;
}

std::string write(const Layout& layout, const MshModel& model) {
  return MshWriter(layout.version, layout.numbers).write(model);
}

std::string describe(const Layout& layout) {
  return "version " + std::to_string(layout.version) + ", numbers " +
         std::to_string(static_cast<int>(layout.numbers));
}

/// A tet with a triangle on it, a line and a point; tags have gaps and come in no order.
MshModel tet_model() {
  return {{{7, {0, 0, 0}}, {3, {1, 0, 0}}, {12, {0, 1, 0}}, {5, {0.25, 0.5, 1}}},
          {{15, 40, 0, 1, {7}},
           {1, 41, 0, 2, {7, 3}},
           {2, 42, 9, 3, {7, 12, 3}},
           {4, 17, 4, 6, {7, 3, 12, 5}}},
          "2\n2 9 \"wet side\"\n3 4 \"steel\"\n"};
}

/// One cell of each kind, all on the same eight nodes.
MshModel every_kind() {
  MshModel model;
  for (std::uint64_t i = 1; i <= 8; ++i) {
    const auto x = static_cast<double>(i);
    model.nodes.push_back({i, {x, x * x, 0.5 * x}});
  }
  model.elements = {{2, 1, 0, 1, {1, 2, 3}},          {3, 2, 0, 1, {1, 2, 3, 4}},
                    {4, 3, 0, 1, {1, 2, 3, 4}},       {5, 4, 0, 1, {1, 2, 3, 4, 5, 6, 7, 8}},
                    {6, 5, 0, 1, {1, 2, 3, 4, 5, 6}}, {7, 6, 0, 1, {1, 2, 3, 4, 5}}};
  return model;
}

TEST(Msh, ReadsEveryVersionAndByteOrderAlike) {
  for (const Layout& layout : all_layouts()) {
    SCOPED_TRACE(describe(layout));
    const std::string text = write(layout, tet_model());
    const MeshFile file = read(text);
    EXPECT_EQ(points_of(file),
              (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.5, 1}}));
    ASSERT_EQ(file.mesh.cells().size(), 2u);
    EXPECT_EQ(file.mesh.cells().kind(0), CellKind::triangle);
    EXPECT_EQ(cell_of(file, 0), (std::vector<Index>{0, 2, 1}));
    EXPECT_EQ(file.mesh.cells().kind(1), CellKind::tet);
    EXPECT_EQ(cell_of(file, 1), (std::vector<Index>{0, 1, 2, 3}));
    EXPECT_EQ(file.group_names,
              (std::vector<std::string>{"", "physical wet side", "physical steel"}));
    EXPECT_EQ(file.mesh.cells().group(0), 1u);
    EXPECT_EQ(file.mesh.cells().group(1), 2u);
    EXPECT_EQ(find_format(*InputFile::borrow(text, "a")), Format::msh);
  }
}

TEST(Msh, MakesACellOfEveryKindOfFirstOrder) {
  const CellKind kinds[] = {CellKind::triangle, CellKind::quad,  CellKind::tet,
                            CellKind::hex,      CellKind::wedge, CellKind::pyramid};
  for (const Layout& layout : all_layouts()) {
    SCOPED_TRACE(describe(layout));
    const std::string text = write(layout, every_kind());
    const MeshFile file = read(text);
    ASSERT_EQ(file.mesh.cells().size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(file.mesh.cells().kind(i), kinds[i]);
      const std::vector<Index> corners = cell_of(file, i);
      for (std::size_t k = 0; k < corners.size(); ++k) EXPECT_EQ(corners[k], k);
    }
    EXPECT_TRUE(file.notes.empty());
    EXPECT_EQ(file.group_names, (std::vector<std::string>{"", "entity 1", "entity 1"}));
  }
}

TEST(Msh, WritesAFileThatDidNotMoveByteForByte) {
  for (const Layout& layout : all_layouts()) {
    const std::string text = write(layout, tet_model());
    const MeshFile file = read(text);
    EXPECT_EQ(written(file, file.mesh.points()), text) << describe(layout);
  }
}

TEST(Msh, ReplacesOnlyTheCoordinateThatMoved) {
  // What the writer makes of the moved model is what the patch must make of the first one's file.
  for (const Layout& layout : all_layouts()) {
    for (std::size_t i = 0; i < 4; ++i) {
      MshModel model = tet_model();
      const std::string before = write(layout, model);
      const MeshFile file = read(before);
      model.nodes[i].position[static_cast<int>(i % 3)] = 1.0 / 3.0;
      std::vector<Vec3> points = points_of(file);
      points[i] = model.nodes[i].position;
      EXPECT_EQ(written(file, points), write(layout, model)) << describe(layout) << " node " << i;
    }
  }
}

TEST(Msh, ReadsBackWhatItWrote) {
  const std::vector<Vec3> points{
      {5e-324, -0.0, 1e300}, {-1.0 / 3.0, 0, 0.1}, {0, 1, 0}, {2, -1e-9, 3}};
  for (const Layout& layout : all_layouts()) {
    const std::string text = write(layout, tet_model());
    const std::string after = written(read(text), points);
    const std::vector<Vec3> again = points_of(read(after));
    ASSERT_EQ(again.size(), points.size());
    EXPECT_EQ(std::memcmp(again.data(), points.data(), 4 * sizeof(Vec3)), 0) << describe(layout);
  }
}

TEST(Msh, RefusesOrReadsEveryBeginningOfAFile) {
  for (const Layout& layout : all_layouts()) {
    SCOPED_TRACE(describe(layout));
    const std::string text = write(layout, tet_model());
    const std::size_t nodes_end = text.find("$EndNodes") + 9;
    const std::size_t elements = text.find("$Elements");
    for (std::size_t length = 1; length < text.size(); ++length) {
      // A copy of its own, so that the sanitizer sees a byte read too far.
      const std::vector<char> bytes(text.begin(),
                                    text.begin() + static_cast<std::ptrdiff_t>(length));
      const std::string message = refusal({bytes.data(), bytes.size()});
      // Between its sections, and without the last line end, a file is whole.
      const bool whole = (length >= nodes_end && length <= elements) || length + 1 == text.size();
      EXPECT_EQ(message == "was read", whole) << length << ": " << message;
      EXPECT_TRUE(whole || message.starts_with("a.msh:")) << message;
    }
  }
}

TEST(Msh, SurvivesEveryByteChanged) {
  for (const Layout& layout : all_layouts()) {
    const std::string text = write(layout, tet_model());
    for (std::size_t i = 0; i < text.size(); ++i) {
      for (const char other : {'\0', '\x7f', '\xff', '9', '-', ' ', '$', '\n'}) {
        std::string changed = text;
        changed[i] = other;
        try {
          const MeshFile file = read(changed);
          EXPECT_EQ(written(file, file.mesh.points()), changed);
          for (std::size_t c = 0; c < file.mesh.cells().size(); ++c) file.patch->cell_name(c);
        } catch (const IoError&) {
        }
      }
    }
  }
}

TEST(Msh, NamesCellsAndNodesByTheirTags) {
  for (const Layout& layout : all_layouts()) {
    const std::string text = write(layout, tet_model());
    const MeshFile file = read(text);
    const bool lines = layout.numbers == MshNumbers::text;
    EXPECT_EQ(file.patch->cell_name(1).substr(0, lines ? 17 : 99),
              lines ? "element 17 (line " : "element 17");
    EXPECT_EQ(file.patch->vertex_name(2).substr(0, lines ? 14 : 99),
              lines ? "node 12 (line " : "node 12");
  }
  const std::string text = write({22, MshNumbers::text}, tet_model());
  EXPECT_EQ(read(text).patch->vertex_name(0), "node 7 (line 11)");
  EXPECT_EQ(read(text).patch->cell_name(0), "element 42 (line 20)");
}

const std::string kFormat2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string kNodes2 = "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n";
const std::string kElements2 = "$Elements\n1\n1 2 2 0 0 1 2 3\n$EndElements\n";

TEST(Msh, KeepsCommentsLineEndsAndSectionsItDoesNotKnow) {
  const std::string text =
      "\xEF\xBB\xBF$Comments\r\nsee $EndComments\r\n$EndComments\r\n$MeshFormat\r\n2.2\t0 8\r\n"
      "$EndMeshFormat\r\n\r\n$Nodes \r\n3\r\n 1\t+0.50  0e3 0 \r\n2 1 0 0\r\n\r\n3 0 1 0\r\n"
      "$EndNodes\r\n$Elements\r\n1\r\n1 2 0 1 2 3\r\n$EndElements\r\n$NodeData\r\n$Nodes\r\n"
      "$EndNodeData\r\n$Mine\r\n\x01\xff\r\n$EndMine";
  const MeshFile file = read(text);
  EXPECT_EQ(written(file, file.mesh.points()), text);
  ASSERT_EQ(file.mesh.cells().size(), 1u);
  EXPECT_EQ(file.mesh.cells().group(0), 0u);
  std::vector<Vec3> points = points_of(file);
  points[0].y() = 7.25;
  std::string expected = text;
  expected.replace(expected.find("0e3"), 3, "7.25");
  EXPECT_EQ(written(file, points), expected);
}

TEST(Msh, LooksUpTagsFarApart) {
  const std::string text = kFormat2 +
                           "$Nodes\n3\n2000000000 0 0 0\n5 1 0 0\n70000 0 1 0\n$EndNodes\n"
                           "$Elements\n1\n1 2 0 5 70000 2000000000\n$EndElements\n";
  const MeshFile file = read(text);
  EXPECT_EQ(cell_of(file, 0), (std::vector<Index>{1, 2, 0}));
  EXPECT_TRUE(file.notes.empty());
  EXPECT_TRUE(std::ranges::equal(file.patch->vertex_numbers(),
                                 std::vector<std::uint64_t>{2000000000, 5, 70000}));
}

TEST(Msh, TakesElementsThatAreCountedFromZero) {
  MshModel model = tet_model();
  model.elements.back().tag = 0;
  for (const Layout& layout : all_layouts()) {
    const std::string text = write(layout, model);
    EXPECT_TRUE(read(text).patch->cell_name(1).starts_with("element 0")) << describe(layout);
  }
}

TEST(Msh, PutsACellInTheCombinationOfItsPhysicalGroups) {
  const std::string text =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 8 \"a "
      "\"b\"\"\n$EndPhysicalNames\n"
      "$Entities\n0 0 3 0\n1 0 -1e999 0 1 nan 0 2 -8 9 0\n2 0 0 0 1 1 0 0 0\n3 0 0 0 1 1 0 2 8 9 "
      "0\n"
      "$EndEntities\n$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n"
      "$Elements\n3 3 1 3\n2 1 2 1\n1 1 2 3\n2 2 2 1\n2 1 2 3\n2 3 2 1\n3 1 2 3\n$EndElements\n";
  const MeshFile file = read(text);
  EXPECT_EQ(file.group_names,
            (std::vector<std::string>{"", "physical a \"b\", physical 9", "entity 2"}));
  EXPECT_EQ(file.mesh.cells().group(0), 1u);
  EXPECT_EQ(file.mesh.cells().group(1), 2u);
  EXPECT_EQ(file.mesh.cells().group(2), 1u);
}

/// Four by one quads in a row, their lower side in two physical lines and a line within.
const std::string kRow =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n0 9 \"pin\"\n1 3 \"inlet\"\n1 4 "
    "\"wall\"\n2 3 \"air\"\n$EndPhysicalNames\n$Nodes\n10\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 3 0 0\n5 4 "
    "0 "
    "0\n6 0 1 0\n7 1 1 0\n8 2 1 0\n9 3 1 0\n10 4 1 0\n$EndNodes\n$Elements\n10\n1 1 2 3 1 1 2\n2 1 "
    "2 3 "
    "1 2 3\n3 1 2 4 2 3 4\n4 1 2 4 2 4 5\n5 1 2 0 7 4 9\n6 15 2 9 1 6\n7 3 2 3 1 1 2 7 6\n8 3 2 3 "
    "1 2 3 8 "
    "7\n9 3 2 3 1 3 4 9 8\n10 3 2 3 1 4 5 10 9\n$EndElements\n";

TEST(Msh, PhysicalLinesAndPointsAreSetsAndHoldTheirRims) {
  const MeshFile file = read(kRow);
  EXPECT_EQ(file.group_names, (std::vector<std::string>{"", "physical air"}));
  EXPECT_EQ(testing::set_of(file, "marker", "inlet"), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(testing::set_of(file, "marker", "wall"), (std::vector<Index>{2, 3, 4}));
  EXPECT_EQ(testing::set_of(file, "nset", "pin"), std::vector<Index>{5});
  ASSERT_EQ(file.sets.size(), 3u);
  EXPECT_EQ(file.sets[1].members, 2u);
  // 0, 2, 4: ends of inlet and wall; 3, 8: on the line within, which needs no name; 5: the pin.
  EXPECT_EQ(file.held.vertices, (std::vector<Index>{0, 2, 3, 4, 5, 8}));
}

TEST(Msh, SurfacesOfAVolumeAreMarkersAndHoldTheirRims) {
  // A cube; two of its sides have names, one belongs to an entity only.
  const std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 3 \"load\"\n$EndPhysicalNames\n"
      "$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 "
      "1\n$EndNodes\n"
      "$Elements\n3\n1 5 2 1 1 1 2 3 4 5 6 7 8\n2 3 2 3 1 1 2 3 4\n3 3 2 0 2 2 3 7 "
      "6\n$EndElements\n";
  const MeshFile file = read(text);
  EXPECT_EQ(testing::set_of(file, "marker", "load"), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(file.held.vertices, (std::vector<Index>{0, 1, 2, 3}));
}

TEST(Msh, SaysWhatItCannotHold) {
  EXPECT_EQ(read(kFormat2 + kNodes2 + "$Periodic\n0\n$EndPeriodic\n" + kElements2).notes.size(),
            1u);
  EXPECT_EQ(read(kFormat2 + kNodes2).notes.size(), 1u);  // no cells
  EXPECT_EQ(read(kFormat2 + kNodes2 + kElements2).notes.size(), 0u);
}

TEST(Msh, RefusesWithTheLineAtFault) {
  const std::string format4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  const std::string nodes = "$Nodes\n3\n1 0 0 0\n2 1 0 0\n";  // and one more; ends in line 7
  const auto element = [&](const std::string& line) {
    return kFormat2 + kNodes2 + "$Elements\n1\n" + line + "\n$EndElements\n";
  };
  const std::pair<std::string, std::string> cases[] = {
      {"$NOD\n1\n1 0 0 0\n$ENDNOD\n", "a.msh:1: a Gmsh mesh of version 1 is not read"},
      {"$MeshFormat\n3 0 8\n$EndMeshFormat\n", "a.msh:2: version 3 of the Gmsh format"},
      {"$MeshFormat\n2.2 0 4\n$EndMeshFormat\n", "a.msh:2: numbers of another size"},
      {"$MeshFormat\n2.2 2 8\n$EndMeshFormat\n", "a.msh:2: the file's type must be"},
      {"$MeshFormat\n2.2 1 8\nabcd\n$EndMeshFormat\n", "a.msh: byte 20: the number 1"},
      {kNodes2, "a.msh:1: $Nodes comes before $MeshFormat"},
      {kFormat2, "a.msh: has no nodes"},
      {kFormat2 + kElements2, "a.msh:4: $Elements must come behind $Nodes"},
      {kFormat2 + kNodes2 + kNodes2, "a.msh:10: a second $Nodes"},
      {kFormat2 + kNodes2 + kElements2 + kElements2, "a.msh:14: a second $Elements"},
      {kFormat2 + "$Nodes\n-3\n", "a.msh:5: the number of nodes is negative"},
      {kFormat2 + "$Nodes\n99999999999\n1 0 0 0\n$EndNodes\n",
       "a.msh:6: the file promises 99999999999 nodes"},
      {kFormat2 + nodes + "3 0 1\n$EndNodes\n", "a.msh:8: node 3 has 2 of 3 coordinates"},
      {kFormat2 + nodes + "3 0 1 0 5\n$EndNodes\n", "a.msh:8: the line is expected to end before"},
      {kFormat2 + nodes + "3 0 nan 0\n$EndNodes\n", "a.msh:8: 'nan' is not a finite number"},
      {kFormat2 + nodes + "3 0 1,5 0\n$EndNodes\n", "a.msh:8: '1,5' has a decimal comma"},
      {kFormat2 + nodes + "0 0 1 0\n$EndNodes\n", "a.msh:8: the tag of a node must be at least 1"},
      {kFormat2 + nodes + "2 0 1 0\n$EndNodes\n", "a.msh:8: node 2 is there twice"},
      {kFormat2 + nodes + "x 0 1 0\n$EndNodes\n", "a.msh:8: the tag of a node is expected"},
      {kFormat2 + nodes + "3 0 1 0\n4 0 0 0\n$EndNodes\n", "a.msh:9: $EndNodes is expected here"},
      {kFormat2 + nodes + "$EndNodes\n", "a.msh:8: the tag of a node is expected here"},
      {kFormat2 + "$ParametricNodes\n0\n$EndParametricNodes\n",
       "a.msh:4: nodes have parametric coordinates"},
      {kFormat2 + "$Mine\nabc\n", "a.msh:5: $EndMine is missing"},
      {kFormat2 + "$EndNodes\n", "a.msh:4: '$EndNodes' opens no section"},
      {element("5 2 0 1 2 4"), "a.msh:12: element 5 uses node 4, which"},
      {element("5 2 0 1 2"), "a.msh:12: the tag of a node is missing in this line"},
      {element("5 2 0 1 2 3 3"), "a.msh:12: the line is expected to end before '3'"},
      {element("5 2 -1 1 2 3"), "a.msh:12: the number of tags is negative"},
      {element("5 21 0 1 2 3 1 2 3 1 2 3 1"),
       "a.msh:12: element 5 is of third order or higher (type 21)"},
      {element("5 99 0 1 2 3"), "a.msh:12: element 5 has type 99"},
      {format4 + "$Nodes\n1 3 1 3\n2 1 1 3\n", "a.msh:6: "},
      {format4 + "$Nodes\n1 1 1 3\n2 1 1 1\n1\n0 0 0 0 0\n$EndNodes\n",
       "a.msh:6: nodes have parametric coordinates"},
      {format4 + "$Nodes\n1 1 1 3\n7 1 0 1\n1\n0 0 0\n$EndNodes\n",
       "a.msh:6: a block's entity has dimension 7"},
      {format4 + "$Nodes\n1 1 1 3\n2 1 0 2\n1\n0 0 0\n$EndNodes\n",
       "a.msh:6: a block of 2 nodes where 1 are left"},
      {format4 + "$Nodes\n1 2 1 3\n2 1 0 1\n1\n0 0 0\n$EndNodes\n",
       "a.msh:9: the blocks hold 1 nodes fewer"},
      {format4 + "$Nodes\n1 1 1 3\n2 1 0 1\n1\n0 0 0\n$EndNodes\n"
                 "$Elements\n1 1 1 1\n2 1 21 1\n1 1 1 1\n$EndElements\n",
       "a.msh:12: a block of elements is of third order or higher (type 21)"}};
  for (const auto& [text, message] : cases) {
    EXPECT_TRUE(refusal(text).starts_with(message)) << refusal(text) << "\n  not " << message;
  }
}

TEST(Msh, RefusesBinaryCoordinatesThatAreNotFinite) {
  MshModel model = tet_model();
  model.nodes[2].position.y() = std::numeric_limits<double>::infinity();
  for (const int version : {22, 40, 41}) {
    for (const auto numbers : {MshNumbers::little_endian, MshNumbers::big_endian}) {
      const std::string message = refusal(write({version, numbers}, model));
      EXPECT_TRUE(message.starts_with("a.msh: byte ")) << message;
      EXPECT_NE(message.find("a coordinate is not a finite number"), std::string::npos) << message;
    }
  }
}

TEST(Msh, RefusesNamesThatWouldFillTheMemory) {
  const int entities = 2000;
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"" +
                     std::string(100'000, 'x') + "\"\n$EndPhysicalNames\n$Entities\n0 0 " +
                     std::to_string(entities) + " 0\n";
  std::string blocks;
  for (int i = 1; i <= entities; ++i) {
    const std::string tag = std::to_string(i);
    text += tag + " 0 0 0 1 1 0 2 1 " + std::to_string(i + 1) + " 0\n";
    blocks += "2 " + tag + " 2 1\n" + tag + " 1 1 1\n";
  }
  text +=
      "$EndEntities\n$Nodes\n1 1 1 1\n2 1 0 1\n1\n0 0 0\n$EndNodes\n$Elements\n2000 2000 1 1\n" +
      blocks + "$EndElements\n";
  EXPECT_NE(refusal(text).find("are too long"), std::string::npos) << refusal(text);
}

TEST(Msh, IsWrittenToADiskAndNotUnderTheNameOfAnotherFormat) {
  const testing::TemporaryFolder folder;
  const MeshFile file =
      read_mesh(folder.write("in.msh", write({41, MshNumbers::text}, tet_model())));
  std::vector<Vec3> points = points_of(file);
  points[3].x() = 0.3;
  write_mesh(file, points, folder.path() / "out.msh");
  EXPECT_EQ(points_of(read_mesh(folder.path() / "out.msh")), points);
  EXPECT_THROW(write_mesh(file, points, folder.path() / "out.obj"), IoError);
}

}  // namespace
}  // namespace evenmesh
