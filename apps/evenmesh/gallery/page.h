// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/evenmesh/gallery/run.h"

namespace evenmesh::gallery {

/// A case with what came out.
struct Exhibit {
  const Case* of = nullptr;
  std::vector<Result> results;
};

/// An exact plate's random starts, by the paper's method.
struct Series {
  std::vector<const Case*> of;
  std::vector<Medians> medians;
};

Exhibit make_exhibit(const Case& of);
/// @pre  the plate is exact
Series make_series(Start start);

/// What is said of one case and its mesh on a terminal: titles, table, lesson.
std::string text_of(const Exhibit& exhibit);
std::string text_of(const Series& series);

/// The whole gallery as a page in Markdown; pictures are expected in pictures/gallery beside it.
/// @param exhibits  of all cases, in the order of cases()
/// @param series    of all exact plates, in the order of plates()
std::string gallery_page(const std::vector<Exhibit>& exhibits, const std::vector<Series>& series);

/// Writes what there is of a case into a folder, which it makes if it is not there: ID.svg,
/// ID_convergence.svg, and the start mesh, named by the figure that shows it, as OBJ.
/// @throws IoError  that is not possible
void write_files(const Exhibit& exhibit, const std::filesystem::path& folder);

/// Writes a file and the folder it lies in.
/// @throws IoError  that is not possible
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace evenmesh::gallery
