// SPDX-License-Identifier: MIT
#include "apps/evenmesh/plots.h"

#include <filesystem>
#include <vector>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/output_file.h"
#include "evenmesh/plot/convergence.h"
#include "evenmesh/plot/histogram.h"
#include "evenmesh/plot/mesh_picture.h"

namespace evenmesh::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConvergence = "convergence.svg";
constexpr const char* kQuality = "quality.svg";
constexpr const char* kMesh = "mesh.svg";

bool same_file(const fs::path& a, const std::string& b) {
  std::error_code ignored;  // one that is not there is not the other
  return !b.empty() &&
         (a.lexically_normal() == fs::path(b).lexically_normal() || fs::equivalent(a, b, ignored));
}

// "plots/" is the folder plots, not one without a name in it.
fs::path folder_path(const std::string& folder) {
  const fs::path path = fs::path(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

// Complete or not at all.
void write(const fs::path& path, const std::string& text) {
  OutputFile file(path);
  file.append(text);
  file.close();
  file.commit();
}

// True if it was not there before.
bool make_folder(const fs::path& path) {
  std::error_code error;
  const bool made = fs::create_directory(path, error);
  if (error) {
    throw IoError(
        fmt::format("--plot {}: cannot be made a folder: {}", path.string(), error.message()));
  }
  return made;
}

}  // namespace

void check_plot_folder(const std::string& folder, const std::vector<std::string>& others) {
  if (folder.empty()) return;
  const fs::path path = folder_path(folder);
  for (const char* name : {kConvergence, kQuality, kMesh}) {
    for (const std::string& other : others) {
      if (!same_file(path / name, other)) continue;
      throw InvalidOption(
          fmt::format("--plot {} would overwrite {}; choose another folder", folder, other));
    }
  }
  if (make_folder(path)) {
    fs::remove(path);
    return;
  }
  for (const char* name : {kConvergence, kQuality, kMesh}) const OutputFile probe{path / name};
}

void write_plots(const std::string& folder, const Plotted& plotted) {
  const fs::path path = folder_path(folder);
  make_folder(path);

  Workers workers(plotted.threads);
  const Mesh& mesh = plotted.before;
  const CellQuality before = measure_cells(workers, mesh, mesh.points(), plotted.orientation);
  std::vector<HistogramMesh> meshes{{"before", before}};
  std::vector<Panel> panels{{"before", mesh.points()}};
  CellQuality after;
  if (plotted.after != nullptr) {
    after = measure_cells(workers, mesh, plotted.after->points(), plotted.orientation);
    meshes.push_back({"after", after});
    panels.push_back({"after", plotted.after->points()});
  }
  write(path / kConvergence, convergence_plot(plotted.report, {.title = plotted.title}));
  write(path / kQuality, quality_histogram(meshes, {.title = plotted.title}));
  write(path / kMesh, mesh_picture(mesh, plotted.orientation, panels));
}

}  // namespace evenmesh::app
