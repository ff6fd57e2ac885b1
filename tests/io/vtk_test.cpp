// SPDX-License-Identifier: MIT
//
// VTK's formats: files that VTK wrote in all its ways (fuzz/corpus, made by
// tools/make_vtk_seeds.py) and texts that show one thing each.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include <gtest/gtest.h>

#include "evenmesh/io/mesh_file.h"
#include "tests/io/patch_checker.h"
#include "tests/io/read_text.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/places.h"

namespace evenmesh {
namespace {

namespace fs = std::filesystem;
using testing::cell_of;
using testing::points_of;
using testing::read_text;
using testing::TemporaryFolder;

/// Files of the seeds whose names begin so.
std::vector<fs::path> seeds(const std::string& beginning) {
  std::vector<fs::path> files;
  for (const char* const folder : {"vtk", "vtu", "vtp"}) {
    for (const auto& entry :
         fs::directory_iterator(testing::source_dir() / "fuzz/corpus" / folder)) {
      if (entry.path().filename().string().starts_with(beginning)) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

const DataArray& array_of(const MeshFile& file, const std::string& name) {
  const auto found = std::find_if(file.arrays.begin(), file.arrays.end(),
                                  [&](const DataArray& array) { return array.name == name; });
  EXPECT_NE(found, file.arrays.end()) << name;
  return *found;
}

std::vector<std::string> names_of_arrays(const MeshFile& file) {
  std::vector<std::string> names;
  for (const DataArray& array : file.arrays) names.push_back(array.name);
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> groups_of_cells(const MeshFile& file) {
  std::vector<std::string> groups;
  for (std::size_t c = 0; c < file.mesh.cells().size(); ++c) {
    groups.push_back(file.group_names[file.mesh.cells().group(c)]);
  }
  return groups;
}

double distance(Points a, Points b) {
  double most = a.size() == b.size() ? 0.0 : HUGE_VAL;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    most = std::max(most, (a[i] - b[i]).norm());
  }
  return most;
}

/// All files hold the same, whatever the encoding.
void expect_same_content(const std::vector<fs::path>& files, const std::string& sample) {
  const MeshFile first = read_mesh(files[0]);
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename());
    const MeshFile file = read_mesh(path);
    EXPECT_TRUE(file.notes.empty());
    EXPECT_TRUE(std::ranges::equal(file.mesh.cells().kinds(), first.mesh.cells().kinds()));
    EXPECT_TRUE(std::ranges::equal(file.mesh.cells().corners(), first.mesh.cells().corners()));
    EXPECT_LT(distance(file.mesh.points(), first.mesh.points()), 1e-6);
    EXPECT_EQ(groups_of_cells(file), groups_of_cells(first));
    EXPECT_EQ(names_of_arrays(file), names_of_arrays(first));
    const std::vector<double> values = array_of(file, sample).values();
    const std::vector<double> others = array_of(first, sample).values();
    ASSERT_EQ(values.size(), others.size());
    // VTK writes texts with fewer digits.
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], others[i], 1e-3);
  }
}

TEST(Vtk, GridsReadTheSameInEveryEncoding) {
  const std::vector<fs::path> files = seeds("grid_");
  ASSERT_EQ(files.size(), 11u);
  expect_same_content(files, "temperature");

  const MeshFile file = read_mesh(files[0]);
  EXPECT_EQ(file.mesh.cells().size(), 10u);
  EXPECT_EQ(cell_of(file, 0), (std::vector<Index>{0, 1, 4, 3, 9, 10, 13, 12}));
  EXPECT_EQ(cell_of(file, 9), (std::vector<Index>{22, 23, 29, 28}));
  EXPECT_EQ(names_of_arrays(file),
            (std::vector<std::string>{"bc flags", "material", "size", "temperature"}));
  EXPECT_EQ(array_of(file, "temperature").values()[31], 0.5);
  // The file has a vertex before the hexes, which is no cell of the mesh.
  EXPECT_EQ(array_of(file, "size").values(),
            (std::vector<double>{.25, .5, .75, 1, 1.25, 1.5, 1.75, 2, 2.25, 2.5}));
  EXPECT_EQ(groups_of_cells(file)[7], "material 3");
  EXPECT_EQ(groups_of_cells(file)[8], "material 4");
}

TEST(Vtk, SurfacesReadTheSameInEveryEncoding) {
  const std::vector<fs::path> files = seeds("surface_");
  ASSERT_EQ(files.size(), 11u);
  expect_same_content(files, "wall");

  const MeshFile file = read_mesh(files[0]);
  EXPECT_EQ(file.mesh.cells().size(), 14u);
  EXPECT_EQ(cell_of(file, 2), (std::vector<Index>{1, 2, 6, 5}));
  // Cells count behind the vertex and the line.
  EXPECT_TRUE(file.patch->cell_name(2).starts_with("cell 4")) << file.patch->cell_name(2);
}

TEST(Vtk, MovedPointsAreAllThatChanges) {
  std::vector<fs::path> files = seeds("");
  ASSERT_EQ(files.size(), 24u);
  const TemporaryFolder folder;
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename());
    const MeshFile file = read_mesh(path);
    const fs::path output = folder.path() / path.filename();
    write_mesh(file, file.mesh.points(), output);
    EXPECT_EQ(testing::read_bytes(output), testing::read_bytes(path));

