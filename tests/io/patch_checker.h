// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/io/only_coordinates.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/places.h"

namespace evenmesh::testing {

/// What tools/check_patch.py says against a file and what became of it. It knows all formats and
/// shares no code with readers and writers.
/// @return  empty if only coordinates differ
inline std::string checker_complaint(const std::filesystem::path& before,
                                     const std::filesystem::path& after) {
  const TemporaryFolder folder;
  const std::filesystem::path said = folder.path() / "said";
  const std::string python =
      std::filesystem::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
  const std::string command = python + " '" + (source_dir() / "tools/check_patch.py").string() +
                              "' '" + before.string() + "' '" + after.string() + "' > '" +
                              said.string() + "' 2>&1";
  return std::system(command.c_str()) == 0 ? std::string() : read_bytes(said);
}

/// What differs beside coordinates: said by only_coordinates.h where it knows the format, which is
/// quick, and else by the checker.
inline std::string difference_of_files(const MeshFile& file, Points points,
                                       const std::filesystem::path& before,
                                       const std::filesystem::path& after) {
  const std::string_view format = file.patch->format();
  const bool quick = format == "obj" || format == "msh" || format.starts_with("stl");
  if (!quick) return checker_complaint(before, after);
  return difference_beside_coordinates(file, points, read_bytes(before), read_bytes(after));
}

}  // namespace evenmesh::testing
