// SPDX-License-Identifier: MIT
#include "evenmesh/io/mesh_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "evenmesh/base/error.h"
#include "tests/io/temporary_folder.h"

namespace evenmesh {
namespace {

namespace fs = std::filesystem;
using testing::read_bytes;
using testing::TemporaryFolder;

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr std::string_view kStl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nendsolid a\n";

std::string refusal(const fs::path& path) {
  try {
    read_mesh(path);
  } catch (const IoError& error) {
    return error.what();
  }
  return "was read";
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(ReadMesh, FindsTheFormatByContentWhateverTheSuffix) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.write("a.stl", kTriangle)).patch->format(), "obj");
  EXPECT_EQ(read_mesh(folder.write("b", kTriangle)).patch->format(), "obj");
  EXPECT_EQ(read_mesh(folder.write("c.obj", kStl)).patch->format(), "stl_ascii");
  const std::string binary(84, '\0');
  EXPECT_EQ(read_mesh(folder.write("d.obj", binary)).patch->format(), "stl_binary");
}

TEST(ReadMesh, RefusesOtherFormatsAndSaysWhichAreRead) {
  const TemporaryFolder folder;
  const std::pair<const char*, std::string_view> files[] = {
      {"a.msh", "$NOD\n1\n1 0 0 0\n"},
      {"a.xml", "<?xml version='1.0'?>\n<mesh/>\n"},
      {"a.inp", "1 2 3\n"},
      {"a.cdb", "/PREP7\n"}};
  for (const auto& [name, content] : files) {
    const std::string message = refusal(folder.write(name, content));
    EXPECT_TRUE(contains(message, "OBJ, STL, OFF, PLY, Gmsh MSH")) << message;
    EXPECT_TRUE(contains(message, name)) << message;
  }
}

TEST(ReadMesh, RefusesWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(refusal(folder.path()), "is a folder"));
  EXPECT_TRUE(contains(refusal(folder.path() / "none.obj"), "No such file"));
  EXPECT_TRUE(contains(refusal(folder.write("empty.obj", "")), "is empty"));
  EXPECT_TRUE(contains(refusal("/dev/null"), "not a regular file"));
}

TEST(ReadMesh, RefusesUtf16) {
  const TemporaryFolder folder;
  const std::string text(
      "\xFF\xFE"
      "v\0 \0",
      6);
  EXPECT_TRUE(contains(refusal(folder.write("a.obj", text)), "UTF-16"));
}

TEST(WriteMesh, UnmovedGivesTheSameBytesAndLeavesNothingElseBehind) {
  const TemporaryFolder folder;
  const MeshFile file = read_mesh(folder.write("in.obj", kTriangle));
  write_mesh(file, file.mesh.points(), folder.path() / "out.obj");
  EXPECT_EQ(read_bytes(folder.path() / "out.obj"), kTriangle);
  EXPECT_EQ(folder.count_files(), 2u);
}

TEST(WriteMesh, MayReplaceItsInputMoreThanOnce) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("in.obj", kTriangle);
  const MeshFile file = read_mesh(path);
  std::vector<Vec3> points(file.mesh.points().begin(), file.mesh.points().end());
  points[2] = {0.1, 1.0, 0.0};
  write_mesh(file, points, path);
  points[2] = {0.25, 1.0, 0.0};
  write_mesh(file, points, path);
  EXPECT_EQ(read_bytes(path), "v 0 0 0\nv 1 0 0\nv 0.25 1 0\nf 1 2 3\n");
}

TEST(WriteMesh, LeavesTheOldOutputWhenTheCheckThrows) {
  const TemporaryFolder folder;
  const MeshFile file = read_mesh(folder.write("in.obj", kTriangle));
  const fs::path out = folder.write("out.obj", "old");
  const auto refuse = [](const Mesh&) { throw Error("worse"); };
  EXPECT_THROW(write_mesh(file, file.mesh.points(), out, {}, refuse), Error);
  EXPECT_EQ(read_bytes(out), "old");
  EXPECT_EQ(folder.count_files(), 2u);
}

TEST(WriteMesh, GivesTheCheckTheMeshAsReadBack) {
  const TemporaryFolder folder;
  const MeshFile file = read_mesh(folder.write("in.obj", kTriangle));
  std::vector<Vec3> points(file.mesh.points().begin(), file.mesh.points().end());
  points[0] = {1.0 / 3.0, -1e-300, 5e-324};
  Vec3 seen = Vec3::Zero();
  write_mesh(file, points, folder.path() / "out.obj", {},
             [&](const Mesh& written) { seen = written.points()[0]; });
  EXPECT_EQ(seen, points[0]);
}

TEST(WriteMesh, RefusesAFolderADeviceAndAMissingFolder) {
  const TemporaryFolder folder;
  const MeshFile file = read_mesh(folder.write("in.obj", kTriangle));
  for (const fs::path& out : {folder.path(), fs::path("/dev/null"), folder.path() / "no" / "out"}) {
    EXPECT_THROW(write_mesh(file, file.mesh.points(), out), IoError) << out;
  }
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(folder.count_files(), 1u);
}

TEST(WriteMesh, RefusesWithoutPermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  const MeshFile file = read_mesh(folder.write("in.obj", kTriangle));
  const fs::path out = folder.write("out.obj", "old");
  fs::permissions(out, fs::perms::owner_read);
  EXPECT_THROW(write_mesh(file, file.mesh.points(), out), IoError);
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(write_mesh(file, file.mesh.points(), folder.path() / "new.obj"), IoError);
  fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(WriteMesh, FollowsALink) {
  const TemporaryFolder folder;
  const MeshFile file = read_mesh(folder.write("in.obj", kTriangle));
  const fs::path target = folder.write("target.obj", "old");
  fs::create_symlink(target, folder.path() / "link.obj");
  write_mesh(file, file.mesh.points(), folder.path() / "link.obj");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.obj"));
  EXPECT_EQ(read_bytes(target), kTriangle);
}

TEST(WriteMesh, RefusesToConvert) {
  const TemporaryFolder folder;
  const MeshFile file = read_mesh(folder.write("in.obj", kTriangle));
  EXPECT_THROW(write_mesh(file, file.mesh.points(), folder.path() / "out.stl"), IoError);
}

TEST(WriteMesh, RefusesWhenTheInputChangedMeanwhile) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("in.obj", kTriangle);
  const MeshFile file = read_mesh(path);
  folder.write("in.obj", "v 0 0 0\n");
  EXPECT_THROW(write_mesh(file, file.mesh.points(), folder.path() / "out.obj"), IoError);
  EXPECT_EQ(folder.count_files(), 1u);
}

TEST(WriteMesh, RefusesWhereVerticesOfAnStlFallTogether) {
  const TemporaryFolder folder;
  const MeshFile file = read_mesh(folder.write("in.stl", kStl));
  std::vector<Vec3> points(file.mesh.points().begin(), file.mesh.points().end());
  points[1] = points[0];
  try {
    write_mesh(file, points, folder.path() / "out.stl");
    ADD_FAILURE() << "was written";
  } catch (const IoError& error) {
    EXPECT_TRUE(contains(error.what(), "vertices that are apart would be one")) << error.what();
  }
  EXPECT_EQ(folder.count_files(), 1u);
}

}  // namespace
}  // namespace evenmesh