    std::vector<Vec3> points = points_of(file);
    points[5] += Vec3(0.01, 0.002, -1.0 / 3.0);
    points[1].y() += 0.015625;
    write_mesh(file, points, output);
    EXPECT_EQ(testing::checker_complaint(path, output), "");
    EXPECT_LT(distance(read_mesh(output).mesh.points(), file.representable(points)), 1e-300);
  }
}

TEST(Vtk, OffsetsBehindCompressedPointsAreMoved) {
  const fs::path path = testing::source_dir() / "fuzz/corpus/vtu/grid_appended_raw_zlib.vtu";
  const MeshFile file = read_mesh(path);
  std::vector<Vec3> points = points_of(file);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].x() += 1.0 / static_cast<double>(i + 3);
  const TemporaryFolder folder;
  write_mesh(file, points, folder.path() / "moved.vtu");
  EXPECT_NE(fs::file_size(folder.path() / "moved.vtu"), fs::file_size(path));
  const MeshFile moved = read_mesh(folder.path() / "moved.vtu");
  EXPECT_EQ(array_of(moved, "temperature").values(), array_of(file, "temperature").values());
  EXPECT_EQ(testing::checker_complaint(path, folder.path() / "moved.vtu"), "");
}

TEST(Vtk, MiddlesOfSecondOrderAreWhereVtkHasThem) {
  const MeshFile file = read_mesh(testing::source_dir() / "fuzz/corpus/vtk/second_order.vtk");
  EXPECT_EQ(file.mesh.cells().size(), 13u);
  EXPECT_EQ(file.followers.size(), 158u - 62u);
  std::vector<Vec3> points = points_of(file);
  for (std::size_t i = 0; i < file.followers.size(); ++i) {
    Vec3 middle = Vec3::Zero();
    const auto leaders = file.followers.leaders(i);
    for (const Index v : leaders) middle += points[v] / static_cast<double>(leaders.size());
    EXPECT_LT((points[file.followers.vertex(i)] - middle).norm(), 1e-4) << i;
  }
}

std::string legacy(const std::string& content, const std::string& version = "3.0") {
  return "# vtk DataFile Version " + version + "\ntitle\nASCII\n" + content;
}

std::string zeros(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "0 ";
  return text;
}

const std::string kSquare =
    "DATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0\n0 1 0\n1 1 0\n";

