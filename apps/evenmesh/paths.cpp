// SPDX-License-Identifier: MIT
#include "apps/evenmesh/paths.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fmt/core.h>
#include <unistd.h>

#include "evenmesh/base/error.h"

namespace evenmesh::app {
namespace {

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;  // one that is not there is not the other
  return a == b || std::filesystem::equivalent(a, b, ignored);
}

}  // namespace

std::string output_path(const SmoothArguments& arguments) {
  if (arguments.dry_run && !arguments.json.empty()) {
    throw InvalidOption("--dry-run writes nothing; leave --json out");
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

void check_report_path(const std::string& json, const std::string& input,
                       const std::string& output) {
  if (json.empty() || json == "-") return;
  if (same_file(json, input) || same_file(json, output)) {
    throw InvalidOption(
        fmt::format("--json {} would overwrite the mesh; give it another name", json));
  }
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::path(json).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
    throw IoError(json + ": cannot be written; the folder is not there");
  }
  if (std::filesystem::is_directory(json, ignored)) {
    throw IoError(json + ": is a folder; give the name of a file in it");
  }
  std::filesystem::path target = json;
  if (!std::filesystem::exists(target, ignored)) target = folder.empty() ? "." : folder;
  if (::access(target.c_str(), W_OK) != 0) {
    throw IoError(fmt::format("{}: cannot be written: {}", json, std::strerror(errno)));
  }
}

}  // namespace evenmesh::app
