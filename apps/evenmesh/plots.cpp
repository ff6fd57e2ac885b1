// SPDX-License-Identifier: MIT
#include "apps/evenmesh/plots.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include <fmt/core.h>
#include <unistd.h>

#include "evenmesh/base/error.h"
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

void check_writable(const fs::path& path) {
  if (::access(path.c_str(), W_OK) == 0) return;
  throw IoError(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
}

// "plots/" is the folder plots, not one without a name in it.
fs::path folder_path(const std::string& folder) {
  const fs::path path = fs::path(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw IoError(path.string() + ": cannot be written");
}

}  // namespace

void check_plot_folder(const std::string& folder, const std::string& input,
                       const std::string& output, const std::string& json) {
  if (folder.empty()) return;
  std::error_code ignored;
  const fs::path path = folder_path(folder);
  if (!fs::exists(path, ignored)) {
    const fs::path around = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(around, ignored)) {
      throw IoError(fmt::format("--plot {}: cannot be made; {} is not a folder that is there",
                                folder, around.string()));
    }
    check_writable(around);
    return;
  }
  if (!fs::is_directory(path, ignored)) {
    throw IoError(fmt::format("--plot {}: is a file; give the name of a folder", folder));
  }
  check_writable(path);
  for (const char* name : {kConvergence, kQuality, kMesh}) {
    const fs::path picture = path / name;
    for (const std::string& other : {input, output, json}) {
      if (!same_file(picture, other)) continue;
      throw InvalidOption(
          fmt::format("--plot {} would overwrite {}; choose another folder", folder, other));
    }
    if (fs::is_directory(picture, ignored)) {
      throw IoError(picture.string() + ": cannot be written; it is a folder");
    }
    if (fs::exists(picture, ignored)) check_writable(picture);
  }
}

void write_plots(const std::string& folder, const Plotted& plotted) {
  const fs::path path = folder_path(folder);
  std::error_code error;
  fs::create_directory(path, error);
  if (error) throw IoError(fmt::format("{}: cannot be made: {}", folder, error.message()));

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