TEST(VtkLegacy, PixelsAndVoxelsAreQuadsAndHexes) {
  const MeshFile pixel =
      read_text(legacy(kSquare + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n8\n"), "a.vtk");
  EXPECT_EQ(cell_of(pixel, 0), (std::vector<Index>{0, 1, 3, 2}));
  const MeshFile voxel = read_text(
      legacy("DATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 "
             "1 1 1 1\nCELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\n"),
      "a.vtk");
  EXPECT_EQ(voxel.mesh.cells().kind(0), CellKind::hex);
  EXPECT_EQ(cell_of(voxel, 0), (std::vector<Index>{0, 1, 3, 2, 4, 5, 7, 6}));
}

TEST(VtkLegacy, GridsWithTwoDirectionsAreQuads) {
  const MeshFile file =
      read_text(legacy("DATASET STRUCTURED_GRID\nDIMENSIONS 2 1 3\nPOINTS 6 double\n"
                       "0 0 0 1 0 0 0 0 1 1 0 1 0 0 2 1 0 2\n"),
                "a.vtk");
  ASSERT_EQ(file.mesh.cells().size(), 2u);
  EXPECT_EQ(cell_of(file, 1), (std::vector<Index>{2, 3, 5, 4}));
}

TEST(VtkLegacy, ArraysAreFoundAmongOthers) {
  const MeshFile file = read_text(
      legacy(
          kSquare +
          "CELLS 2 7\n3 0 1 2\n2 1 3\nMETADATA\nINFORMATION 1\nNAME a LOCATION b\nDATA 1\n\n"
          "CELL_TYPES 2\n5\n3\nCELL_DATA 2\nSCALARS my%20region int 1\nLOOKUP_TABLE default\n1 2\n"
          "COLOR_SCALARS paint 3\n0 0 0 1 1 1\nPOINT_DATA 4\nLOOKUP_TABLE mine 1\n0 0 0 1\n"
          "TEXTURE_COORDINATES uv 2 float\n0 0 1 0 0 1 1 1\nVECTORS v float\n1 2 3 1 2 3 1 2 3 1 2 "
          "3\n"
          "NORMALS n double\n1 2 3 1 2 3 1 2 3 1 2 3\nTENSORS t float\n" +
          zeros(36) +
          "\nFIELD FieldData 3\nwords 1 2 string\nfirst word\n\nok 1 4 bit\n1 0 1 0\nlast 1 4 "
          "float\nnan 1 2e0 -3\n"),
      "a.vtk");
  EXPECT_TRUE(file.notes.empty());
  EXPECT_EQ(names_of_arrays(file), (std::vector<std::string>{"last", "my region"}));
  EXPECT_EQ(array_of(file, "my region").values(), std::vector<double>{1});
  EXPECT_EQ(array_of(file, "last").values()[3], -3);
  EXPECT_TRUE(std::isnan(array_of(file, "last").values()[0]));
  EXPECT_EQ(file.patch->cell_name(0), "cell 0 (line 10)");
  EXPECT_EQ(file.patch->vertex_name(2), "point 2 (line 7)");
}

TEST(VtkLegacy, LinesHoldTheRimsOfTheirGroupsAndWhatIsWithin) {
  // Two by two quads; below two lines of group 5 and 6, in the middle one of group 5.
  const MeshFile file = read_text(
      legacy("DATASET UNSTRUCTURED_GRID\nPOINTS 9 double\n0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0 "
             "0 2 0 1 2 0 2 2 0\nCELLS 7 29\n2 0 1\n2 1 2\n2 4 5\n4 0 1 4 3\n4 1 2 5 4\n4 3 4 7 "
             "6\n4 4 5 8 7\nCELL_TYPES 7\n3 3 3 9 9 9 9\nCELL_DATA 7\nSCALARS MaterialIds "
             "int\nLOOKUP_TABLE default\n5 6 5 1 1 1 1\n"),
      "a.vtk");
  EXPECT_EQ(file.group_names, (std::vector<std::string>{"", "MaterialIds 1"}));
  EXPECT_EQ(file.held.vertices, (std::vector<Index>{0, 1, 2, 4, 5}));
}

TEST(VtkLegacy, WhatIsNotKnownBehindTheMeshIsLeftAlone) {
  const std::string text = legacy(kSquare +
                                  "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\nPOINT_DATA 4\nMYSTERY "
                                  "7\nSCALARS late int\n1 2 3 4\n");
  const MeshFile file = read_text(text, "a.vtk");
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(file.notes[0], "What follows line 14 is kept but not read: 'MYSTERY' is not known.");
  EXPECT_TRUE(file.arrays.empty());
}

TEST(VtkLegacy, LineEndsOfOtherSystemsAreRead) {
  std::string text = legacy(kSquare + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n");
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) {
    text.replace(at, 1, "\r\n");
  }
  const MeshFile file = read_text(text, "a.vtk");
  EXPECT_EQ(file.mesh.cells().size(), 1u);
  std::vector<Vec3> points = points_of(file);
  points[1].x() = 1.0 / 3.0;
  text.replace(text.find("1 0 0"), 1, "0.33333334");  // the file is for floats
  EXPECT_EQ(testing::written(file, file.representable(points)), text);
}

TEST(VtkLegacy, BrokenFilesAreRefusedWithTheLine) {
  const std::string triangle = "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";
  testing::expect_refusals(
      "a.vtk",
      {{legacy(triangle, "9.0"), ":1: version '9.0' of VTK's files is not read"},
       {"# vtk DataFile Version 3.0\nt\nXML\n", ":3: ASCII or BINARY is expected"},
       {legacy(""), ": has no DATASET"},
       {legacy("DATASET UNSTRUCTURED_GRID\n"), ": has no POINTS"},
       {legacy("DATASET STRUCTURED_POINTS\n"), ":4: the points of this dataset lie on a grid"},
       {legacy("DATASET TREE\n"), ":4: 'TREE' is no dataset with a mesh"},
       {legacy("DATASET UNSTRUCTURED_GRID\nPOINTS 1 int\n1 2 3\n"), ":5: points must be float"},
       {legacy("DATASET UNSTRUCTURED_GRID\nPOINTS 1 flot\n1 2 3\n"), ":5: 'flot' is no type"},
       {legacy("DATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n1 nan 3\n"),
        ":6: 'nan' is not a finite number"},
       {legacy("DATASET UNSTRUCTURED_GRID\nPOINTS 2 float\n1 1 3 4\n"),
        ":5: promises 2 points but the rest of the file has room for"},
       {legacy("DATASET POLYDATA\nPOINTS 1 float\n1 1 3\nTRIANGLE_STRIPS 1 4\n3 0 0 0\n"),
        ":7: triangle strips are not read"},
       {legacy(kSquare + "CELLS 1 4\n3 0 1 4\nCELL_TYPES 1\n5\n"),
        ":10: cell 0 names point 4; the 4"},
       {legacy(kSquare + "CELLS 1 4\n3 0 1 -4\nCELL_TYPES 1\n5\n"), ":10: there is no point -4"},
       {legacy(kSquare + "CELLS 1 5\n3 0 1 2 1\nCELL_TYPES 1\n5\n"),
        ":10: the list of 1 cells is shorter than its size"},
       {legacy(kSquare + "CELLS 2 8\n3 0 1 2 6 1 2 3\nCELL_TYPES 2\n5 5\n"),
        ":9: 2 cells do not fill a list of 8 numbers"},
       {legacy(kSquare + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 2\n5 5\n"), ":11: 2 types for 1 cells"},
       {legacy(kSquare + "CELLS 1 4\n3 0 1 2\n"), ": has CELLS but no CELL_TYPES"},
       {legacy(kSquare + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n42\n"),
        ":10: cell 0 is of type 42, a polyhedron"},
       {legacy(kSquare + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n9\n"),
        ":10: cell 0 has 3 points; a cell of type 9 (quad) has 4"},
       {legacy(kSquare + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n72\n"),
        ":10: cell 0 is of type 72, a Lagrange cell"},
       {legacy(kSquare + triangle + "CELL_DATA 3\n"),
        ":13: data for 3 cells, but there are 1 cells"},
       {legacy(kSquare + triangle + "POINT_DATA 4\nSCALARS a int\nLOOKUP_TABLE default\n1 2\n"),
        ":15: promises 4 numbers but the rest of the file has room for"},
       {legacy(kSquare + "CELLS 2 3\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2\n"
                         "CELL_TYPES 1\n5\n",
               "5.1"),
        ":11: offset 4 of a cell follows 0; the list has 3 points"},
       {legacy(
            "DATASET STRUCTURED_GRID\nDIMENSIONS 2 2 9\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n"),
        ": DIMENSIONS 2 2 9 do not give the 4 points"}});
}

TEST(VtkLegacy, EveryBeginningIsReadOrRefused) {
  for (const fs::path& path : seeds("")) {
    if (path.extension() != ".vtk") continue;
    testing::readable_beginnings(testing::read_bytes(path), "a.vtk");
  }
}

std::string xml(const std::string& content, const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?>\n<!-- <VTKFile> -->\n<VTKFile type='UnstructuredGrid' " +
         attributes + ">\n<UnstructuredGrid>\n" + content + "</UnstructuredGrid>\n</VTKFile>\n";
}

std::string piece(const std::string& points, const std::string& rest,
                  const std::string& counts = "NumberOfPoints='3' NumberOfCells='1'") {
  return "<Piece " + counts + ">\n<Points>\n<DataArray type='Float64' NumberOfComponents='3'>" +
         points + "</DataArray>\n</Points>\n" + rest + "</Piece>\n";
}

const std::string kTriangle =
    "<Cells><DataArray type='Int32' Name='connectivity'>0 1 2</DataArray>\n<DataArray type='Int32' "
    "Name='offsets'>3</DataArray><DataArray type='UInt8' Name='types'>5</DataArray></Cells>\n";

TEST(VtkXml, NumbersMayTouchTheirTags) {
  const MeshFile file = read_text(xml(piece("0 0 0 1 0 0 0 1 0", kTriangle)), "a.vtu");
  ASSERT_EQ(file.mesh.cells().size(), 1u);
  EXPECT_EQ(file.patch->vertex_name(1), "point 1 (line 7)");
  std::vector<Vec3> points = points_of(file);
  points[2].z() = 0.5;
  EXPECT_EQ(testing::written(file, points), xml(piece("0 0 0 1 0 0 0 1 0.5", kTriangle)));
}

TEST(VtkXml, PiecesAreOneMesh) {
  const std::string data =
      "<CellData><DataArray type='Int8' Name='a &lt; b'>7</DataArray></CellData>";
  const MeshFile file = read_text(xml(piece("0 0 0 1 0 0 0 1 0", data + kTriangle) +
                                      piece("2 0 0 3 0 0 2 1 0", kTriangle + data)),
                                  "a.vtu");
  EXPECT_EQ(file.mesh.point_count(), 6u);
  EXPECT_EQ(cell_of(file, 1), (std::vector<Index>{3, 4, 5}));
  EXPECT_EQ(array_of(file, "a < b").values(), (std::vector<double>{7, 7}));
}

TEST(VtkXml, SizesMayBeEncodedApart) {
  // As older versions of DOLFIN write: the size, then the numbers, each with its own padding.
  const std::string size = "SAAAAA==";
  std::string numbers;
  for (int i = 0; i < 3; ++i) numbers += std::string(32, 'A');  // 24 bytes of zeros
  const std::string text =
      xml("<Piece NumberOfPoints='3' NumberOfCells='0'><Points><DataArray type='Float64' "
          "NumberOfComponents='3' format='binary'>\n  " +
          size + numbers + "\n</DataArray></Points></Piece>\n");
  const MeshFile file = read_text(text, "a.vtu");
  ASSERT_EQ(file.mesh.point_count(), 3u);
  std::vector<Vec3> points = points_of(file);
  EXPECT_EQ(testing::written(file, points), text);
  points[2].z() = 1.0;
  const std::string moved = testing::written(file, points);
  EXPECT_EQ(moved.size(), text.size());
  EXPECT_NE(moved.find(size), std::string::npos);
  EXPECT_EQ(points_of(read_text(moved, "a.vtu"))[2], Vec3(0, 0, 1));
}

TEST(VtkXml, BrokenFilesAreRefused) {
  const std::string ok = "0 0 0 1 0 0 0 1 0";
  testing::expect_refusals(
      "a.vtu",
      {{"<VTKFile type='ImageData'></VTKFile>", ":1: a VTK file of type 'ImageData'"},
       {"<VTKFile type='PUnstructuredGrid'></VTKFile>",
        ":1: a VTK file of type 'PUnstructuredGrid'; UnstructuredGrid (.vtu) and PolyData (.vtp) "
        "are read; smooth its parts"},
       {xml("", "compressor='vtkLZ4DataCompressor'"),
        ":3: arrays packed by vtkLZ4DataCompressor are not read"},
       {xml(""), ": has no <Piece>"},
       {"<VTKFile type='UnstructuredGrid'>", ": ends before </VTKFile>"},
       {xml(piece(ok, kTriangle, "NumberOfCells='1'")), ":5: a piece without NumberOfPoints"},
       {xml(piece(ok, kTriangle, "NumberOfPoints='x' NumberOfCells='1'")),
        ":5: 'x' is no number of something"},
       {xml(piece(ok, "")), ":5: a piece without connectivity"},
       {xml(piece(ok + " 1", kTriangle)), ":7: the array ends within the coordinates of vertex 3"},
       {xml(piece("0 0 0 1 0 0 0 1 x", kTriangle)), ":7: 'x' is not a number (a coordinate of"},
       {xml(piece(ok, kTriangle, "NumberOfPoints='4' NumberOfCells='1'")),
        ":7: the array '' has 3 points, and the piece says 4"},
       {xml(piece("0 0 0 1 0 0", kTriangle, "NumberOfPoints='2' NumberOfCells='1'")),
        ": cell 0 names point 2; the 2 points count from 0"},
       {xml(piece(ok, kTriangle, "NumberOfPoints='3' NumberOfCells='2'")),
        ":10: the array 'offsets' has 1 numbers for 2 cells"},
       {xml("<Piece NumberOfPoints='1' NumberOfCells='0'><Points><DataArray type='Float32' "
            "NumberOfComponents='3' format='appended' offset='7'/></Points></Piece>"),
        ":5: the array '' begins behind the end of the file"},
       {xml("<Piece NumberOfPoints='1' NumberOfCells='0'><Points><DataArray type='Float32' "
            "NumberOfComponents='3' format='binary'>DAAAA</DataArray></Points></Piece>"),
        ": byte "}});
}

TEST(VtkXml, EveryBeginningIsReadOrRefused) {
  for (const fs::path& path : seeds("")) {
    if (path.extension() == ".vtk") continue;
    EXPECT_LE(testing::readable_beginnings(testing::read_bytes(path), "a.vtu"), 40) << path;
  }
}

}  // namespace
}  // namespace evenmesh
