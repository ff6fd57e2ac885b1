// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/evenmesh/commands.h"

namespace evenmesh::app {

/// Where the result goes; empty for a dry run that names nothing.
/// @throws InvalidOption  it is named nowhere or twice, it is the input without --in-place, or a
///                        dry run is to write a report
std::string output_path(const SmoothArguments& arguments);

/// Finds out before the work whether a report can be written.
/// @param option  that asks for it: "--json"
/// @param path    where it goes; empty: it is not asked for
/// @param meshes  that it must not overwrite
/// @throws InvalidOption  it is one of these
/// @throws IoError        its folder is not there, or it may not be written
void check_report_path(const std::string& option, const std::string& path,
                       const std::vector<std::string>& meshes);

/// The same for one in HTML, which appears complete or not at all: its folder must allow that.
void check_html_path(const std::string& option, const std::string& path,
                     const std::vector<std::string>& meshes);

/// The paths of all reports of a run: those in JSON and HTML must not be the same file.
void check_report_paths(const SmoothArguments& arguments, const std::string& output);

}  // namespace evenmesh::app
