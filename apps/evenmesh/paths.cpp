// SPDX-License-Identifier: MIT
#include "apps/evenmesh/paths.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fmt/core.h>
#include <unistd.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/output_file.h"

namespace evenmesh::app {
namespace {

// Two names of one file, be it there or not yet.
bool same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (a.empty() || b.empty()) return false;
  if (a == b || fs::equivalent(a, b, ignored)) return true;
  const fs::path whole_a = fs::weakly_canonical(fs::absolute(a, ignored), ignored);
  return !whole_a.empty() && whole_a == fs::weakly_canonical(fs::absolute(b, ignored), ignored);
}

}  // namespace

std::string output_path(const SmoothArguments& arguments) {
  if (arguments.dry_run && !(arguments.json.empty() && arguments.html.path.empty())) {
    throw InvalidOption(fmt::format("--dry-run writes nothing; leave {} out",
                                    arguments.json.empty() ? "--report" : "--json"));
  }
  if (arguments.in_place) {
    if (!arguments.output.empty()) {
      throw InvalidOption("-o and --in-place exclude each other; choose one");
    }
    return arguments.input.path;
  }
  if (arguments.output.empty() && arguments.dry_run) return "";
  if (arguments.output.empty()) {
    throw InvalidOption(
        fmt::format("nowhere to write to; add -o OUT (or look first: evenmesh check {})",
                    arguments.input.path));
  }
  if (same_file(arguments.input.path, arguments.output)) {
    throw InvalidOption(fmt::format(
        "{} is the input itself; use --in-place instead of -o to replace it", arguments.output));
  }
  return arguments.output;
}

void check_report_path(const std::string& option, const std::string& path,
                       const std::vector<std::string>& meshes) {
  if (path.empty()) return;
  for (const std::string& mesh : meshes) {
    if (!same_file(path, mesh)) continue;
    throw InvalidOption(
        fmt::format("{} {} would overwrite the mesh; give it another name", option, path));
  }
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
    throw IoError(path + ": cannot be written; the folder is not there");
  }
  if (std::filesystem::is_directory(path, ignored)) {
    throw IoError(path + ": is a folder; give the name of a file in it");
  }
  std::filesystem::path target = path;
  if (!std::filesystem::exists(target, ignored)) target = folder.empty() ? "." : folder;
  if (::access(target.c_str(), W_OK) != 0) {
    throw IoError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
  }
}

void check_html_path(const std::string& option, const std::string& path,
                     const std::vector<std::string>& meshes) {
  if (path.empty()) return;
  check_report_path(option, path, meshes);
  const OutputFile probe{path};
}

void check_report_paths(const SmoothArguments& arguments, const std::string& output) {
  const std::vector<std::string> meshes{arguments.input.path, output};
  const std::string& json = arguments.json;
  const std::string& html = arguments.html.path;
  if (json != "-") check_report_path("--json", json, meshes);
  check_html_path("--report", html, meshes);
  if (json == "-" || !same_file(html, json)) return;
  throw InvalidOption(fmt::format("--report and --json are both {}; give one another name", html));
}

}  // namespace evenmesh::app
